// Images, which a recipe looks up at linear maps of the texture coordinates or of the point.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "app/materialx/nodes.h"
#include "app/materialx/values/color_space.h"
#include "app/materialx/values/linear_form.h"

namespace burl::materialx {

namespace {

/// An image file as its node names it.
struct ImageFile {
    std::string path, color_space;
};

ImageFile file_of(const NodeCall& call) {
    const Element* holder = call.reader.target(call.node, "file", call.scope).holder;
    if (!holder) return {};
    return {call.reader.inherited(*holder, "fileprefix") + holder->text("value"),
            call.reader.inherited(*holder, "colorspace")};
}

/// The recipe's word for what lies beyond the image; none for other modes.
std::optional<std::string> wrap_of(const NodeCall& call) {
    const auto word = [&](const char* input) -> std::string {
        const std::string mode = call.text(input);
        if (mode.empty() || mode == "periodic") return "repeat";
        if (mode == "clamp") return "clamp";
        return mode == "constant" ? "black" : "";
    };
    const std::string u = word("uaddressmode");
    if (u.empty() || u != word("vaddressmode")) return {};
    return u;
}

/// The two rows of the matrix that moves an image to its place, whose third is 0.
Json matrix_of(const LinearForm& s, const LinearForm& t) {
    const auto of_point = [](const LinearForm& form) {
        return std::array{form.weights[2], form.weights[3], form.weights[4], form.offset};
    };
    // The recipe's v points down, and so do an image's rows.
    const auto of_coordinates = [](const LinearForm& form) {
        return std::array{form.weights[0], -form.weights[1], 0.0, form.offset + form.weights[1]};
    };
    const bool point = s.uses_point() || t.uses_point();
    const auto first = point ? of_point(s) : of_coordinates(s);
    const auto second = point ? of_point(t) : of_coordinates(t);
    Json matrix = Json::array();
    for (const double number : first) matrix.push_back(number);
    for (std::size_t k = 0; k < 4; ++k) matrix.push_back((k == 3 ? 1.0 : 0.0) - second[k]);
    for (int k = 0; k < 4; ++k) matrix.push_back(0);
    return matrix;
}

/// An image at texture coordinates; none, where they are no linear map.
std::optional<NodeRef> image_at(NodeBuilder& nodes, NodeRef image, const LinearForm& s,
                                const LinearForm& t) {
    const bool point = s.uses_point() || t.uses_point();
    if (point && (s.uses_texture_coordinates() || t.uses_texture_coordinates())) return {};
    const NodeRef placed =
        nodes.node("transform", true, {{"input", image}}, {{"matrix", matrix_of(s, t)}});
    return point ? placed : nodes.node("mesh_uv", true, {{"input", placed}});
}

/// The code from 0 to 1 that sRGB has for a number in linear light (IEC 61966-2-1), which is what
/// a file holds of a number that is no colour.
NodeRef code_of(NodeBuilder& nodes, NodeRef light) {
    const auto number = [&](double value) { return nodes.number(value); };
    const NodeRef root = nodes.math("power", {light, number(1.0 / 2.4)});
    const NodeRef curve =
        nodes.math("subtract", {nodes.math("multiply", {root, number(1.055)}), number(0.055)});
    const NodeRef line = nodes.math("multiply", {light, number(12.92)});
    const NodeRef bright = nodes.math("ifgreater", {light, number(0.0031308)});
    return nodes.math("mix", {line, curve, bright});
}

/// The channels of the image that the type has, as colours or as the numbers of the file. They are
/// taken apart, which divides by the alpha that the image may have.
Value channels_of(const NodeCall& call, NodeRef image, bool is_srgb) {
    NodeBuilder& nodes = call.nodes();
    std::vector<NodeRef> parts;
    for (std::size_t k = 0; k < std::min<std::size_t>(size_of(call.type), 3); ++k) {
        const NodeRef light = nodes.channel(image, k);
        parts.push_back(is_srgb ? light : code_of(nodes, light));
    }
    if (size_of(call.type) < 3) return call.values().of_parts(call.type, parts);
    const NodeRef color =
        nodes.node("combine", true, {{"red", parts[0]}, {"green", parts[1]}, {"blue", parts[2]}});
    const NodeRef alpha = nodes.node("split", false, {{"input", image}}, {{"channel", "alpha"}});
    return call.values().of_color(call.type, color, alpha);
}

bool has_extension(const std::string& path, std::string_view extension) {
    if (path.size() < extension.size()) return false;
    for (std::size_t k = 0; k < extension.size(); ++k) {
        const char c = path[path.size() - extension.size() + k];
        if ((c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c) != extension[k]) return false;
    }
    return true;
}

/// Why the file is not read; empty where it is.
std::string problem_of(const NodeCall& call, const ImageFile& file) {
    if (file.path.empty()) return "it names no file";
    if (file.path.find('<') != std::string::npos)
        return "files of several tiles or frames are not read";
    constexpr std::array extensions{".png", ".jpg", ".jpeg", ".webp"};
    if (std::ranges::none_of(
            extensions, [&](const char* extension) { return has_extension(file.path, extension); }))
        return fmt::format("{} is no PNG, JPEG or WebP, and other images are not read", file.path);
    if (is_color(call.type) && file.color_space != "srgb_texture" && !is_linear(file.color_space))
        return fmt::format("images of the colour space {} are not read", file.color_space);
    return "";
}

/// Notes what an image's node asks for and a recipe's image does not do.
void note_lost(const NodeCall& call) {
    const std::string filter = call.text("filtertype");
    if (!filter.empty() && filter != "linear")
        call.reader.lose(fmt::format("{}{}: its filter {} becomes linear", call.scope.path,
                                     call.node.name(), filter));
    for (const char* name : {"layer", "framerange"})
        if (!call.text(name).empty())
            call.reader.lose(
                fmt::format("{}{}: {} is left out", call.scope.path, call.node.name(), name));
}

Value image_value(const NodeCall& call, const Value& texcoord, const std::string& wrap) {
    const ImageFile file = file_of(call);
    if (const std::string problem = problem_of(call, file); !problem.empty())
        return call.refused(problem);
    note_lost(call);
    NodeBuilder& nodes = call.nodes();
    LinearForms forms(nodes);
    const auto s = forms.of(call.values().part(texcoord, 0), 0);
    const auto t = forms.of(call.values().part(texcoord, 1), 0);
    const NodeRef image = nodes.node("image", true, {}, {{"file", file.path}, {"wrap", wrap}});
    const auto placed = s && t ? image_at(nodes, image, *s, *t) : std::nullopt;
    if (!placed)
        return call.refused(
            "its texture coordinates are no linear map of the mesh's, or of the "
            "position");
    return channels_of(call, *placed, is_color(call.type) && file.color_space == "srgb_texture");
}

Value image(const NodeCall& call) {
    const auto wrap = wrap_of(call);
    if (!wrap)
        return call.refused("its address modes are not both periodic, both clamp or both constant");
    return image_value(call, call.geometry("texcoord", "UV0"), *wrap);
}

Value tiled_image(const NodeCall& call) {
    Value at = call.geometry("texcoord", "UV0");
    const auto with = [&](const char* operation, const char* name, double otherwise) {
        at = call.values().apply(operation, Type::vector2,
                                 {at, call.in(name, Type::vector2, otherwise)});
    };
    with("multiply", "uvtiling", 1.0);
    with("subtract", "uvoffset", 0.0);
    with("divide", "realworldimagesize", 1.0);
    with("multiply", "realworldtilesize", 1.0);
    return image_value(call, at, "repeat");
}

}  // namespace

std::span<const NodeRow> image_rows() {
    static constexpr std::array rows{NodeRow{"image", image}, NodeRow{"tiledimage", tiled_image}};
    return rows;
}

}  // namespace burl::materialx
