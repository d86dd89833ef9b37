#include "procedural/octave_streams.h"

#include <algorithm>
#include <cmath>

namespace burl {

namespace {

bool doubles(const Octave& octave, const Octave& before) {
    const Affine3 &map = octave.lattice_from_solid, &half = before.lattice_from_solid;
    return octave.noise.kind == before.noise.kind && octave.noise.fade == before.noise.fade &&
           map.linear == 2.0 * half.linear && map.offset == 2.0 * half.offset &&
           std::abs(octave.scale) <= 0.5 * std::abs(before.scale);
}

/// The crossovers: an octave that crosses fewer planes of the lattice per texel, |dx| + |dy| + |dz|
/// for a step of a texel, is faster with shared corners. Measured with `burl bench kernels`.
constexpr double most_crossings(NoiseKind kind) {
    return kind == NoiseKind::perlin ? 4.0 / 16 : 3.0 / 16;
}

}  // namespace

bool has_kernel(const Octave& octave) {
    const NoiseSpec& noise = octave.noise;
    return (noise.kind == NoiseKind::value || noise.kind == NoiseKind::perlin) &&
           noise.period == Period<4>{} && !noise.time && octave.shape == OctaveShape::plain;
}

OctaveStreams::OctaveStreams(std::span<const Octave> octaves, Kernel kernel) : kernel_(kernel) {
    const Octave* before = nullptr;
    for (const Octave& octave : octaves) {
        if (!has_kernel(octave)) continue;
        const bool full = !groups_.empty() && groups_.back().octaves.size() > most_doublings;
        if (!before || full || !doubles(octave, *before))
            groups_.push_back({octave.noise.kind,
                               octave.noise.fade,
                               octave.lattice_from_solid,
                               octave.scale,
                               {}});
        Group& group = groups_.back();
        group.octaves.push_back(
            {octave.noise.seed, int(group.octaves.size()), float(octave.scale / group.scale)});
        before = &octave;
    }
}

std::size_t OctaveStreams::sharing(const Group& group, double crossings) const {
    if (kernel_ == Kernel::direct) return 0;
    if (kernel_ == Kernel::share) return group.octaves.size();
    std::size_t count = 0;
    while (count < group.octaves.size() &&
           std::ldexp(crossings, int(count)) < most_crossings(group.kind))
        ++count;
    return count;
}

void OctaveStreams::add(std::span<const Piece> pieces, std::size_t count, StreamBuffers& buffers,
                        double* values) const {
    for (const Group& group : groups_) {
        const auto& [kind, fade, map, scale, octaves] = group;
        const double planes = fill_stream(map, octaves.back().doublings, pieces, buffers.lattice);
        const std::size_t shared = sharing(group, planes / double(count));
        if (shared > 0) find_runs(buffers.lattice, int(shared) - 1, count, buffers.runs);
        std::fill_n(buffers.sums, count + batch_padding, 0.0f);
        for (std::size_t k = octaves.size(); k-- > 0;)
            if (k < shared)
                add_octave_shared(kind, fade, octaves[k], buffers.lattice, buffers.runs, count,
                                  buffers.sums);
            else
                add_octave_direct(kind, fade, octaves[k], buffers.lattice, count, buffers.sums);
        add_sums(scale * stream_unit(kind), buffers.sums, count, values);
    }
}

}  // namespace burl
