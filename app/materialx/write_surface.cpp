// Channels are those of glTF 2.0. Its clear coat, sheen, transmission and roughness are the lobes
// of standard_surface (Georgiev et al., Autodesk Standard Surface, 2019): both square the
// roughness, both scale a dielectric's reflection by the specular weight.
#include "app/materialx/write_surface.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/base/version.h"
#include "procedural/color/srgb.h"

namespace burl::materialx {

namespace {

XmlElement value_input(const std::string& name, const std::string& type, const std::string& value) {
    return {"input", {{"name", name}, {"type", type}, {"value", value}}};
}

XmlElement number_input(const std::string& name, double value) {
    return value_input(name, "float", value_text(value));
}

XmlElement color_input(const std::string& name, const Rgb8& color) {
    const Vec3d light = linear_light(color);
    return value_input(
        name, "color3",
        fmt::format("{}, {}, {}", value_text(light.x), value_text(light.y), value_text(light.z)));
}

/// An input that is fed by a node beside it.
XmlElement node_input(const std::string& name, const std::string& type, const std::string& node) {
    return {"input", {{"name", name}, {"type", type}, {"nodename", node}}};
}

/// Writes the graph of a surface's images, and the surface.
class SurfaceWriter {
  public:
    explicit SurfaceWriter(const BakedSurface& baked)
        : baked_(baked), name_(element_name(baked.name)) {}

    XmlElement document() {
        base();
        metal_and_gloss();
        layers();
        emission();
        opacity();
        normals();
        occlusion();
        for (XmlElement& output : outputs_) graph_.add(std::move(output));
        XmlElement root{"materialx", {{"version", "1.38"}, {"colorspace", "lin_rec709"}}};
        graph_.comment =
            fmt::format("Written by Burl {}. The pictures lie beside this file.", burl_version());
        root.add(std::move(graph_));
        root.add(std::move(surface_));
        XmlElement material{"surfacematerial", {{"name", name_}, {"type", "material"}}};
        material.add(node_input("surfaceshader", "surfaceshader", "SR_" + name_));
        root.add(std::move(material));
        return root;
    }

  private:
    const std::string* picture(const std::string& channel) const {
        const auto found = std::ranges::find(baked_.pictures, channel,
                                             &std::pair<std::string, std::string>::first);
        return found == baked_.pictures.end() ? nullptr : &found->second;
    }

    XmlElement& node(const std::string& category, const std::string& name,
                     const std::string& type) {
        return graph_.add({category, {{"name", name}, {"type", type}}});
    }

    /// Adds an image and returns its name.
    std::string image(const std::string& channel, const std::string& type, const std::string& file,
                      bool srgb) {
        const std::string name = channel + "_image";
        XmlElement& image = node("image", name, type);
        XmlElement& input = image.add(value_input("file", "filename", file));
        if (srgb) input.attributes.emplace_back("colorspace", "srgb_texture");
        for (const char* axis : {"uaddressmode", "vaddressmode"})
            image.add(value_input(axis, "string", "clamp"));
        image.add(value_input("filtertype", "string", baked_.closest ? "closest" : "linear"));
        return name;
    }

    void give(const std::string& output, const std::string& type, const std::string& from) {
        outputs_.push_back({"output", {{"name", output}, {"type", type}, {"nodename", from}}});
    }

    void connect(const std::string& input, const std::string& type, const std::string& output) {
        surface_.add(
            {"input",
             {{"name", input}, {"type", type}, {"nodegraph", "NG_" + name_}, {"output", output}}});
    }

    /// The number of a channel: its picture times the number, or the number.
    void number(const std::string& input, const std::string& channel, double value) {
        const std::string* file = picture(channel);
        if (!file) {
            surface_.add(number_input(input, value));
            return;
        }
        give(channel, "float", scaled(image(channel, "float", *file, false), channel, value));
        connect(input, "float", channel);
    }

    std::string scaled(const std::string& from, const std::string& channel, double factor) {
        if (factor == 1.0) return from;
        XmlElement& product = node("multiply", channel + "_scaled", "float");
        product.add(node_input("in1", "float", from));
        product.add(number_input("in2", factor));
        return channel + "_scaled";
    }

    void color(const std::string& input, const std::string& channel, const Rgb8& value) {
        const std::string* file = picture(channel);
        if (!file) {
            surface_.add(color_input(input, value));
            return;
        }
        give(channel, "color3", image(channel, "color3", *file, true));
        connect(input, "color3", channel);
    }

