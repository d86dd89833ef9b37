// The numbers and pictures of a material at a fragment (app/scene/material.h). This part must
// follow draw/light.glsl, and the definition of lookup(sampler2D).

// Macros, one per picture: HAS_METALLIC_ROUGHNESS, ... : the material has it. ONE_ORM: occlusion is
// in the picture of metallic and roughness.
uniform sampler2D map_metallic_roughness, map_occlusion, map_emissive, map_specular,
    map_specular_color, map_clearcoat, map_clearcoat_roughness, map_sheen, map_sheen_roughness,
    map_transmission;
uniform float metallic, roughness, occlusion_strength, specular, dielectric_f0, clearcoat,
    clearcoat_roughness, sheen_roughness, transmission;
uniform vec3 emissive, specular_color, sheen;

vec4 picture(bool has, sampler2D map) {
    return has ? lookup(map) : vec4(1.0);
}

// The material at the fragment; `base` is its base colour.
Point point_of(vec3 base) {
    Point p;
    vec3 orm = picture(HAS_METALLIC_ROUGHNESS, map_metallic_roughness).rgb;
    float open = ONE_ORM ? orm.r : picture(HAS_OCCLUSION, map_occlusion).r;
    p.base = base;
    p.metallic = clamp(metallic * orm.b, 0.0, 1.0);
    p.roughness = clamp(roughness * orm.g, 0.0, 1.0);
    p.occlusion = mix(1.0, open, occlusion_strength);
    p.emissive = emissive * picture(HAS_EMISSIVE, map_emissive).rgb;
    p.specular = specular * picture(HAS_SPECULAR, map_specular).a;
    vec3 tint = specular_color * picture(HAS_SPECULAR_COLOR, map_specular_color).rgb;
    p.f0 = p.specular * min(dielectric_f0 * tint, vec3(1.0));
    p.clearcoat = clearcoat * picture(HAS_CLEARCOAT, map_clearcoat).r;
    p.clearcoat_roughness =
        clearcoat_roughness * picture(HAS_CLEARCOAT_ROUGHNESS, map_clearcoat_roughness).g;
    p.sheen = sheen * picture(HAS_SHEEN, map_sheen).rgb;
    p.sheen_roughness =
        sheen_roughness * picture(HAS_SHEEN_ROUGHNESS, map_sheen_roughness).a;
    p.transmission = transmission * picture(HAS_TRANSMISSION, map_transmission).r;
    return p;
}
