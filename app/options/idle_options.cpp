#include "app/options/idle_options.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/pipeline/fill_texture.h"
#include "app/recipe/parameters.h"
#include "atlas/base/error.h"
#include "procedural/field/octave_groups.h"
#include "procedural/model/octaves.h"

namespace burl {

namespace {

bool lies_in(std::string_view path, std::string_view key) {
    return path.starts_with(key) && (path.size() == key.size() || path[key.size()] == '.');
}

std::string_view path_of_move(std::string_view move) {
    return move.substr(0, move.find('='));
}

/// Whether the octave's noise is on a cubic lattice with a vectorised kernel, so that cells can be
/// shared and scanned.
bool on_lattice(const Octave& octave) {
    return has_kernel(octave) && octave.noise.kind != NoiseKind::simplex;
}

}  // namespace

std::string idle_reason(const Recipe& recipe, std::string_view path) {
    const RecipeParameter* parameter = find_parameter(path);
    return parameter && parameter->use.idle ? parameter->use.idle(recipe) : "";
}

std::string idle_kernel(const Recipe& recipe, Kernel kernel) {
    if (kernel == Kernel::automatic) return "";
    const Texture* texture = plain_texture(recipe.texture);
    if (!texture)
        return "the texture has other nodes than a color_map over a field, or transparent stops, "
               "and its noise has one way";
    if (!has_fast_way(recipe, {})) return "only --precision float32 has it";
    if (std::ranges::none_of(expand_octaves(*texture), on_lattice))
        return "only value and perlin noise without a period, time or turbulence has it";
    const FilterKind filter = recipe.filter.kind;
    const bool slopes = filter != FilterKind::none && filter != FilterKind::supersample;
    if (kernel == Kernel::scanline && slopes) return "filters take slopes, which it does not have";
    return "";
}

void check_edits(const RecipeOptions& options, const Recipe& recipe,
                 std::span<const std::string> moves) {
    const auto check = [&](std::string_view path, const std::string& said) {
        if (const std::string why = idle_reason(recipe, path); !why.empty())
            throw Error(ExitCode::usage, fmt::format("{} does nothing: {}", said, why));
    };
    for (const RecipeEdit& edit : options.edits()) check(edit.path, edit.said);
    for (const std::string& move : moves) check(path_of_move(move), "--animate " + move);
}

void refuse_edits(const RecipeOptions& options, std::span<const IdleKey> keys,
                  std::span<const std::string> moves) {
    const auto check = [&](std::string_view path, const std::string& said) {
        for (const auto& [key, why] : keys)
            if (lies_in(path, key))
                throw Error(ExitCode::usage,
                            fmt::format("{} does nothing: {}; leave it out", said, why));
    };
    for (const RecipeEdit& edit : options.edits())
        if (edit.said.starts_with("--set")) check(edit.path, edit.said);
    for (const std::string& move : moves) check(path_of_move(move), "--animate " + move);
}

}  // namespace burl
