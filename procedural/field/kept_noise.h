#pragma once
// The noise of octaves kept from one texture to the next: what it depends on, and where it lies.
#include <cstddef>
#include <span>

#include "procedural/batch/span_lines.h"
#include "procedural/model/octaves.h"

namespace burl {

/// All that an octave's kept numbers depend on, besides the texels and the kernel. Scale and offset
/// are not among them.
struct NoiseKey {
    NoiseSpec noise;
    OctaveShape shape = OctaveShape::plain;
    Affine3 lattice_from_solid;  ///< of the first octave that shares its coordinates
    int doublings = 0;           ///< from there to this octave
    int most_doublings = 0;      ///< from there to the finest of them
    bool operator==(const NoiseKey&) const = default;
};

/// An octave's numbers for all texels of a picture.
struct KeptNoise {
    float* noise = nullptr;  ///< null: not kept, worked out every time
    bool known = false;      ///< they are there already
};
/// The sum of quadric, constants and some groups of octaves (kept_start.h), for all texels.
struct FieldStart {
    double* values = nullptr;  ///< null: not kept
    bool known = false;
    std::size_t groups = 0, octaves = 0;  ///< how many are in it, the first ones
};
/// As many octaves as a sampler has keys, and the first texel of a batch among the numbers. Numbers
/// are read (not written) up to batch_padding beyond the last texel. Octaves of a start that is
/// known are not read. Where all is known, batches need no pieces, nor where lines are there that
/// FieldSampler::needs_pieces takes instead.
struct KeptBatch {
    std::span<const KeptNoise> octaves;
    double* quadric = nullptr;  ///< its values; null: not kept
    bool quadric_known = false;
    std::size_t at = 0;
    FieldStart start{};
    const SpanLines* lines = nullptr;  ///< of the batch; null: it has pieces

    KeptBatch part(std::size_t first, std::size_t count) const {
        return {octaves.subspan(first, count), quadric, quadric_known, at, start, lines};
    }
};

}  // namespace burl
