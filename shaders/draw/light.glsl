// Light of an environment that a surface sends to the eye, as ambient_shading() of app/light/brdf.h
// works it out on the host: the same steps by the same names. Directions are unit vectors in scene
// space.
uniform samplerCube glossy;       // level k: light over lobes of roughness k / last_level
uniform float last_level;         // of `glossy`
uniform vec3 diffuse[9];          // irradiance / pi in spherical harmonics
uniform sampler2D reflectances;   // app/light/reflectance.h
uniform vec3 sun_direction, sun_light;  // app/light/sun.h
uniform float sun_radius;

// Macros: CLEARCOAT, SHEEN, TRANSMITS: the material has these. SUN: the environment has one, which
// is in neither `glossy` nor `diffuse`.

// A material at one point (ShadedPoint); F0 of a dielectric in place of its refractive index.
struct Point {
    vec3 base;
    float metallic, roughness, occlusion;
    vec3 emissive, f0;
    float specular, clearcoat, clearcoat_roughness;
    vec3 sheen;
    float sheen_roughness, transmission;
};

// What glossy reflection does with white light: once, and more than once.
struct Scattered {
    vec3 once, more;
};

const float coat_f0 = 0.04;

float schlick(float cosine) {
    float m = 1.0 - cosine;
    return m * m * m * m * m;
}

float clamped(float cosine) {
    return clamp(cosine, 1e-4, 1.0);
}

float greatest(vec3 v) {
    return max(max(v.x, v.y), v.z);
}

Scattered scattered(vec3 f0, float f90, vec3 table) {
    vec3 once = table.x * f0 + table.y * f90;
    float lost = 1.0 - (table.x + table.y);
    vec3 mean = f0 + (f90 - f0) / 21.0;
    return Scattered(once, lost * once * mean / (1.0 - lost * mean));
}

vec3 diffuse_light(vec3 n) {
    return max(diffuse[0] + n.y * diffuse[1] + n.z * diffuse[2] + n.x * diffuse[3] +
                   n.x * n.y * diffuse[4] + n.y * n.z * diffuse[5] +
                   (3.0 * n.z * n.z - 1.0) * diffuse[6] + n.x * n.z * diffuse[7] +
                   (n.x * n.x - n.y * n.y) * diffuse[8],
               0.0);
}

vec3 glossy_light(vec3 direction, float roughness) {
    return textureLod(glossy, direction, clamp(roughness, 0.0, 1.0) * last_level).rgb;
}

vec3 reflectance(float cosine, float roughness) {
    return textureLod(reflectances, (0.5 + 63.0 * vec2(cosine, roughness)) / 64.0, 0.0).xyz;
}

// The direction in which a rough surface's lobe is looked up: it leans towards the normal.
vec3 lobe_direction(vec3 normal, vec3 view, float roughness) {
    vec3 mirrored = 2.0 * dot(normal, view) * normal - view;
    float r2 = roughness * roughness;
    return normalize(mix(mirrored, normal, r2 * r2));
}

// The share of a glossy lobe that occlusion leaves.
float glossy_occlusion(float cosine, float occlusion, float roughness) {
    float power = exp2(-16.0 * roughness - 1.0);
    return clamp(pow(cosine + occlusion, power) - 1.0 + occlusion, 0.0, 1.0);
}

// The mean of the density of microfacets over the half vectors of the sun's disc.
float ggx_over_disc(float normal_half, float view_half, float a2) {
    float c2 = normal_half * normal_half, upright = max(normal_half, 0.5);
    float disc2 = sun_radius * sun_radius / (4.0 * view_half * upright * upright * upright);
    float beyond = a2 + (1.0 - c2) / c2 - disc2;
    float root = sqrt(beyond * beyond + 4.0 * a2 * disc2);
    float mean = beyond > 0.0 ? 2.0 * a2 / (root * (root + beyond))
                              : (root - beyond) / (2.0 * root * disc2);
    return mean / (3.14159265 * c2 * c2);
}

// The share of the sun that is above a surface.
float share_above(float cosine) {
    return clamp(0.5 + 0.5 * cosine / sun_radius, 0.0, 1.0);
}

// The sun's irradiance / pi.
vec3 sun_diffuse(vec3 normal) {
    float cosine = dot(normal, sun_direction), risen = max(cosine + sun_radius, 0.0);
    float mean = cosine > sun_radius ? cosine : risen * risen / (4.0 * sun_radius);
    return mean / 3.14159265 * sun_light;
}

