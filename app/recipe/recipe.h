#pragma once
// Everything a user decides about the result, as one comparable value: the command line sets it,
// presets hold it, tests and benchmarks name it, and undo steps through it. Its JSON
// (recipe_json.h) is documented key by key in docs/reference/recipes.md.
#include <string>
#include <vector>

#include "app/recipe/control.h"
#include "app/recipe/material.h"
#include "app/recipe/paint_stroke.h"
#include "atlas/base/enum_names.h"
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

/// The pose at which a mesh that has one (atlas/read/pose.h) is drawn.
struct PoseOptions {
    double weight = 1.0;  ///< 0: at rest, 1: posed
    bool operator==(const PoseOptions&) const = default;
};

/// The value of a number of the recipe at one time.
struct KeyPoint {
    double seconds = 0.0;  ///< the time, at least 0
    double value = 0.0;
    bool operator==(const KeyPoint&) const = default;
};

/// The interpolation between two keys.
enum class KeyEase {
    linear,
    smooth  ///< smoothstep, 3 x^2 - 2 x^3: at rest in every key
};
template <>
inline constexpr auto enum_names<KeyEase> = enum_words("linear", "smooth");

/// The keys of one number of a recipe.
struct KeyTrack {
    /// The dotted path, such as "texture.input.noise.0.phase.2".
    std::string path{};
    KeyEase ease = KeyEase::linear;
    std::vector<KeyPoint> keys{};  ///< the keys, ascending by distinct times
    bool operator==(const KeyTrack&) const = default;
};

/// Numbers of a recipe keyed over time; app/recipe/edit/keyed_recipe.h evaluates them.
struct KeyedAnimation {
    double seconds = 2.0;  ///< the animation's length
    int rate = 24;         ///< frames per second
    bool loop = false;     ///< the end coincides with the beginning
    std::vector<KeyTrack> tracks{};
    bool operator==(const KeyedAnimation&) const = default;
};

struct Recipe {
    std::string name;
    std::string about;  ///< a description of one sentence
    std::string group;  ///< the kind of material, such as "wood"
    std::vector<RecipeControl> controls;
    AtlasOptions atlas;
    SolidOptions solid;
    TextureGraph texture = plain_graph({});  ///< a plain graph bakes fastest
    Material material;  ///< channels that do not vary; the others are nodes of the texture
    Bump bump;
    Filter filter;
    Precision precision;
    std::vector<PaintStroke> paint;  ///< strokes over the texture, in this order
    PoseOptions pose;          ///< the pose for drawing; the texture is that of the mesh at rest
    KeyedAnimation animation;  ///< keys over time
    bool operator==(const Recipe&) const = default;
};

/// The precision in which graphs of the recipe sum their noise: float64 if it asks for that.
PrecisionKind graph_precision(const Recipe& recipe);

/// The map from solid space (unit box or object) to texture coordinates s.
Affine3 texture_from_solid(const Recipe& recipe);

/// The map from the mesh's coordinates to texture coordinates s.
Affine3 texture_from_mesh(const Recipe& recipe, const Mesh& mesh);

/// The length of a unit of the mesh in solid units, before the recipe's scale.
double solid_units(const Mesh& mesh, SolidSpace space);

}  // namespace burl
