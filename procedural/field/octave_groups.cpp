#include "procedural/field/octave_groups.h"

#include <cmath>

#include "procedural/kernels/simplex_kernel.h"

namespace burl {

namespace {

/// Whether `octave` may share the lattice coordinates of `before`, the octave before it.
bool doubles(const Octave& octave, const Octave& before) {
    const Affine3 &map = octave.lattice_from_solid, &half = before.lattice_from_solid;
    return octave.scale != 0.0 && octave.noise.kind == before.noise.kind &&
           octave.noise.fade == before.noise.fade && octave.noise.radius2 == before.noise.radius2 &&
           map.linear == 2.0 * half.linear && map.offset == 2.0 * half.offset &&
           std::abs(octave.scale) <= 0.5 * std::abs(before.scale);
}

/// An empty group with the kind, the map and the scale of `first`.
OctaveGroup group_from(const Octave& first) {
    OctaveGroup group;
    group.kind = first.noise.kind;
    group.fade = first.noise.fade;
    group.radius2 = first.noise.radius2;
    group.lattice_from_solid = first.lattice_from_solid;
    group.scale = first.scale;
    return group;
}

}  // namespace

double OctaveGroup::period() const {
    return kind == NoiseKind::simplex ? simplex_period : 0.0;
}

bool has_kernel(const Octave& octave) {
    const NoiseSpec& noise = octave.noise;
    return (noise.kind == NoiseKind::value || noise.kind == NoiseKind::perlin ||
            noise.kind == NoiseKind::simplex) &&
           noise.period == Period<4>{} && !noise.time && octave.shape == OctaveShape::plain;
}

std::vector<OctaveGroup> group_octaves(std::span<const Octave> octaves) {
    std::vector<OctaveGroup> groups;
    const Octave* before = nullptr;
    for (const Octave& octave : octaves) {
        if (!has_kernel(octave)) continue;
        const std::size_t most =
            octave.noise.kind == NoiseKind::simplex ? most_simplex_doublings : most_doublings;
        const bool full = !groups.empty() && groups.back().octaves.size() > most;
        if (!before || full || !doubles(octave, *before)) groups.push_back(group_from(octave));
        OctaveGroup& group = groups.back();
        const double weight = group.scale != 0.0 ? octave.scale / group.scale : 1.0;
        group.octaves.push_back(
            {octave.noise.seed, int(group.octaves.size()), float(weight), group.radius2});
        before = &octave;
    }
    return groups;
}

}  // namespace burl
