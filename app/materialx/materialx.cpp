#include "app/materialx/materialx.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/base/messages.h"
#include "app/materialx/surface.h"

namespace burl {

namespace {

using namespace materialx;

constexpr std::string_view extension = ".mtlx";

/// A material of a document: a `surfacematerial`, or a surface shader that none uses.
using Materials = std::vector<const Element*>;

bool is_shader(const Element& element) {
    return element.text("type") == "surfaceshader";
}

/// The materials of a document; where it has none, its surface shaders.
Materials materials_of(const Document& document) {
    Materials materials, shaders;
    for (const Element& one : document.root.children) {
        if (one.tag == "surfacematerial") materials.push_back(&one);
        if (is_shader(one)) shaders.push_back(&one);
    }
    return materials.empty() ? shaders : materials;
}

/// The material that the path names.
const Element& chosen_material(const Document& document, const MaterialXPath& path) {
    const Materials materials = materials_of(document);
    if (materials.empty())
        throw document.error(document.root, "there is no surfacematerial and no surface shader");
    if (path.material.empty() && materials.size() == 1) return *materials.front();
    std::vector<std::string> names;
    for (const Element* one : materials) {
        names.push_back(one->name());
        if (one->name() == path.material) return *one;
    }
    const std::string choice =
        fmt::format("{}#NAME, NAME being {}", path.file, fmt::join(names, ", "));
    throw Error(ExitCode::usage,
                path.material.empty()
                    ? fmt::format("{}: the document has {} materials; choose one by {}", path.file,
                                  names.size(), choice)
                    : fmt::format("{}: there is no material \"{}\"; choose one by {}", path.file,
                                  path.material, choice));
}

/// The shader of a material, which may be the material itself.
Target shader_of(Reader& reader, const Element& material) {
    if (is_shader(material)) return {&material, nullptr, "", &reader.root()};
    Target shader = reader.target(material, "surfaceshader", reader.root());
    if (!shader.node)
        throw reader.document().error(material, fmt::format("the material \"{}\" has no surface "
                                                            "shader",
                                                            material.name()));
    return shader;
}

/// A channel's value as a recipe's material spells it: a number in its range, or a node.
Json channel_json(const NodeBuilder& nodes, const NodeWriter& writer, NodeRef ref, bool color) {
    const auto constant = nodes.constant(ref);
    if (!constant) return writer.write(ref);
    if (!color) return std::clamp(*constant, 0.0, 1.0);
    return {{"node", "constant"}, {"value", *constant}};
}

Json material_json(const NodeBuilder& nodes, const NodeWriter& writer, const Surface& surface) {
    Json json = Json::object();
    for (const auto& [channel, ref] : surface.channels)
        json[channel] =
            channel_json(nodes, writer, ref, channel == "emissive" || channel == "sheen");
    if (surface.ior != 1.5) json["ior"] = surface.ior;
    if (surface.emissive_strength != 1.0) json["emissive_strength"] = surface.emissive_strength;
    return json;
}

Json recipe_json(const NodeBuilder& nodes, const Surface& surface, const std::string& name) {
    std::vector<NodeRef> roots{surface.base_color};
    for (const auto& [channel, ref] : surface.channels) roots.push_back(ref);
    if (surface.height) roots.push_back(*surface.height);
    const NodeWriter writer(nodes, roots);
    Json json{{"burl", 1}, {"name", name}, {"solid", {{"space", "object"}}}};
    if (Json names = writer.names(); !names.empty()) json["define"] = std::move(names);
    json["texture"] = channel_json(nodes, writer, surface.base_color, true);
    json["material"] = material_json(nodes, writer, surface);
    if (surface.height && nodes.constant(*surface.height) == std::nullopt)
        json["bump"] = {{"height", 1}, {"input", writer.write(*surface.height)}};
    return json;
}

/// Throws Error(unsupported) with all that was not read.
void check_refusals(const Reader& reader) {
    const std::vector<std::string>& all = reader.refusals();
    if (all.empty()) return;
    throw Error(ExitCode::unsupported,
                fmt::format("{}: Burl does not read {} of its nodes: {}", reader.document().path,
                            all.size(), fmt::join(all, "; ")));
}

}  // namespace

bool names_materialx(std::string_view path) {
    return path.substr(0, path.find('#', path.find(extension))).ends_with(extension);
}

MaterialXPath materialx_path(const std::string& path) {
    if (!names_materialx(path)) return {path, ""};
    const std::size_t end = path.find('#', path.find(extension));
    if (end == std::string::npos) return {path, ""};
    return {path.substr(0, end), path.substr(end + 1)};
}

MaterialXRecipe recipe_of_materialx(const std::string& text, const std::string& path) {
    const MaterialXPath parts = materialx_path(path);
    const Document document = parse_document(text, parts.file);
    Reader reader(document);
    const Element& material = chosen_material(document, parts);
    const Target shader = shader_of(reader, material);
    const Target displacement = reader.target(material, "displacementshader", reader.root());
    const Surface surface = read_surface(reader, shader, displacement);
    check_refusals(reader);
    MaterialXRecipe recipe{print_json(recipe_json(reader.nodes, surface, material.name())), {}};
    for (const std::string& loss : reader.losses())
        recipe.losses.push_back(fmt::format("{}: {}", parts.file, loss));
    return recipe;
}

}  // namespace burl
