#pragma once
// The inputs of `burl bench stability`: textures along lines of texels, at the places, steps, runs
// and parameters where rounding has the most room.
#include <string>
#include <vector>

#include "atlas/solid_atlas.h"
#include "procedural/texture.h"

namespace burl {

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

/// `full`: all of them, some 10 s and, for the run of 16,384 texels, 1 GB; otherwise a thinned
/// choice of every group, for tests.
std::vector<StabilityGroup> stability_groups(bool full);

/// Meshes of slivers and of triangles below a texel, in every atlas.
StabilityGroup mesh_group(bool full);

/// Texels along lines, a row each: start + x step.
struct TexelLine {
    Vec3d start{0.0}, step{0.0};
    std::uint32_t count = 1;
};
SolidAtlas atlas_of_lines(const std::vector<TexelLine>& lines);

}  // namespace burl
