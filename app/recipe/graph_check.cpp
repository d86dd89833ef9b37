#include "app/recipe/graph_check.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "app/base/messages.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "procedural/graph/json.h"
#include "procedural/graph/table.h"
#include "procedural/noise/spec.h"

namespace burl {

namespace {

using Found = std::optional<RecipeProblem>;

/// The first problem of a colour map's stops: there must be at least one, and positions must not
/// descend.
Found check_stops(const Json& map, const std::string& map_path) {
    if (!map.contains("stops")) return {};
    const Json& stops = map["stops"];
    const std::string stops_path = join_path(map_path, "stops");
    if (stops.empty())
        return RecipeProblem{stops_path, stops_path + " is empty, must have at least one stop"};
    for (std::size_t i = 1; i < stops.size(); ++i) {
        if (stops[i][0].get<double>() >= stops[i - 1][0].get<double>()) continue;
        const std::string path = fmt::format("{}.{}.0", stops_path, i);
        return RecipeProblem{
            path, fmt::format("{} is {}, must not be below the stop before it ({})", path,
                              shown(stops[i][0]), shown(stops[i - 1][0]))};
    }
    return {};
}

/// The reason why a noise term cannot have its period, without its path; empty where it can.
std::string period_problem(const Json& term) {
    const auto number = [&term](const char* key, double otherwise) {
        return term.contains(key) ? term[key].get<double>() : otherwise;
    };
    const double lacunarity = number("lacunarity", 2.0);
    const bool simplex = term.value("kind", "value") == "simplex";
    for (const Json& item : term["period"]) {
        const double period = item.get<double>();
        if (period != std::floor(period)) return "must be whole numbers of cells";
        if (period == 0.0) continue;
        if (simplex && std::fmod(period, 3.0) != 0.0) return "must be multiples of 3 for simplex";
        if (lacunarity != std::floor(lacunarity)) return "needs a whole lacunarity";
        if (period * std::pow(lacunarity, number("octaves", 1.0) - 1.0) > double(largest_period))
            return fmt::format("exceeds {} cells in the last octave; use fewer octaves",
                               largest_period);
    }
    return {};
}

/// The reason why a kind of noise cannot have a time, as the end of a sentence; empty where it can.
/// `repeats` tells that the noise has a period along an axis or in time.
std::string time_problem(std::string_view kind, bool repeats) {
    if (kind == "perlin1985") return "but perlin1985 noise has no fourth dimension; use perlin";
    if (kind == "simplex" && repeats)
        return "but simplex noise in four dimensions has no period; use perlin";
    return "";
}

/// The reason why a noise term cannot have a time, without its path; empty where it can.
std::string term_time_problem(const Json& term) {
    const bool still = !term.contains("period") ||
                       std::all_of(term["period"].begin(), term["period"].end(),
                                   [](const Json& cells) { return cells.get<double>() == 0.0; });
    return time_problem(term.value("kind", "value"),
                        !still || term.value("time_period", 0.0) != 0.0);
}

/// The first noise term whose period or time its kind cannot have.
Found check_noise(const Json& field, const std::string& field_path) {
    if (!field.contains("noise")) return {};
    for (std::size_t i = 0; i < field["noise"].size(); ++i) {
        const Json& term = field["noise"][i];
        for (const auto& [key, problem] :
             {std::pair("period", &period_problem), std::pair("time", &term_time_problem)}) {
            if (!term.contains(key)) continue;
            const std::string sentence = problem(term);
            if (sentence.empty()) continue;
            const std::string path = fmt::format("{}.noise.{}.{}", field_path, i, key);
            return RecipeProblem{path,
                                 fmt::format("{} is {}, {}", path, shown(term[key]), sentence)};
        }
    }
    return {};
}

constexpr double largest_constant = 1e9;

bool is_color(const Json& value) {
    if (!value.is_string()) return false;
    const std::string& text = value.get_ref<const std::string&>();
    return (text.size() == 7 || text.size() == 9) && text[0] == '#' &&
           text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
}

bool is_constant_number(const Json& value) {
    return value.is_number() && std::abs(value.get<double>()) <= largest_constant;
}

std::string wanted_text(Wire wanted) {
    return fmt::format("a number from {} to {}{} or a node that gives {}", -largest_constant,
                       largest_constant,
                       wanted == Wire::color ? ", a colour \"#rrggbb\" or \"#rrggbbaa\"" : "",
                       wanted == Wire::color ? "one of them" : "one");
}

RecipeProblem unknown_node(const Json& name, const std::string& path) {
    std::vector<std::string_view> names;
    for (const NodeType& type : graph_table()) names.push_back(type.name);
    const std::string_view nearest =
        name.is_string() ? nearest_word(name.get_ref<const std::string&>(), names) : "";
    return {path, fmt::format("{} is {}, must be a node's name{}", path, shown(name),
                              nearest.empty() ? std::string("; `burl list nodes` names them all")
                                              : fmt::format("; did you mean \"{}\"?", nearest))};
}

/// The path with its middle left out where it has more than 60 characters.
std::string shortened(const std::string& path) {
    if (path.size() <= 60) return path;
    return fmt::format("{}...{}", path.substr(0, 36), path.substr(path.size() - 20));
}

/// Where a node stands: the point at which it is evaluated, and how deep.
struct GraphPlace {
    std::size_t point = 0;  ///< 0: the solid point
    std::size_t depth = 0;
};

/// A checker of one graph. It recurses no deeper than max_graph_depth, however deep the JSON is,
/// and visits a name once at each point, as its nodes are made.
class GraphChecker {
  public:
    /// `define` has the nodes that names stand for.
    explicit GraphChecker(const Json& define) : define_(define) {}

