#pragma once
// Everything a user decides about the result, as one comparable value: what the command line sets,
// presets hold, tests and benchmarks name and (later) undo steps through. Its JSON is documented
// key by key in docs/reference/recipes.md.
#include <string>
#include <string_view>
#include <vector>

#include "app/recipe/key_track.h"
#include "app/recipe/paint_stroke.h"
#include "atlas/solid/atlas.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/filter.h"
#include "procedural/batch/precision.h"
#include "procedural/graph/bump.h"
#include "procedural/graph/graph.h"

namespace burl {

struct SolidOptions {
    SolidSpace space = SolidSpace::unit;
    double scale = 1.0;
    Vec3d rotate{0.0};     ///< degrees about x, then y, then z
    Vec3d translate{0.0};  ///< texture coordinates = scale * rotated solid coordinates + translate
    bool operator==(const SolidOptions&) const = default;
};

/// Of a mesh that has a pose (atlas/read/pose.h).
struct PoseOptions {
    double weight = 1.0;  ///< 0: at rest, 1: posed
    bool operator==(const PoseOptions&) const = default;
};

struct Recipe {
    std::string name;
    AtlasOptions atlas;
    SolidOptions solid;
    Texture texture;     ///< of the 1999 model, which bakes fastest
    TextureGraph graph;  ///< any other texture; empty: `texture` counts
    Bump bump;
    Filter filter;
    Precision precision;
    std::vector<PaintStroke> paint;  ///< over the texture, in this order
    PoseOptions pose;                ///< what is drawn; the texture is that of the mesh at rest
    KeyedAnimation animation;        ///< app/recipe/keyed_recipe.h: the recipe at a time
    bool operator==(const Recipe&) const = default;
};

/// Map from solid space (unit box or object) to the texture's coordinates s: the recipe's scale.
Affine3 texture_from_solid(const Recipe& recipe);

/// Map from the mesh's coordinates to the texture's coordinates s.
Affine3 texture_from_mesh(const Recipe& recipe, const Mesh& mesh);

/// How many solid units (before the scale) a unit of the mesh is.
double solid_units(const Mesh& mesh, SolidSpace space);

/// Parses recipe JSON; `origin` names it in messages. `settings` are "path=value" edits applied to
/// the JSON first, such as "texture.input.noise.0.amplitude=0.7". Unknown keys, wrong types and
/// values out of range are Error(invalid_file) (usage for `settings`) naming the key and the
/// nearest known one. Images a texture names are read from origin's folder on.
Recipe parse_recipe(const std::string& json, const std::string& origin,
                    const std::vector<std::string>& settings = {});

/// The presets in assets/recipes, in the order of the alphabet.
std::vector<std::string_view> preset_names();

/// Whether a recipe is asked for by a preset's name, known or not: anything with a dot or a slash
/// is a file's path.
bool names_preset(std::string_view path_or_preset);

/// A file's path, or the name of a preset ("marble"; names_preset). A recipe without a name
/// gets its file's, without folder and extension.
Recipe load_recipe(const std::string& path_or_preset,
                   const std::vector<std::string>& settings = {});

/// The recipe with such settings of numbers, all else - its images, paint and keys - being its own.
/// Throws Error(usage).
Recipe with_numbers(const Recipe& recipe, const std::vector<std::string>& settings);

/// JSON that parse_recipe reads back to an equal Recipe.
std::string to_json(const Recipe& recipe);

}  // namespace burl
