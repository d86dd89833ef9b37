#include "app/export/emit_material.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/base/shader_numbers.h"
#include "app/pipeline/material.h"
#include "procedural/color/srgb.h"
#include "procedural/glsl/graph.h"

namespace burl {

namespace {

constexpr const char* material_struct =
    R"(// The surface at a point of solid space. Colours are in linear light, other numbers from 0 to 1;
// names and meaning are those of glTF 2.0 and its material extensions.
struct TextureMaterial {
    vec4 base_color;  // not multiplied by its alpha, of which opacity is a factor
    float metallic;
    float roughness;  // perceptual: the square root of GGX's alpha
    float occlusion;
    vec3 emissive;  // times its strength
    float specular;
    float clearcoat;
    float clearcoat_roughness;
    vec3 sheen;
    float sheen_roughness;
    float transmission;
    float ior;
};
)";

std::string color_text(const Rgb8& color, double factor) {
    const auto light = [&](std::uint8_t code) {
        return shader_number(factor * srgb_decode(double(code) / 255.0));
    };
    return fmt::format("vec3({}, {}, {})", light(color.r), light(color.g), light(color.b));
}

/// Writes the function texture_material.
class MaterialWriter {
  public:
    explicit MaterialWriter(const Recipe& recipe)
        : recipe_(recipe),
          layout_(recipe.texture),
          planes_(has_glsl_planes(recipe.texture)),
          clear_(!is_opaque(recipe.texture, recipe.texture.result)) {}

    std::string text() {
        if (planes_) lines_ += "    TexturePlanes planes = texture_planes(solid);\n";
        lines_ += "    TextureMaterial material;\n";
        base_color();
        for (const Channel channel : {Channel::metallic, Channel::roughness, Channel::occlusion})
            number(channel);
        color(Channel::emissive, recipe_.material.emissive, recipe_.material.emissive_strength);
        for (const Channel channel :
             {Channel::specular, Channel::clearcoat, Channel::clearcoat_roughness})
            number(channel);
        color(Channel::sheen, recipe_.material.sheen, 1.0);
        for (const Channel channel : {Channel::sheen_roughness, Channel::transmission})
            number(channel);
        assign("ior", shader_number(recipe_.material.ior));
        return fmt::format(
            "TextureMaterial texture_material(vec3 solid) {{\n{}    return material;\n}}\n",
            lines_);
    }

  private:
    void assign(std::string_view member, const std::string& expression) {
        lines_ += fmt::format("    material.{} = {};\n", member, expression);
    }

    /// The channel's number from 0 to 1 as an expression.
    std::string share(Channel channel) const {
        return layout_.of(channel) ? fmt::format("clamp(planes.{}, 0.0, 1.0)", to_string(channel))
                                   : shader_number(channel_number(recipe_.material, channel));
    }

    void number(Channel channel) { assign(to_string(channel), share(channel)); }

    void color(Channel channel, const Rgb8& constant, double strength) {
        const std::string_view name = to_string(channel);
        if (!layout_.of(channel)) return assign(name, color_text(constant, strength));
        assign(name, fmt::format("{}planes.{}",
                                 strength == 1.0 ? "" : shader_number(strength) + " * ", name));
    }

    /// The alpha times the opacity as an expression of `cover` and `planes`.
    std::string cover() const {
        const double constant = channel_number(recipe_.material, Channel::opacity);
        std::string opacity =
            layout_.of(Channel::opacity) ? share(Channel::opacity) : shader_number(constant);
        if (!clear_) return opacity;
        return opacity == shader_number(1.0) ? "cover" : "cover * " + opacity;
    }

    /// The alpha's expression where the base colour may be transparent.
    std::string alpha() const {
        const Material& material = recipe_.material;
        if (material.alpha == AlphaMode::mask)
            return fmt::format("{} >= {} ? 1.0 : 0.0", cover(),
                               shader_number(material.alpha_cutoff));
        const bool varies = clear_ || layout_.of(Channel::opacity);
        return varies ? fmt::format("clamp({}, 0.0, 1.0)", cover()) : cover();
    }

    void base_color() {
        const char* light = planes_ ? "planes.base_color.rgb" : "texture_color(solid)";
        if (!is_transparent(recipe_))
            return assign("base_color", fmt::format("vec4({}, 1.0)", light));
        if (!clear_) return assign("base_color", fmt::format("vec4({}, {})", light, alpha()));
        lines_ += "    float cover = planes.base_color.a;\n";
        assign("base_color",
               fmt::format("vec4(cover > 0.0 ? {0} / cover : {0}, {1})", light, alpha()));
    }

    const Recipe& recipe_;
    PlaneLayout layout_;
    bool planes_;
    bool clear_;  ///< whether the base colour's node may be transparent
    std::string lines_;
};

constexpr const char* flat_text = R"(
// The height by which the surface rises: 0, for the recipe has no bumps.
float texture_height(vec3 solid) {
    return 0.0;
}

// The unit normal of the surface: that of the mesh, for the recipe has no bumps.
vec3 texture_normal(vec3 solid, vec3 normal) {
    return normal;
}
)";

constexpr const char* bumps_text = R"(
// The rise in units of the mesh's file where the height's node grows by 1.
const float bump_height = {};

// The height by which the surface rises along its normal, in units of the mesh's file.
float texture_height(vec3 solid) {{
    return bump_height * bump_input(solid).x;
}}

// The unit normal of the surface with its bumps, from the unit normal of the mesh. Both are in the
// mesh's own coordinates (Blinn 1978).
vec3 texture_normal(vec3 solid, vec3 normal) {{
    vec3 gradient = bump_height * (bump_input(solid).yzw * mat3(solid_from_object));
    vec3 along = gradient - dot(gradient, normal) * normal;
    return along == vec3(0.0) || normal == vec3(0.0) ? normal : normalize(normal - along);
}}
)";

/// The bumps' height in units of the mesh. The map is a uniform scale with a rotation, and the
/// recipe's height is one before its scale.
double height_on_mesh(const Recipe& recipe, const Affine3& texture_from_mesh) {
    return recipe.bump.height * recipe.solid.scale / glm::length(texture_from_mesh.linear[0]);
}

}  // namespace

std::string emitted_material(const Recipe& recipe, const Affine3& texture_from_mesh) {
    const std::string material =
        fmt::format("{}\n{}", material_struct, MaterialWriter(recipe).text());
    if (recipe.bump.empty()) return material + flat_text;
    return material + fmt::format(fmt::runtime(bumps_text),
                                  shader_number(height_on_mesh(recipe, texture_from_mesh)));
}

}  // namespace burl