    /// Checks a node or constant that must give `wanted`, and sets `given` to the type that it
    /// gives.
    Found check_input(const Json& value, const std::string& path, Wire wanted,
                      const GraphPlace& place, Wire& given) {
        if (++nodes_ > max_graph_nodes)
            return RecipeProblem{path, fmt::format("{}: the texture has more than {} nodes, "
                                                   "counting constants; draw less",
                                                   shortened(path), max_graph_nodes)};
        if (place.depth >= max_graph_depth)
            return RecipeProblem{path, fmt::format("{}: nodes are nested more than {} deep; use "
                                                   "fewer levels",
                                                   shortened(path), max_graph_depth)};
        given = Wire::number;
        if (is_color(value)) given = Wire::color;
        if (is_graph_name(value)) {
            if (Found found = check_name(value, path, wanted, place, given)) return found;
        } else if (value.is_object()) {
            if (Found found = check_node(value, path, wanted, place, given)) return found;
        } else if (given == Wire::number && !is_constant_number(value)) {
            return mismatch(path, value, wanted_text(wanted));
        }
        if (given == Wire::color && wanted == Wire::number)
            return RecipeProblem{
                path, fmt::format("{} gives a colour, must be {}", path, wanted_text(wanted))};
        return {};
    }

    /// Checks the names that nobody uses, too.
    Found check_names_left() {
        for (const auto& item : define_.items()) {
            Wire given = Wire::number;
            if (Found found = check_definition(item.key(), {0, 1}, given)) return found;
        }
        return {};
    }

  private:
    Found check_name(const Json& value, const std::string& path, Wire wanted,
                     const GraphPlace& place, Wire& given) {
        const std::string& name = value.get_ref<const std::string&>();
        if (!define_.contains(name)) return unknown_name(value, path, wanted);
        if (Found found = check_definition(name, {place.point, place.depth + 1}, given))
            return found;
        if (given == Wire::color && wanted == Wire::number)
            return RecipeProblem{path, fmt::format("{} is {}, which gives a colour, must be {}",
                                                   path, shown(value), wanted_text(wanted))};
        return {};
    }

    RecipeProblem unknown_name(const Json& value, const std::string& path, Wire wanted) const {
        std::vector<std::string_view> names;
        for (const auto& item : define_.items()) names.push_back(item.key());
        if (names.empty()) return mismatch(path, value, wanted_text(wanted));
        const std::string_view nearest = nearest_word(value.get_ref<const std::string&>(), names);
        return {path,
                fmt::format("{} is {}, which \"define\" does not name; {}", path, shown(value),
                            nearest.empty() ? fmt::format("it has {}", fmt::join(names, ", "))
                                            : fmt::format("did you mean \"{}\"?", nearest))};
    }

