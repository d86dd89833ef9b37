#pragma once
// The partition of a scan line's texels into runs, each with a set of forward differences of its
// own. Runs begin at texels that depend on the line alone, so that it may be cut anywhere without a
// trace.
#include <algorithm>
#include <cstdint>

#include "procedural/bresenham/differences.h"
#include "procedural/noise/lattice_site.h"

namespace burl {

/// Texels first to last - 1 lie in one cell; texels begin to end - 1 are wanted.
struct TexelRange {
    std::int64_t first = 0, last = 0, begin = 0, end = 0;

    std::int64_t wanted_first() const { return std::max(first, begin); }
    std::int64_t wanted_last() const { return std::min(last, end); }
};

/// Calls run(origin, last) for every run that reaches wanted texels: its differences are computed
/// at texel `origin`, and it has at most `longest` texels. Returns the number of runs.
template <class Run>
std::int64_t for_each_run(const TexelRange& texels, std::int64_t longest, Run&& run) {
    const std::int64_t wanted = texels.wanted_first(), last = texels.wanted_last();
    std::int64_t runs = 0;
    for (std::int64_t j = wanted - (wanted - texels.first) % longest; j < last; j += longest) {
        run(j, last - j < longest ? last : j + longest);
        ++runs;
    }
    return runs;
}

/// Calls put(texel, value) for the texels from `begin` on up to last - 1; `differences` are those
/// at texel `origin`.
template <class Number, std::size_t degree, class Put>
void run_differences(ForwardDifferences<Number, degree> differences, std::int64_t origin,
                     std::int64_t last, std::int64_t begin, Put&& put) {
    std::int64_t j = origin;
    for (; j < begin; ++j) differences.step();
    for (; j < last; ++j) {
        put(j, differences.value());
        differences.step();
    }
}

/// The place of a texel, measured from the middle of its cell.
inline Vec3d cell_place(const LatticeLine& line, const std::array<std::int64_t, 3>& cell,
                        std::int64_t texel) {
    Vec3d u = line.start + double(texel) * line.step;
    for (int axis = 0; axis < 3; ++axis)
        u[axis] = (u[axis] - double(cell[std::size_t(axis)])) - 0.5;
    return u;
}

}  // namespace burl
