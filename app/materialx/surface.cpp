#include "app/materialx/surface.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "app/materialx/relief.h"
#include "app/materialx/shader_inputs.h"

namespace burl::materialx {

namespace {

/// The part that both shaders share: layers become the channels of glTF's material.
class SurfaceMaker {
  public:
    explicit SurfaceMaker(const ShaderInputs& inputs)
        : in_(inputs), values_(inputs.values()), nodes_(inputs.values().nodes) {}

    /// The colour under a coat that tints what is below it.
    Value coated(const Value& color, NodeRef coat) const {
        const Value tint =
            mixed(values_.filled(Type::color3, 1.0), in_.color("coat_color", 1.0), coat);
        return values_.apply("multiply", Type::color3, {color, tint});
    }
    Value mixed(const Value& a, const Value& b, NodeRef amount) const {
        return values_.apply("mix", Type::color3, {a, b, values_.number(amount)});
    }
    void set(const std::string& channel, NodeRef ref) {
        surface.channels.emplace_back(channel, ref);
    }
    void set_unless(const std::string& channel, NodeRef ref, double otherwise) {
        if (nodes_.constant(ref) != otherwise) set(channel, ref);
    }
    void set_sheen(std::string_view weight, std::string_view color, std::string_view roughness,
                   double roughness_otherwise) {
        if (in_.is_zero(weight, 0.0)) return;
        set("sheen", values_.packed(in_.weighted(weight, 0.0, color, 1.0)));
        set("sheen_roughness", in_.number(roughness, roughness_otherwise));
    }
    void set_coat(NodeRef coat, double roughness_otherwise) {
        if (nodes_.constant(coat) == 0.0) return;
        set("clearcoat", coat);
        set("clearcoat_roughness", in_.number("coat_roughness", roughness_otherwise));
    }
    /// Light that the surface gives; a constant weight above 1 becomes the recipe's strength.
    void set_emission(std::string_view weight) {
        const NodeRef amount = in_.number(weight, 0.0);
        const auto constant = nodes_.constant(amount);
        if (constant && *constant <= 0.0) return;
        const bool strong = constant && *constant > 1.0;
        if (strong) surface.emissive_strength = std::min(*constant, 1e6);
        set("emissive", values_.packed(strong ? in_.color("emission_color", 1.0)
                                              : in_.weighted(weight, 0.0, "emission_color", 1.0)));
    }
    void set_ior(std::string_view name) {
        const auto given = nodes_.constant(in_.number(name, 1.5));
        if (!given)
            in_.lose(fmt::format("{} varies, which a recipe's ior cannot; it stays 1.5", name));
        else if (*given < 1.0 || *given > 5.0)
            in_.lose(
                fmt::format("{} is {}, a recipe's ior is from 1 to 5; it stays 1.5", name, *given));
        else
            surface.ior = *given;
    }
    /// The base colour with the colours of what is below the surface, as far as light goes there.
    void set_base(Value color, std::string_view subsurface, double subsurface_otherwise,
                  std::string_view transmission, NodeRef coat) {
        if (!in_.is_zero(subsurface, 0.0)) {
            color = mixed(color, in_.color("subsurface_color", subsurface_otherwise),
                          in_.number(subsurface, 0.0));
            in_.lose(fmt::format("{} scatters no light, its colour is mixed into the base colour",
                                 subsurface));
        }
        if (!in_.is_zero(transmission, 0.0)) {
            const NodeRef amount = in_.number(transmission, 0.0);
            color = mixed(color, in_.color("transmission_color", 1.0), amount);
            set("transmission", amount);
        }
        surface.base_color = values_.packed(coated(color, coat));
    }

    Surface surface;

