#include "app/materialx/write/recipe.h"

#include <algorithm>
#include <functional>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/base/json_text.h"
#include "app/base/version.h"
#include "app/materialx/write/standard.h"
#include "app/materialx/write/steps.h"
#include "app/recipe/edit/recipe_json.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "procedural/graph/table.h"

namespace burl::materialx {

namespace {

/// Adds the places of nodes with one of these names, "texture.input" say.
void find_places(const Json& json, const std::string& place,
                 const std::set<std::string, std::less<>>& names, std::vector<std::string>& found) {
    if (json.is_object() && json.contains("node") && json["node"].is_string()) {
        const auto& name = json["node"].get_ref<const std::string&>();
        if (names.contains(name)) found.push_back(fmt::format("{} ({})", place, name));
    }
    if (!json.is_structured()) return;
    for (const auto& item : json.items())
        find_places(item.value(), place.empty() ? item.key() : place + '.' + item.key(), names,
                    found);
}

void check_nodes(const Recipe& recipe) {
    std::set<std::string, std::less<>> names;
    const auto add = [&](const TextureGraph& graph, GraphOutput output) {
        if (graph.empty()) return;
        for (const std::uint32_t node : nodes_without_equivalent(graph, output))
            names.emplace(type_of(graph.nodes[node]).name);
    };
    add(recipe.texture, GraphOutput::planes);
    add(recipe.bump.input, GraphOutput::color);
    if (names.empty()) return;
    std::vector<std::string> places;
    find_places(Json::parse(to_json(recipe)), "", names, places);
    throw Error(
        ExitCode::unsupported,
        fmt::format("{}: MaterialX has no equivalent of {}; bake the material's textures "
                    "instead: burl bake MESH -o NAME.mtlx",
                    recipe.name.empty() ? "the recipe" : recipe.name,
                    fmt::join(places.empty() ? std::vector<std::string>(names.begin(), names.end())
                                             : places,
                              ", ")));
}

/// Writes the graph and the document of a recipe.
class RecipeWriter {
  public:
    RecipeWriter(const Recipe& recipe, const Affine3& solid_from_object)
        : recipe_(recipe), map_(texture_from_solid(recipe).after(solid_from_object)) {}

    RecipeDocument document() {
        const std::string name = element_name(recipe_.name.empty() ? "recipe" : recipe_.name);
        const std::vector<Operand> point = solid_point();
        material(point);
        if (!recipe_.bump.empty()) height(point);
        XmlElement graph{"nodegraph", {{"name", "NG_" + name}}, nodes_.nodes()};
        graph.comment = fmt::format("Written by Burl {}.", burl_version());
        for (XmlElement& output : outputs_) graph.add(std::move(output));
        const StandardSurface surface{name, recipe_.material, names_};
        XmlElement root{"materialx", {{"version", "1.38"}, {"colorspace", "lin_rec709"}}};
        root.add(std::move(graph));
        add_standard_surface(root, surface);
        RecipeDocument result{xml_text(root), notes()};
        if (const std::string lost = lost_in_surface(surface); !lost.empty())
            result.notes.push_back(lost);
        return result;
    }

  private:
    /// The point of solid space at the object's position.
    std::vector<Operand> solid_point() {
        std::vector<Operand> position = components_of(
            nodes_.add("position", "vector3", {value_input("space", "string", "object")}),
            "vector3");
        const Affine3 same;
        if (map_.linear == same.linear && map_.offset == same.offset) return position;
        const Mat3d rows = glm::transpose(map_.linear);
        std::vector<Operand> point;
        for (int i = 0; i < 3; ++i) {
            const Vec3d& row = rows[i];
            int used = -1, count = 0;
            for (int k = 0; k < 3; ++k)
                if (row[k] != 0.0) used = k, ++count;
            if (count == 1)
                point.push_back(
                    nodes_.sum({position[std::size_t(used)]}, {row[used]}, map_.offset[i]));
            else
                point.push_back(nodes_.sum(position, {row.x, row.y, row.z}, map_.offset[i]));
        }
        return point;
    }

