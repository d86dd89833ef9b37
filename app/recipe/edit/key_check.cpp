#include "app/recipe/edit/key_check.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/base/messages.h"
#include "app/recipe/edit/leaves.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

using Found = std::optional<RecipeProblem>;

/// The value at a dotted path, which must exist.
const Json& place_at(const Json& recipe, const std::string& path) {
    std::string pointer = "/" + path;
    std::ranges::replace(pointer, '.', '/');
    return recipe.at(Json::json_pointer(pointer));
}

void add_stops(const Json& recipe, std::vector<RecipeNumber>& numbers) {
    // The table is static, so the pointer owns nothing.
    const std::shared_ptr<const Parameter> parameter(std::shared_ptr<void>(),
                                                     find_parameter("texture.stops.0.0"));
    for (const std::string& map : color_map_paths(recipe)) {
        const Json& stops = place_at(recipe, map + ".stops");
        for (std::size_t i = 0; i < stops.size(); ++i)
            numbers.push_back(
                {fmt::format("{}.stops.{}.0", map, i), parameter, stops[i][0].get<double>()});
    }
}

void add_leaf(const RecipeLeaf& leaf, std::vector<RecipeNumber>& numbers) {
    const ParameterType type = leaf.parameter->type;
    if (type == ParameterType::number || type == ParameterType::integer)
        numbers.push_back({leaf.path, leaf.parameter, leaf.value.get<double>()});
    if (type != ParameterType::numbers) return;
    for (std::size_t i = 0; i < leaf.value.size(); ++i)
        numbers.push_back(
            {fmt::format("{}.{}", leaf.path, i), leaf.parameter, leaf.value[i].get<double>()});
}

std::optional<RecipeNumber> find_among(const std::vector<RecipeNumber>& numbers,
                                       std::string_view path) {
    const auto found = std::ranges::find(numbers, path, &RecipeNumber::path);
    if (found == numbers.end()) return {};
    return *found;
}

RecipeProblem unknown_number(const std::vector<RecipeNumber>& numbers, const Json& track,
                             const std::string& place) {
    const std::string path = join_path(place, "path");
    std::vector<std::string_view> known;
    for (const RecipeNumber& number : numbers) known.push_back(number.path);
    const std::string_view nearest = nearest_word(track["path"].get<std::string>(), known);
    RecipeProblem problem = mismatch(path, track["path"],
                                     "the path of one number that the recipe has, but none of its "
                                     "atlas, which all frames share");
    if (!nearest.empty()) problem.sentence += fmt::format("; did you mean \"{}\"?", nearest);
    return problem;
}

/// The first problem of a track's keys: times must increase and values lie in the number's range.
Found find_key_problem(const Json& keys, const RecipeNumber& number, const std::string& path) {
    if (keys.empty()) return RecipeProblem{path, path + " is empty, must have at least one key"};
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const std::string key = fmt::format("{}.{}", path, i);
        if (i > 0 && keys[i][0].get<double>() <= keys[i - 1][0].get<double>())
            return mismatch(key + ".0", keys[i][0],
                            fmt::format("later than the key before it, {}", shown(keys[i - 1][0])));
        const double value = keys[i][1].get<double>();
        const Parameter& p = *number.parameter;
        if (value < p.low || value > p.high)
            return mismatch(key + ".1", keys[i][1],
                            fmt::format("from {} to {} as {}", p.low, p.high, number.path));
    }
    return {};
}

Found find_track_problem(const Json& recipe, const std::vector<RecipeNumber>& numbers,
                         std::size_t index) {
    const Json& tracks = recipe["animation"]["tracks"];
    const Json& track = tracks[index];
    const std::string place = fmt::format("animation.tracks.{}", index);
    for (const char* key : {"path", "keys"})
        if (!track.contains(key))
            return RecipeProblem{place, fmt::format("{}.{} is missing", place, key)};
    for (std::size_t i = 0; i < index; ++i)
        if (tracks[i]["path"] == track["path"])
            return mismatch(join_path(place, "path"), track["path"],
                            fmt::format("another one than that of animation.tracks.{}", i));
    const auto number = find_among(numbers, track["path"].get<std::string>());
    if (!number) return unknown_number(numbers, track, place);
    return find_key_problem(track["keys"], *number, join_path(place, "keys"));
}

}  // namespace

std::vector<RecipeNumber> recipe_numbers(const Json& recipe) {
    std::vector<RecipeNumber> numbers;
    for (const RecipeLeaf& leaf : recipe_leaves(recipe))
        if (!leaf.path.starts_with("atlas.")) add_leaf(leaf, numbers);
    add_stops(recipe, numbers);
    return numbers;
}

std::optional<RecipeNumber> find_number(const Json& recipe, std::string_view path) {
    return find_among(recipe_numbers(recipe), path);
}

Found find_animation_problem(const Json& recipe) {
    if (!recipe.contains("animation") || !recipe["animation"].contains("tracks")) return {};
    const std::vector<RecipeNumber> numbers = recipe_numbers(recipe);
    for (std::size_t i = 0; i < recipe["animation"]["tracks"].size(); ++i)
        if (Found found = find_track_problem(recipe, numbers, i)) return found;
    return {};
}

}  // namespace burl