// What a glossy lobe sends to the view of the sun's light from this direction.
vec3 sun_glossy(vec3 f0, float f90, float roughness, vec3 normal, vec3 view, vec3 light) {
    float nl = dot(normal, light), slant = dot(normal, view), nv = clamped(slant);
    if (nl <= 0.0) return vec3(0.0);
    vec3 seen = normalize(view + (nv - slant) * normal);  // at least at the horizon
    float alpha = clamp(roughness, 0.03, 1.0) * clamp(roughness, 0.03, 1.0), a2 = alpha * alpha;
    vec3 halfway = normalize(light + seen);
    float vh = max(dot(seen, halfway), 1e-3);
    float masked = nl * sqrt(a2 + (1.0 - a2) * nv * nv) + nv * sqrt(a2 + (1.0 - a2) * nl * nl);
    float lobe = ggx_over_disc(dot(normal, halfway), vh, a2) * 0.5 / masked * nl;
    return lobe * (f0 + (f90 - f0) * schlick(vh)) * sun_light;
}

vec3 coat_light(Point p, vec3 normal, vec3 view, float cosine) {
    vec3 table = reflectance(cosine, p.clearcoat_roughness);
    vec3 light =
        (coat_f0 * table.x + table.y) *
        glossy_light(lobe_direction(normal, view, p.clearcoat_roughness), p.clearcoat_roughness);
    if (SUN)
        light += sun_glossy(vec3(coat_f0), 1.0, p.clearcoat_roughness, normal, view, sun_direction);
    return glossy_occlusion(cosine, p.occlusion, p.clearcoat_roughness) * light;
}

// Light from behind that comes through, were its share 1: the lobe mirrored at the surface.
vec3 through_light(float roughness, vec3 normal, vec3 view, float albedo) {
    vec3 light = glossy_light(-view, roughness);
    if (SUN)
        light += sun_glossy(vec3(1.0), 1.0, roughness, normal, view,
                            reflect(sun_direction, normal)) / albedo;
    return light;
}

// Light from glossy and diffuse reflection, and what comes through; `above` is the share of the sun
// that is above the surface.
vec3 base_light(Point p, vec3 normal, vec3 view, float cosine, vec3 around, float above) {
    vec3 table = reflectance(cosine, p.roughness);
    Scattered plain = scattered(p.f0, p.specular, table), metal = scattered(p.base, 1.0, table);
    vec3 left = (1.0 - p.metallic) * (1.0 - plain.once - plain.more) * p.base;
    float through = TRANSMITS ? p.transmission : 0.0;
    vec3 light = mix(plain.once, metal.once, p.metallic) *
                 glossy_light(lobe_direction(normal, view, p.roughness), p.roughness);
    if (SUN)
        light += above * sun_glossy(mix(p.f0, p.base, p.metallic), mix(p.specular, 1.0, p.metallic),
                                    p.roughness, normal, view, sun_direction);
    light *= glossy_occlusion(cosine, p.occlusion, p.roughness);
    light += (mix(plain.more, metal.more, p.metallic) + (1.0 - through) * left) * around;
    if (TRANSMITS)
        light += through * left * through_light(p.roughness, normal, view, table.x + table.y);
    return light;
}

// All light towards `view`; `coat_normal` is the normal of the clearcoat, which has no bumps.
vec3 ambient_shading(Point p, vec3 normal, vec3 coat_normal, vec3 view) {
    float cosine = clamped(dot(normal, view));
    float above = SUN ? share_above(dot(coat_normal, sun_direction)) : 0.0;
    vec3 around = diffuse_light(normal);
    if (SUN) around += above * sun_diffuse(normal);
    around *= p.occlusion;
    vec3 sum = base_light(p, normal, view, cosine, around, above);
    if (SHEEN) {
        float fibres = reflectance(cosine, p.sheen_roughness).z;
        sum = (1.0 - greatest(p.sheen) * fibres) * sum + fibres * p.sheen * around;
    }
    sum += p.emissive;
    if (CLEARCOAT) {
        float coat_cosine = clamped(dot(coat_normal, view));
        sum *= 1.0 - p.clearcoat * (coat_f0 + (1.0 - coat_f0) * schlick(coat_cosine));
        sum += p.clearcoat * coat_light(p, coat_normal, view, coat_cosine);
    }
    return sum;
}