    /// Checks what a name stands for, once at each point.
    Found check_definition(const std::string& name, const GraphPlace& place, Wire& given) {
        const auto known = given_.find({name, place.point});
        if (known != given_.end()) {
            given = known->second;
            return {};
        }
        const std::string path = "define." + name;
        if (Found found = check_circle(name, path)) return found;
        const Json& value = define_[name];
        if (name.empty() || name[0] == '#' || name.find('.') != std::string::npos)
            return RecipeProblem{path, fmt::format("{}: a name of \"define\" must not be empty, "
                                                   "begin with # or have a dot; rename it",
                                                   path)};
        if (is_graph_name(value))
            return RecipeProblem{path, fmt::format("{} is {}, must be a node, a number or a colour",
                                                   path, shown(value))};
        open_.push_back(name);
        Found found = check_input(value, path, Wire::color, place, given);
        open_.pop_back();
        given_[{name, place.point}] = given;
        return found;
    }

    /// Whether the name is used within its own definition.
    Found check_circle(const std::string& name, const std::string& path) const {
        const auto first = std::ranges::find(open_, name);
        if (first == open_.end()) return {};
        const std::vector<std::string> circle(first, open_.end());
        return RecipeProblem{path, fmt::format("{} is made of itself: {} uses {}; break the circle",
                                               path, fmt::join(circle, " uses "), name)};
    }

    Found check_node(const Json& node, const std::string& path, Wire wanted,
                     const GraphPlace& place, Wire& given) {
        // Only the recipe's texture itself may leave out "node": it is a color_map then.
        if (!node.contains("node") && place.depth > 0)
            return RecipeProblem{path,
                                 fmt::format("{} has no key \"node\" that says what it is", path)};
        const Json name = node.contains("node") ? node["node"] : Json("color_map");
        const NodeType* type =
            name.is_string() ? find_node(name.get_ref<const std::string&>()) : nullptr;
        if (!type) return unknown_node(name, join_path(path, "node"));
        if (type->name == "field") return find_field_problem(node, path);
        if (type->name == "constant") return check_constant(node, path, wanted, place, given);
        if (Found found = check_keys(*type, node, path)) return found;
        if (type->name == "color_map")
            if (Found found = find_map_problem(node, path)) return found;
        return check_inputs(*type, node, path, wanted, place, given);
    }

    Found check_constant(const Json& node, const std::string& path, Wire wanted,
                         const GraphPlace& place, Wire& given) {
        if (Found found = check_names({"node", "value"}, node, path)) return found;
        const std::string value_path = join_path(path, "value");
        if (!node.contains("value"))
            return RecipeProblem{value_path, fmt::format("{} is missing, must be {}", value_path,
                                                         wanted_text(wanted))};
        if (node["value"].is_object() || is_graph_name(node["value"]))
            return mismatch(value_path, node["value"], "a number or a colour");
        return check_input(node["value"], value_path, wanted, place, given);
    }

    static Found check_names(const std::vector<std::string_view>& known, const Json& node,
                             const std::string& path) {
        for (const auto& item : node.items())
            if (std::find(known.begin(), known.end(), item.key()) == known.end())
                return unknown_key(known, item.key(), path);
        return {};
    }

    /// Checks the names of all keys and the values of parameters.
    static Found check_keys(const NodeType& type, const Json& node, const std::string& path) {
        std::vector<std::string_view> known{"node"};
        for (const NodeInput& input : type.inputs()) known.push_back(input.key);
        for (const Parameter& parameter : type.parameters()) known.push_back(parameter.path);
        if (type.name == "color_map") known.insert(known.end(), {"wrap", "stops"});
        if (Found found = check_names(known, node, path)) return found;
        for (const Parameter& parameter : type.parameters()) {
            const std::string key(parameter.path), parameter_path = join_path(path, key);
            if (node.contains(key)) {
                if (node[key].is_null() && parameter.default_value == "null") continue;
                if (Found found = check_leaf(parameter, node[key], parameter_path)) return found;
            } else if (parameter.default_value.empty()) {
                return RecipeProblem{parameter_path, parameter_path + " is missing"};
            }
        }
        if (Found found = check_direction(type, node, path)) return found;
        return check_time(node, path);
    }

