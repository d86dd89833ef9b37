#pragma once
// The inputs of `burl bench stability`: textures along lines of texels, at positions, steps, runs
// and parameters for which rounding errors are largest.
#include <array>
#include <random>
#include <string>
#include <vector>

#include "atlas/base/vec.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/model/texture.h"

namespace burl {

/// Random numbers for inputs, identical in every run.
class Chance {
  public:
    explicit Chance(std::uint32_t seed) : random_(seed) {}
    double signed_unit() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }
    Vec3d vector() { return {signed_unit(), signed_unit(), signed_unit()}; }
    std::uint32_t bits() { return std::uint32_t(random_()); }
    template <class T, std::size_t N>
    const T& pick(const std::array<T, N>& all) {
        return all[random_() % N];
    }

  private:
    std::mt19937 random_;
};

/// The extent of the suite: a selection of every group for tests, about a minute for `burl bench
/// stability`, or all cases.
enum class StabilityChoice { thinned, usual, thorough };

/// A texture and the texels where it is evaluated.
struct StabilityCase {
    std::string input;  ///< description for the report
    Texture texture;
    SolidAtlas solid;
    Affine3 map{};  ///< map from the atlas's solid points to the texture
};

/// Cases of one kind.
struct StabilityGroup {
    std::string name;
    std::vector<StabilityCase> cases;
};

/// Returns all groups of field errors.
std::vector<StabilityGroup> stability_groups(StabilityChoice choice);

/// Random recipes with |q| <= 1 and sum |a_k| = 2, near the origin and up to 1e6 cells away.
inline constexpr const char* unit_group_name = "|q| <= 1, sum |a_k| = 2";
StabilityGroup unit_group(StabilityChoice choice);

/// Returns meshes of slivers and of triangles smaller than a texel, in every kind of atlas.
StabilityGroup mesh_group(StabilityChoice choice);

/// Returns octaves for filters, with footprints from 1e-6 to 30 cells, and with colour maps that
/// repeat and that clamp.
StabilityGroup filter_group(StabilityChoice choice);

/// A noise of one kind, fade and feature with its name: four octaves, or one where the noise jumps.
struct NamedTerm {
    std::string name;
    NoiseTerm term;
};
/// Returns noises of every kind, fade and feature.
std::vector<NamedTerm> named_terms();
/// Returns the named terms that a choice uses.
std::vector<NamedTerm> terms_for(StabilityChoice choice);

/// Returns a texture of the noise alone, with a map that is continuous where it repeats.
Texture texture_of(const NoiseTerm& term);

/// A line of texels at start + x step; each line is a row of the atlas.
struct TexelLine {
    Vec3d start{0.0}, step{0.0};
    std::uint32_t count = 1;
};
SolidAtlas atlas_of_lines(const std::vector<TexelLine>& lines);

/// Returns lines of texels that start within a cell of a place, in random directions.
SolidAtlas random_lines(const Vec3d& place, double step, std::uint32_t count, std::size_t lines,
                        std::uint32_t seed);

}  // namespace burl
