#include "app/recipe/spelling.h"

#include <array>

#include <fmt/format.h>

#include "atlas/base/json.h"
#include "procedural/graph/json.h"

namespace burl {

namespace {

/// A key of "material", and the path of the same in the one spelling.
struct Spelling {
    const char* key;
    std::string written;
    std::string path;
    std::array<const char*, 2> keys;  ///< the parts of `path`; the second may be null
};

const std::array<Spelling, 2>& spellings() {
    static const std::array<Spelling, 2> all{
        Spelling{"base_color", "material.base_color", "texture", {"texture", nullptr}},
        Spelling{"height", "material.height", "bump.input", {"bump", "input"}}};
    return all;
}

bool has(const Json& json, const char* key) {
    return json.is_object() && json.contains(key);
}

bool is_written(const Json& recipe, const Spelling& one) {
    return has(recipe, "material") && has(recipe["material"], one.key);
}

bool is_there(const Json& recipe, const Spelling& one) {
    const auto& [outer, inner] = one.keys;
    return has(recipe, outer) && (!inner || has(recipe[outer], inner));
}

/// Whether the value can be put there: a "bump" must be an object.
bool has_room(const Json& recipe, const Spelling& one) {
    return !one.keys[1] || !recipe.contains(one.keys[0]) || recipe[one.keys[0]].is_object();
}

/// The value as a node: "texture" takes no bare number or colour.
Json as_node(const Spelling& one, Json value) {
    if (one.keys[1] || value.is_object() || is_graph_name(value)) return value;
    return {{"node", "constant"}, {"value", std::move(value)}};
}

/// Whether the path is `front`, or a part of it.
bool lies_at(const std::string& path, const std::string& front) {
    return path.starts_with(front) && (path.size() == front.size() || path[front.size()] == '.');
}

}  // namespace

Json respelled(Json recipe) {
    for (const Spelling& one : spellings()) {
        if (!is_written(recipe, one) || !has_room(recipe, one)) continue;
        Json value = as_node(one, recipe["material"][one.key]);
        recipe["material"].erase(one.key);
        Json& outer = recipe[one.keys[0]];
        (one.keys[1] ? outer[one.keys[1]] : outer) = std::move(value);
    }
    return recipe;
}

Json as_base_color(Json value) {
    return as_node(spellings()[0], std::move(value));
}

std::optional<RecipeProblem> find_spelling_problem(const Json& recipe) {
    for (const Spelling& one : spellings()) {
        if (!is_written(recipe, one)) continue;
        if (!has_room(recipe, one))
            return RecipeProblem{
                one.keys[0],
                fmt::format("{} must be an object, of which {} is a part", one.keys[0], one.path)};
        if (is_there(recipe, one))
            return RecipeProblem{
                one.written,
                fmt::format("{} and {} are the same; give one of them", one.written, one.path)};
    }
    return {};
}

std::string respelled_path(const std::string& path) {
    for (const Spelling& one : spellings())
        if (lies_at(path, one.written)) return one.path + path.substr(one.written.size());
    return path;
}

RecipeProblem as_written(RecipeProblem problem, const Json& written) {
    for (const Spelling& one : spellings()) {
        if (!is_written(written, one) || !lies_at(problem.path, one.path)) continue;
        const std::string path = one.written + problem.path.substr(one.path.size());
        const std::size_t at = problem.sentence.find(problem.path);
        if (at != std::string::npos) problem.sentence.replace(at, problem.path.size(), path);
        problem.path = path;
    }
    return problem;
}

}  // namespace burl
