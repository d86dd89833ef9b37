#pragma once
// The inputs of `burl bench stability`: textures along lines of texels, at the places, steps, runs
// and parameters where rounding has the most room.
#include <string>
#include <vector>

#include "atlas/solid/solid_atlas.h"
#include "procedural/model/texture.h"

namespace burl {

/// How much of the suite: a choice of every group for tests, what `burl bench stability` takes a
/// minute for, or all of it.
enum class StabilityChoice { thinned, usual, thorough };

struct StabilityCase {
    std::string input;  ///< what it is, for the report
    Texture texture;
    SolidAtlas solid;
    Affine3 map{};  ///< from the atlas to the texture
};

struct StabilityGroup {
    std::string name;
    std::vector<StabilityCase> cases;
};

std::vector<StabilityGroup> stability_groups(StabilityChoice choice);

/// Recipes at random with |q| <= 1 and sum |a_k| = 2, near the origin and up to 1e6 cells away.
inline constexpr const char* unit_group_name = "|q| <= 1, sum |a_k| = 2";
StabilityGroup unit_group(StabilityChoice choice);

/// Meshes of slivers and of triangles below a texel, in every atlas.
StabilityGroup mesh_group(StabilityChoice choice);

/// Octaves whose slopes a filter needs, at footprints from 1e-6 to 30 cells, with maps that repeat
/// and that end.
StabilityGroup filter_group(StabilityChoice choice);

/// A noise of every kind, fade and feature, by name; four octaves, or one where the noise jumps.
struct NamedTerm {
    std::string name;
    NoiseTerm term;
};
std::vector<NamedTerm> named_terms();
/// Those that a choice looks at.
std::vector<NamedTerm> terms_for(StabilityChoice choice);

/// The noise alone, with a map that is continuous where it repeats.
Texture texture_of(const NoiseTerm& term);

/// Texels along lines, a row each: start + x step.
struct TexelLine {
    Vec3d start{0.0}, step{0.0};
    std::uint32_t count = 1;
};
SolidAtlas atlas_of_lines(const std::vector<TexelLine>& lines);

/// Lines of texels within a cell of a place, in random directions.
SolidAtlas random_lines(const Vec3d& place, double step, std::uint32_t count, std::size_t lines,
                        std::uint32_t seed);

}  // namespace burl
