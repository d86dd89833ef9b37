// Channels are those of glTF 2.0. Its clear coat, sheen, transmission and roughness are the lobes
// of standard_surface (Georgiev et al., Autodesk Standard Surface, 2019): both square the
// roughness, and both scale a dielectric's reflection by the specular weight.
#include "app/materialx/write/standard.h"

#include <algorithm>

#include <fmt/format.h>

#include "procedural/color/srgb.h"

namespace burl::materialx {

namespace {

class StandardWriter {
  public:
    explicit StandardWriter(const StandardSurface& surface) : surface_(surface) {}

    XmlElement element() {
        base();
        layers();
        emission();
        if (varies("opacity")) connect("opacity", "color3", "opacity");
        if (varies("normal")) connect("normal", "vector3", "normal");
        return std::move(element_);
    }

    bool varies(const std::string& channel) const {
        return std::ranges::find(surface_.outputs, channel) != surface_.outputs.end();
    }

    /// An input that an output of the graph feeds.
    XmlElement fed(const std::string& input, const std::string& type,
                   const std::string& output) const {
        return {"input",
                {{"name", input},
                 {"type", type},
                 {"nodegraph", "NG_" + surface_.name},
                 {"output", output}}};
    }

  private:
    void connect(const std::string& input, const std::string& type, const std::string& output) {
        element_.add(fed(input, type, output));
    }

    void number(const std::string& input, const std::string& channel, double value) {
        if (varies(channel))
            connect(input, "float", channel);
        else
            element_.add(number_input(input, value));
    }

    void color(const std::string& input, const std::string& channel, const Rgb8& value) {
        if (varies(channel)) return connect(input, "color3", channel);
        const Vec3d light = linear_light(value);
        element_.add(value_input(input, "color3",
                                 fmt::format("{}, {}, {}", value_text(light.x), value_text(light.y),
                                             value_text(light.z))));
    }

    void base() {
        const Material& m = surface_.material;
        element_.add(number_input("base", 1.0));
        connect("base_color", "color3", "base_color");
        number("metalness", "metallic", m.metallic);
        number("specular", "specular", m.specular);
        number("specular_roughness", "roughness", m.roughness);
        element_.add(number_input("specular_IOR", m.ior));
    }

    void layers() {
        const Material& m = surface_.material;
        if (varies("clearcoat") || m.clearcoat != 0.0) {
            number("coat", "clearcoat", m.clearcoat);
            number("coat_roughness", "clearcoat_roughness", m.clearcoat_roughness);
        }
        if (varies("sheen") || m.sheen != Rgb8{}) {
            element_.add(number_input("sheen", 1.0));
            color("sheen_color", "sheen", m.sheen);
            number("sheen_roughness", "sheen_roughness", m.sheen_roughness);
        }
        if (!varies("transmission") && m.transmission == 0.0) return;
        // What passes a surface of glTF without a volume takes its colour and is not bent.
        number("transmission", "transmission", m.transmission);
        connect("transmission_color", "color3", "base_color");
        element_.add(value_input("thin_walled", "boolean", "true"));
    }

    void emission() {
        const Material& m = surface_.material;
        if (!varies("emissive") && m.emissive == Rgb8{}) return;
        element_.add(number_input("emission", m.emissive_strength));
        color("emission_color", "emissive", m.emissive);
    }

    const StandardSurface& surface_;
    XmlElement element_{"standard_surface",
                        {{"name", "SR_" + surface_.name}, {"type", "surfaceshader"}}};
};

}  // namespace

void add_standard_surface(XmlElement& document, const StandardSurface& surface) {
    StandardWriter writer(surface);
    document.add(writer.element());
    XmlElement material{"surfacematerial", {{"name", surface.name}, {"type", "material"}}};
    material.add(node_input("surfaceshader", "surfaceshader", "SR_" + surface.name));
    if (writer.varies("height")) {
        XmlElement moved{"displacement",
                         {{"name", "DS_" + surface.name}, {"type", "displacementshader"}}};
        moved.add(writer.fed("displacement", "float", "height"));
        document.add(std::move(moved));
        material.add(node_input("displacementshader", "displacementshader", "DS_" + surface.name));
    }
    document.add(std::move(material));
}

std::string lost_in_surface(const StandardSurface& surface) {
    if (StandardWriter(surface).varies("occlusion"))
        return "standard_surface takes no occlusion: the document's output of that name is "
               "connected to nothing";
    if (surface.material.occlusion == 1.0) return "";
    return fmt::format("standard_surface takes no occlusion: the document leaves out that of {}",
                       surface.material.occlusion);
}

}  // namespace burl::materialx
