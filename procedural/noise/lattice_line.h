#pragma once
// Scan lines of the solid in the lattice coordinates of an octave.
#include <algorithm>
#include <cmath>

#include "procedural/batch/texel_batch.h"
#include "procedural/noise/lattice_site.h"

namespace burl {

/// The line `solid` in lattice coordinates. A coordinate that leaves the lattice anywhere on the
/// whole span of `length` texels (or on `solid`, where that is longer) is 0 on all of it.
inline LatticeLine lattice_line(const Affine3& lattice_from_solid, const LatticeLine& solid,
                                double length = 0.0) {
    LatticeLine line{lattice_from_solid(solid.start), lattice_from_solid.linear * solid.step,
                     solid.first, solid.count};
    const double last = std::max(length, line.first + double(line.count));
    for (int axis = 0; axis < 3; ++axis) {
        const double reach = std::abs(line.start[axis]) + last * std::abs(line.step[axis]);
        if (!(reach < lattice_limit)) line.start[axis] = line.step[axis] = 0.0;
    }
    return line;
}

/// The largest component of the line's step, in cells per texel.
inline double fastest_step(const LatticeLine& line) {
    return std::max({std::abs(line.step.x), std::abs(line.step.y), std::abs(line.step.z)});
}

}  // namespace burl
