#pragma once
// What files may ask of the machine and of each other, for whoever runs Burl on files from others.
#include <cstdint>
#include <string>

namespace CLI {
class App;
}

namespace burl {

struct MeshOptions;
struct RecipeOptions;

/// Adds --allow-outside, --max-triangles, --max-image, --max-noises and --max-memory. No output
/// depends on them: they decide what is refused.
void add_input_limits(CLI::App& verb, MeshOptions& meshes, RecipeOptions& recipe);

/// Gives the command `to` what `from` was told by the options of add_input_limits(); images that
/// both share stay shared.
void copy_input_limits(const MeshOptions& from, const RecipeOptions& recipe_from, MeshOptions& to,
                       RecipeOptions& recipe_to);

/// Throws Error(unsupported) where `noises` (app/recipe/recipe_cost.h), which making `what` takes,
/// are more than --max-noises: it says how long that would run, and what to do.
void check_noises(const std::string& what, double noises, const RecipeOptions& recipe);

/// The bytes of a text such as "4G", "512M" or "65536K"; a number alone is megabytes. Throws
/// Error(usage) for anything else, naming the option.
std::uint64_t memory_size(const std::string& option, const std::string& text);

}  // namespace burl