  private:
    const ShaderInputs& in_;
    Arithmetic& values_;
    NodeBuilder& nodes_;
};

constexpr std::array<std::string_view, 22> held_of_standard_surface{"base",
                                                                    "base_color",
                                                                    "metalness",
                                                                    "specular",
                                                                    "specular_roughness",
                                                                    "specular_IOR",
                                                                    "transmission",
                                                                    "transmission_color",
                                                                    "subsurface",
                                                                    "subsurface_color",
                                                                    "sheen",
                                                                    "sheen_color",
                                                                    "sheen_roughness",
                                                                    "coat",
                                                                    "coat_color",
                                                                    "coat_roughness",
                                                                    "coat_affect_color",
                                                                    "coat_affect_roughness",
                                                                    "emission",
                                                                    "emission_color",
                                                                    "opacity",
                                                                    "normal"};
constexpr std::array<std::string_view, 21> held_of_open_pbr{
    "base_weight",        "base_color",       "base_metalness",      "specular_weight",
    "specular_roughness", "specular_ior",     "transmission_weight", "transmission_color",
    "subsurface_weight",  "subsurface_color", "fuzz_weight",         "fuzz_color",
    "fuzz_roughness",     "coat_weight",      "coat_color",          "coat_roughness",
    "emission_luminance", "emission_color",   "geometry_opacity",    "geometry_normal",
    "coat_darkening"};

const std::vector<LostInput>& lost_of_standard_surface() {
    static const std::vector<LostInput> lost{
        {"diffuse_roughness", {0}},
        {"specular_color", {1, 1, 1}},
        {"specular_anisotropy", {0}},
        {"specular_rotation", {0}, "specular_anisotropy"},
        {"transmission_depth", {0}, "transmission"},
        {"transmission_scatter", {0, 0, 0}, "transmission"},
        {"transmission_scatter_anisotropy", {0}, "transmission"},
        {"transmission_dispersion", {0}, "transmission"},
        {"transmission_extra_roughness", {0}, "transmission"},
        {"subsurface_radius", {}, "subsurface"},
        {"subsurface_scale", {}, "subsurface"},
        {"subsurface_anisotropy", {0}, "subsurface"},
        {"coat_anisotropy", {0}, "coat"},
        {"coat_rotation", {0}, "coat_anisotropy"},
        {"coat_IOR", {1.5}, "coat"},
        {"coat_normal", {}, "coat"},
        {"thin_film_thickness", {0}},
        {"thin_film_IOR", {1.5}, "thin_film_thickness"},
        {"thin_walled", {0}},
        {"tangent", {}, "specular_anisotropy"}};
    return lost;
}

const std::vector<LostInput>& lost_of_open_pbr() {
    static const std::vector<LostInput> lost{
        {"base_diffuse_roughness", {0}},
        {"specular_color", {1, 1, 1}},
        {"specular_roughness_anisotropy", {0}},
        {"transmission_depth", {0}, "transmission_weight"},
        {"transmission_scatter", {0, 0, 0}, "transmission_weight"},
        {"transmission_scatter_anisotropy", {0}, "transmission_weight"},
        {"transmission_dispersion_scale", {0}, "transmission_weight"},
        {"transmission_dispersion_abbe_number", {20}, "transmission_dispersion_scale"},
        {"subsurface_radius", {}, "subsurface_weight"},
        {"subsurface_radius_scale", {}, "subsurface_weight"},
        {"subsurface_scatter_anisotropy", {0}, "subsurface_weight"},
        {"coat_roughness_anisotropy", {0}, "coat_weight"},
        {"coat_ior", {}, "coat_weight"},
        {"thin_film_weight", {0}},
        {"thin_film_thickness", {0.5}, "thin_film_weight"},
        {"thin_film_ior", {1.4}, "thin_film_weight"},
        {"geometry_thin_walled", {0}},
        {"geometry_coat_normal", {}, "coat_weight"},
        {"geometry_tangent", {}, "specular_roughness_anisotropy"},
        {"geometry_coat_tangent", {}, "coat_roughness_anisotropy"}};
    return lost;
}

/// Roughness below a coat that roughens it: it goes to 1 with the coat's.
NodeRef affected_roughness(const ShaderInputs& in) {
    NodeBuilder& nodes = in.values().nodes;
    const NodeRef amount = nodes.math(
        "multiply",
        {nodes.math("multiply", {in.number("coat_affect_roughness", 0.0), in.number("coat", 0.0)}),
         in.number("coat_roughness", 0.1)});
    return nodes.math("mix", {in.number("specular_roughness", 0.2), nodes.number(1.0), amount});
}

/// The base colour below a coat that saturates it, to the power 1 + coat * coat_affect_color.
Value affected_color(const ShaderInputs& in, const Value& color) {
    NodeBuilder& nodes = in.values().nodes;
    const NodeRef more =
        nodes.math("multiply", {in.number("coat", 0.0), in.number("coat_affect_color", 0.0)});
    const NodeRef exponent = nodes.math("add", {more, nodes.number(1.0)});
    return in.values().apply("power", Type::color3, {color, in.values().number(exponent)});
}

/// The luminance of the opacity's colour, which MaterialX's own shaders use, too.
NodeRef opacity_of(const ShaderInputs& in) {
    Arithmetic& values = in.values();
    const Value opacity = in.color("opacity", 1.0);
    const NodeRef packed = values.packed(opacity);
    if (!values.nodes.is_color(packed)) return packed;
    in.lose("a recipe's opacity has no colour; the luminance counts");
    const Value weights = values.constant(Type::color3, {0.2722287, 0.6740818, 0.0536895});
    return values.nodes.channel(
        values.nodes.vector_math("luminance", {packed, values.packed(weights)}), 0);
}

Surface standard_surface(const ShaderInputs& in, const Target& displacement) {
    Arithmetic& values = in.values();
    SurfaceMaker maker(in);
    const bool old = in.shader().node->text("version") == "1.0.0";
    const NodeRef coat = in.number("coat", 0.0);
    const Value color = values.apply("multiply", Type::color3,
                                     {affected_color(in, in.color("base_color", old ? 1.0 : 0.8)),
                                      values.number(in.number("base", old ? 0.8 : 1.0))});
    maker.set_base(color, "subsurface", 1.0, "transmission", coat);
    maker.set_unless("metallic", in.number("metalness", 0.0), 0.0);
    maker.set("roughness", affected_roughness(in));
    maker.set_unless("specular", in.number("specular", 1.0), 1.0);
    maker.set_coat(coat, 0.1);
    maker.set_sheen("sheen", "sheen_color", "sheen_roughness", 0.3);
    maker.set_emission("emission");
    maker.set_ior("specular_IOR");
    maker.set_unless("opacity", opacity_of(in), 1.0);
    in.note_lost(lost_of_standard_surface(), held_of_standard_surface);
    maker.surface.height = read_height(in, "normal", displacement);
    return maker.surface;
}

/// Roughness below a rough coat, by OpenPBR's sum of variances.
NodeRef roughened(const ShaderInputs& in, NodeRef coat) {
    NodeBuilder& nodes = in.values().nodes;
    const NodeRef own = in.number("specular_roughness", 0.3);
    const auto fourth = [&](NodeRef x) { return nodes.math("power", {x, nodes.number(4.0)}); };
    const NodeRef of_coat =
        nodes.math("multiply", {nodes.number(2.0), fourth(in.number("coat_roughness", 0.0))});
    const NodeRef sum =
        nodes.math("min", {nodes.number(1.0), nodes.math("add", {of_coat, fourth(own)})});
    return nodes.math("mix", {own, nodes.math("power", {sum, nodes.number(0.25)}), coat});
}

Surface open_pbr_surface(const ShaderInputs& in, const Target& displacement) {
    SurfaceMaker maker(in);
    const NodeRef coat = in.number("coat_weight", 0.0);
    maker.set_base(in.weighted("base_weight", 1.0, "base_color", 0.8), "subsurface_weight", 0.8,
                   "transmission_weight", coat);
    maker.set_unless("metallic", in.number("base_metalness", 0.0), 0.0);
    maker.set("roughness", in.is_zero("coat_weight", 0.0) || in.is_zero("coat_roughness", 0.0)
                               ? in.number("specular_roughness", 0.3)
                               : roughened(in, coat));
    maker.set_unless("specular", in.number("specular_weight", 1.0), 1.0);
    maker.set_coat(coat, 0.0);
    maker.set_sheen("fuzz_weight", "fuzz_color", "fuzz_roughness", 0.5);
    maker.set_emission("emission_luminance");
    maker.set_ior("specular_ior");
    maker.set_unless("opacity", in.number("geometry_opacity", 1.0), 1.0);
    if (!in.is_zero("coat_weight", 0.0) && !in.is_zero("coat_darkening", 1.0))
        in.lose("the coat does not darken what is below it (coat_darkening)");
    in.note_lost(lost_of_open_pbr(), held_of_open_pbr);
    maker.surface.height = read_height(in, "geometry_normal", displacement);
    return maker.surface;
}

}  // namespace

Surface read_surface(Reader& reader, const Target& shader, const Target& displacement) {
    const ShaderInputs inputs(reader, shader);
    if (shader.node->tag == "standard_surface") return standard_surface(inputs, displacement);
    if (shader.node->tag == "open_pbr_surface") return open_pbr_surface(inputs, displacement);
    reader.refused(*shader.node, Type::number, *shader.scope,
                   fmt::format("the surface {} is not read; standard_surface and "
                               "open_pbr_surface are",
                               shader.node->tag));
    return {reader.nodes.number(0.0)};
}

}  // namespace burl::materialx
