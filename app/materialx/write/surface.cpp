#include "app/materialx/write/surface.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/base/version.h"
#include "app/materialx/write/standard.h"
#include "procedural/graph/channel.h"

namespace burl::materialx {

namespace {

/// Writes the graph of a surface's images.
class ImageGraph {
  public:
    ImageGraph(const BakedSurface& baked, const std::string& name)
        : baked_(baked), graph_{"nodegraph", {{"name", "NG_" + name}}} {
        graph_.comment =
            fmt::format("Written by Burl {}. The pictures lie beside this file.", burl_version());
        base_color();
        for (const auto& [channel, file] : baked.pictures) picture(channel, file);
        if (baked.has_alpha) opacity();
        if (!baked.normals.empty()) normals();
        for (XmlElement& output : outputs_) graph_.add(std::move(output));
    }

    XmlElement take() { return std::move(graph_); }
    const std::vector<std::string>& outputs() const { return names_; }

  private:
    XmlElement& node(const std::string& category, const std::string& name,
                     const std::string& type) {
        return graph_.add({category, {{"name", name}, {"type", type}}});
    }

    /// Adds an image and returns its name.
    std::string image(const std::string& channel, const std::string& type, const std::string& file,
                      bool srgb) {
        std::string name = channel + "_image";
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
        names_.push_back(output);
    }

    void base_color() {
        if (!baked_.has_alpha)
            return give("base_color", "color3", image("base_color", "color3", baked_.color, true));
        const std::string texels = image("base_color", "color4", baked_.color, true);
        node("convert", "base_color_opaque", "color3").add(node_input("in", "color4", texels));
        give("base_color", "color3", "base_color_opaque");
    }

    void picture(const std::string& channel, const std::string& file) {
        const bool is_colored =
            channel == to_string(Channel::emissive) || channel == to_string(Channel::sheen);
        const char* type = is_colored ? "color3" : "float";
        give(channel, type, image(channel, type, file, is_colored));
    }

    void opacity() {
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
    }

    void normals() {
        const std::string codes = image("normal", "vector3", baked_.normals, false);
        if (baked_.tangent_space)
            node("normalmap", "normal_map", "vector3").add(node_input("in", "vector3", codes));
        else
            object_normals(codes);
        give("normal", "vector3", "normal_map");
    }

    /// The normals in world space of codes in the object's.
    void object_normals(const std::string& codes) {
        const auto apply = [&](const char* category, const char* name, const std::string& to,
                               double number) {
            XmlElement& one = node(category, name, "vector3");
            one.add(node_input("in1", "vector3", to));
            one.add(number_input("in2", number));
        };
        apply("multiply", "normal_doubled", codes, 2.0);
        apply("subtract", "normal_object", "normal_doubled", 1.0);
        XmlElement& world = node("transformnormal", "normal_map", "vector3");
        world.add(node_input("in", "vector3", "normal_object"));
        world.add(value_input("fromspace", "string", "object"));
        world.add(value_input("tospace", "string", "world"));
    }

    const BakedSurface& baked_;
    XmlElement graph_;
    std::vector<XmlElement> outputs_;
    std::vector<std::string> names_;
};

}  // namespace

SurfaceDocument surface_document(const BakedSurface& baked) {
    const std::string name = element_name(baked.name);
    ImageGraph graph(baked, name);
    const StandardSurface surface{name, baked.material, graph.outputs()};
    XmlElement root{"materialx", {{"version", "1.38"}, {"colorspace", "lin_rec709"}}};
    root.add(graph.take());
    add_standard_surface(root, surface);
    return {xml_text(root), lost_in_surface(surface)};
}

}  // namespace burl::materialx