    void base() {
        surface_.add(number_input("base", 1.0));
        if (baked_.has_alpha) {
            const std::string texels = image("base_color", "color4", baked_.color, true);
            node("convert", "base_color_opaque", "color3").add(node_input("in", "color4", texels));
            give("base_color", "color3", "base_color_opaque");
        } else {
            give("base_color", "color3", image("base_color", "color3", baked_.color, true));
        }
        connect("base_color", "color3", "base_color");
    }

    void metal_and_gloss() {
        const Material& m = baked_.material;
        number("metalness", "metallic", m.metallic);
        number("specular", "specular", m.specular);
        number("specular_roughness", "roughness", m.roughness);
        surface_.add(number_input("specular_IOR", m.ior));
    }

    void layers() {
        const Material& m = baked_.material;
        if (picture("clearcoat") || m.clearcoat != 0.0) {
            number("coat", "clearcoat", m.clearcoat);
            number("coat_roughness", "clearcoat_roughness", m.clearcoat_roughness);
        }
        if (picture("sheen") || m.sheen != Rgb8{}) {
            surface_.add(number_input("sheen", 1.0));
            color("sheen_color", "sheen", m.sheen);
            number("sheen_roughness", "sheen_roughness", m.sheen_roughness);
        }
        // What passes a surface of glTF without a volume takes its colour and is not bent.
        if (picture("transmission") || m.transmission != 0.0) {
            number("transmission", "transmission", m.transmission);
            connect("transmission_color", "color3", "base_color");
            surface_.add(value_input("thin_walled", "boolean", "true"));
        }
    }

    void emission() {
        const Material& m = baked_.material;
        if (!picture("emissive") && m.emissive == Rgb8{}) return;
        surface_.add(number_input("emission", m.emissive_strength));
        color("emission_color", "emissive", m.emissive);
    }

    void opacity() {
        if (!baked_.has_alpha) return;
        XmlElement& alpha = node("extract", "alpha", "float");
        alpha.add(node_input("in", "color4", "base_color_image"));
        alpha.add(value_input("index", "integer", "3"));
        std::string share = "alpha";
        if (baked_.alpha_cutoff > 0.0) {
            share = "alpha_cut";
            XmlElement& cut = node("ifgreatereq", share, "float");
            cut.add(node_input("value1", "float", "alpha"));
            cut.add(number_input("value2", baked_.alpha_cutoff));
            cut.add(number_input("in1", 1.0));
            cut.add(number_input("in2", 0.0));
        }
        node("convert", "alpha_color", "color3").add(node_input("in", "float", share));
        give("opacity", "color3", "alpha_color");
        connect("opacity", "color3", "opacity");
    }

    void normals() {
        if (baked_.normals.empty()) return;
        const std::string codes = image("normal", "vector3", baked_.normals, false);
        if (baked_.tangent_space) {
            node("normalmap", "normal_map", "vector3").add(node_input("in", "vector3", codes));
        } else {
            const auto with = [&](const char* category, const char* name, const std::string& from,
                                  const std::string& input, double number) {
                XmlElement& one = node(category, name, "vector3");
                one.add(node_input("in1", "vector3", from));
                one.add(number_input(input, number));
            };
            with("multiply", "normal_doubled", codes, "in2", 2.0);
            with("subtract", "normal_object", "normal_doubled", "in2", 1.0);
            XmlElement& world = node("transformnormal", "normal_map", "vector3");
            world.add(node_input("in", "vector3", "normal_object"));
            world.add(value_input("fromspace", "string", "object"));
            world.add(value_input("tospace", "string", "world"));
        }
        give("normal", "vector3", "normal_map");
        connect("normal", "vector3", "normal");
    }

    /// An output that no input of the surface takes.
    void occlusion() {
        if (const std::string* file = picture("occlusion"))
            give("occlusion", "float", image("occlusion", "float", *file, false));
    }

    const BakedSurface& baked_;
    std::string name_;
    std::vector<XmlElement> outputs_;
    XmlElement graph_{"nodegraph", {{"name", "NG_" + name_}}};
    XmlElement surface_{"standard_surface", {{"name", "SR_" + name_}, {"type", "surfaceshader"}}};
};

}  // namespace

std::string surface_document(const BakedSurface& surface) {
    return xml_text(SurfaceWriter(surface).document());
}

std::string lost_in_document(const BakedSurface& surface) {
    for (const auto& [channel, file] : surface.pictures)
        if (channel == "occlusion")
            return "standard_surface takes no occlusion: the document's output of that name is "
                   "connected to nothing";
    if (surface.material.occlusion == 1.0) return "";
    return fmt::format("standard_surface takes no occlusion: the document leaves out that of {}",
                       surface.material.occlusion);
}

}  // namespace burl::materialx