    void give(const std::string& name, const std::string& type, const std::string& node) {
        outputs_.push_back({"output", {{"name", name}, {"type", type}, {"nodename", node}}});
        names_.push_back(name);
    }
    void give_color(const std::string& name, const std::vector<Operand>& color) {
        give(name, "color3", nodes_.combined("color3", color));
    }
    void give_number(const std::string& name, const Operand& number) {
        const XmlElement input = nodes_.input("in", number);
        const bool constant = number.is_constant();
        give(name, "float",
             constant ? nodes_.add("constant", "float", {number_input("value", number.constant)})
                      : input.attributes[2].second);
    }
    Operand clamped(const Operand& number) {
        if (number.is_constant()) return {std::clamp(number.constant, 0.0, 1.0)};
        return nodes_.number("clamp", {{"in", number}, {"low", {0.0}}, {"high", {1.0}}});
    }

    void material(const std::vector<Operand>& point) {
        const PlaneLayout layout(recipe_.texture);
        const std::vector<Operand> planes =
            write_graph(recipe_.texture, GraphOutput::planes, point, nodes_);
        base_color(layout, planes);
        for (const GraphChannel& one : recipe_.texture.channels) {
            const std::string name(to_string(one.channel));
            const std::size_t first = *layout.of(one.channel);
            if (one.channel == Channel::opacity) continue;
            if (is_color(one.channel))
                give_color(name, {planes[first], planes[first + 1], planes[first + 2]});
            else
                give_number(name, clamped(planes[first]));
        }
    }

    /// The base colour, without the factor of its alpha, and the opacity.
    void base_color(const PlaneLayout& layout, const std::vector<Operand>& planes) {
        std::vector<Operand> color(planes.begin(), planes.begin() + 3);
        const Material& m = recipe_.material;
        const bool opaque = is_opaque(recipe_.texture, recipe_.texture.result);
        Operand alpha{m.opacity};
        if (!opaque && layout.alpha()) {
            alpha = planes[*layout.alpha()];
            if (m.alpha != AlphaMode::opaque)
                for (Operand& channel : color) channel = unmultiplied(channel, alpha);
            alpha = nodes_.times(alpha, m.opacity);
        }
        give_color("base_color", color);
        if (const auto plane = layout.of(Channel::opacity))
            alpha = alpha.is_constant() ? nodes_.times(planes[*plane], alpha.constant)
                                        : nodes_.binary("multiply", alpha, planes[*plane]);
        if (m.alpha == AlphaMode::opaque || (alpha.is_constant() && alpha.constant >= 1.0)) return;
        alpha = clamped(alpha);
        if (m.alpha == AlphaMode::mask)
            alpha = nodes_.choose("ifgreatereq", alpha, {m.alpha_cutoff}, {1.0}, {0.0});
        give_color("opacity", {alpha, alpha, alpha});
    }

    Operand unmultiplied(const Operand& channel, const Operand& alpha) {
        if (alpha.is_constant())
            return alpha.constant > 0.0 ? nodes_.times(channel, 1.0 / alpha.constant) : Operand{};
        return nodes_.choose("ifgreater", alpha, {0.0}, nodes_.binary("divide", channel, alpha),
                             {0.0});
    }

    /// The rise along the normal in the object's units. The map is a uniform scale with a rotation,
    /// and the recipe's height is one before its scale.
    void height(const std::vector<Operand>& point) {
        const double unit = recipe_.bump.height * recipe_.solid.scale / glm::length(map_.linear[0]);
        const Operand rise =
            write_graph(recipe_.bump.input, GraphOutput::color, point, nodes_).front();
        give_number("height", nodes_.times(rise, unit));
    }

    std::vector<std::string> notes() const {
        std::vector<std::string> all;
        if (recipe_.filter != Filter{})
            all.push_back(
                fmt::format("filter {} is left out: the document gives the colour at a "
                            "point",
                            to_string(recipe_.filter.kind)));
        if (!recipe_.paint.empty()) all.emplace_back("paint is left out");
        if (!recipe_.controls.empty())
            all.emplace_back("controls are left out: the document has their values");
        if (!recipe_.bump.empty())
            all.emplace_back(
                "bumps are a displacement, which programs that draw without one leave out");
        return all;
    }

    const Recipe& recipe_;
    Affine3 map_;
    XmlNodes nodes_;
    std::vector<XmlElement> outputs_;
    std::vector<std::string> names_;
};

}  // namespace

RecipeDocument recipe_document(const Recipe& recipe, const Affine3& solid_from_object) {
    check_nodes(recipe);
    return RecipeWriter(recipe, solid_from_object).document();
}

}  // namespace burl::materialx
