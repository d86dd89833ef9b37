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

}  // namespace

bool has_kernel(const Octave& octave) {
    const NoiseSpec& noise = octave.noise;
    return (noise.kind == NoiseKind::value || noise.kind == NoiseKind::perlin) &&
           noise.period == Period<4>{} && !noise.time && octave.shape == OctaveShape::plain;
}

OctaveStreams::OctaveStreams(std::span<const Octave> octaves) {
    const Octave* before = nullptr;
    for (const Octave& octave : octaves) {
        if (!has_kernel(octave)) continue;
        if (!before || !doubles(octave, *before))
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

void OctaveStreams::add(std::span<const Piece> pieces, std::size_t count, StreamBuffers& buffers,
                        double* values) const {
    for (const Group& group : groups_) {
        fill_stream(group.lattice_from_solid, group.octaves.back().doublings, pieces,
                    buffers.lattice);
        std::fill_n(buffers.sums, count + batch_padding, 0.0f);
        for (auto octave = group.octaves.rbegin(); octave != group.octaves.rend(); ++octave)
            add_octave_direct(group.kind, group.fade, *octave, buffers.lattice, count,
                              buffers.sums);
        add_sums(group.scale * noise_unit(group.kind), buffers.sums, count, values);
    }
}

}  // namespace burl
