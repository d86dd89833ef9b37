#include "app/recipe/lattice_check.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/base/mapped_box.h"
#include "app/recipe/graph_lattice.h"
#include "atlas/base/error.h"
#include "procedural/model/octaves.h"

namespace burl {

namespace {

/// The largest absolute lattice coordinate where absolute texture coordinates are at most `sizes`;
/// infinite where it is not a number.
double farthest(const Octave& octave, const Vec3d& sizes) {
    double result = 0.0;
    for (int row = 0; row < 3; ++row) {
        double sum = std::abs(octave.lattice_from_solid.offset[row]);
        for (int column = 0; column < 3; ++column)
            sum += std::abs(octave.lattice_from_solid.linear[column][row]) * sizes[column];
        if (std::isnan(sum)) return HUGE_VAL;
        result = std::max(result, sum);
    }
    return result;
}

}  // namespace

LatticeReach farthest_lattice(const Texture& texture, const Vec3d& sizes) {
    LatticeReach result;
    for (std::size_t i = 0; i < texture.noise.size(); ++i) {
        Texture one;
        one.noise = {texture.noise[i]};
        for (const Octave& octave : expand_octaves(one)) {
            const double far = farthest(octave, sizes);
            if (!(far > result.reach)) continue;
            result = {far, i, octave.noise.seed - one.noise[0].seed};
            if (far > farthest_cell) return result;
        }
    }
    return result;
}

std::string too_far(double cells) {
    return fmt::format(
        "reaches {:.2g} lattice cells from the origin, and beyond 2^46 (7e13) cells too little of "
        "a place within its cell is left; use fewer octaves, a smaller lacunarity or frequency, or "
        "a smaller solid.scale",
        cells);
}

void check_lattice(const Recipe& recipe, const Box3& box) {
    const Vec3d sizes = glm::max(glm::abs(box.low), glm::abs(box.high));
    const Texture* texture = plain_texture(recipe.texture);
    if (!texture) check_graph_lattice(recipe.texture, sizes, "texture");
    check_graph_lattice(recipe.bump.input, sizes, "bump.input");
    if (!texture) return;
    const LatticeReach far = farthest_lattice(*texture, sizes);
    if (far.reach <= farthest_cell) return;
    throw Error(ExitCode::unsupported,
                fmt::format("texture.input.noise.{}: octave {} of {} {}", far.term, far.octave + 1,
                            texture->noise[far.term].octaves, too_far(far.reach)));
}

void check_lattice(const Recipe& recipe, const Mesh& mesh) {
    check_lattice(recipe, mapped(texture_from_mesh(recipe, mesh), bounding_box(mesh)));
}

}  // namespace burl
