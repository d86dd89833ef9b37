#include "app/lattice_check.h"

#include <algorithm>
#include <cmath>

#include "atlas/error.h"
#include "procedural/octaves.h"

namespace burl {

namespace {

/// The largest lattice coordinate of the box, in size; infinite if it is none.
double farthest(const Octave& octave, const Box3& box) {
    double result = 0.0;
    for (int row = 0; row < 3; ++row) {
        double sum = std::abs(octave.lattice_from_solid.offset[row]);
        for (int column = 0; column < 3; ++column)
            sum += std::abs(octave.lattice_from_solid.linear[column][row]) *
                   std::max(std::abs(box.low[column]), std::abs(box.high[column]));
        if (std::isnan(sum)) return HUGE_VAL;
        result = std::max(result, sum);
    }
    return result;
}

}  // namespace

void check_lattice(const Recipe& recipe, const Box3& texture_box) {
    if (!recipe.graph.empty()) return;
    for (std::size_t i = 0; i < recipe.texture.noise.size(); ++i) {
        Texture one;
        one.noise = {recipe.texture.noise[i]};
        for (const Octave& octave : expand_octaves(one)) {
            const double far = farthest(octave, texture_box);
            if (far <= farthest_cell) continue;
            throw Error(
                ExitCode::unsupported,
                fmt::format("texture.input.noise.{}: octave {} of {} reaches {:.2g} lattice cells "
                            "from the origin, and beyond 2^46 (7e13) cells too little of a place "
                            "within its cell is left; use fewer octaves, a smaller lacunarity or "
                            "frequency, or a smaller solid.scale",
                            i, octave.noise.seed - one.noise[0].seed + 1, one.noise[0].octaves,
                            far));
        }
    }
}

void check_lattice(const Recipe& recipe, const Mesh& mesh) {
    const Affine3 map = texture_from_mesh(recipe, mesh);
    const Box3 box = bounding_box(mesh);
    Box3 seen;  // maps scale and move, so corners stay corners
    seen.low = map(box.low), seen.high = map(box.high);
    check_lattice(recipe, seen);
}

}  // namespace burl