    /// Whether the direction of `facing` is one; the keys' values have been checked.
    static Found check_direction(const NodeType& type, const Json& node, const std::string& path) {
        if (type.name != "facing" || !node.contains("direction")) return {};
        const Json& direction = node["direction"];
        if (std::ranges::any_of(direction, [](const Json& x) { return x.get<double>() != 0.0; }))
            return {};
        const std::string at = join_path(path, "direction");
        return RecipeProblem{
            at, fmt::format("{} is {}, must have a number that is not 0", at, shown(direction))};
    }

    /// Whether the node's kind of noise can have a time; the keys' values have been checked.
    static Found check_time(const Json& node, const std::string& path) {
        if (!node.contains("time") || node["time"].is_null()) return {};
        const std::string problem =
            time_problem(node.value("kind", "perlin"), node.value("time_period", 0.0) != 0.0);
        if (problem.empty()) return {};
        const std::string at = join_path(path, "time");
        return RecipeProblem{at, fmt::format("{} is {}, {}", at, shown(node["time"]), problem)};
    }

    Found check_inputs(const NodeType& type, const Json& node, const std::string& path, Wire wanted,
                       const GraphPlace& place, Wire& given) {
        given = type.result == NodeResult::color ? Wire::color : Wire::number;
        const GraphPlace below{type.result == NodeResult::inner ? ++points_ : place.point,
                               place.depth + 1};
        for (const NodeInput& input : type.inputs()) {
            const std::string input_path = join_path(path, input.key);
            if (!node.contains(input.key)) {
                if (!input.fallback.empty() && ++nodes_ <= max_graph_nodes) continue;
                return RecipeProblem{input_path, fmt::format("{} is missing, must be {}",
                                                             input_path, wanted_text(input.wire))};
            }
            // A node that passes its input's type on requires of the input what is required of
            // itself.
            const Wire from = input.sets_wire ? wanted : input.wire;
            Wire got = Wire::number;
            if (Found found =
                    check_input(node[std::string(input.key)], input_path, from, below, got))
                return found;
            if (input.sets_wire && got == Wire::color) given = Wire::color;
        }
        return {};
    }

    const Json& define_;
    std::map<std::pair<std::string, std::size_t>, Wire> given_;  ///< types of names at points
    std::vector<std::string> open_;  ///< names whose definitions are being checked
    std::size_t nodes_ = 0, points_ = 0;
};

}  // namespace

Found find_map_problem(const Json& map, const std::string& path) {
    for (const char* key : {"wrap", "stops"}) {
        if (!map.contains(key)) continue;
        if (Found found = check_value(*recipe_schema().child("texture")->child(key), map[key],
                                      join_path(path, key)))
            return found;
    }
    return check_stops(map, path);
}

Found find_field_problem(const Json& field, const std::string& path) {
    if (Found found = check_value(*recipe_schema().child("texture")->child("input"), field, path))
        return found;
    return check_noise(field, path);
}

Found find_material_problem(const Json& texture, const Json& material, const Json& define) {
    if (!define.is_object()) return mismatch("define", define, "an object of nodes by their names");
    GraphChecker checker(define);
    Wire given = Wire::number;
    if (is_graph(texture))
        if (Found found = checker.check_input(texture, "texture", Wire::color, {}, given))
            return found;
    for (std::size_t i = 0; i < enum_names<Channel>.size(); ++i) {
        const std::string key(enum_names<Channel>[i]);
        if (!material.contains(key) || !is_graph_channel(material[key])) continue;
        const Wire wanted = is_color(Channel(i)) ? Wire::color : Wire::number;
        if (Found found = checker.check_input(material[key], join_path("material", key), wanted,
                                              {0, 1}, given))
            return found;
    }
    return checker.check_names_left();
}

Found find_scalar_problem(const Json& input, const std::string& path, const Json& define) {
    Wire given = Wire::number;
    return GraphChecker(define).check_input(input, path, Wire::number, {0, 1}, given);
}

}  // namespace burl
