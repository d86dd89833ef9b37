#pragma once
// What of a field is kept from one texture to the next: the noise of single octaves, and a prefix
// of the field's sum. While a slider changes the same octaves again and again, the sum of the
// quadric and of the groups before them stays valid; caching it costs one number per texel instead
// of one for the quadric and one for every octave.
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "procedural/kernels/lattice_stream.h"
#include "procedural/model/octaves.h"
#include "procedural/model/texture.h"

namespace burl {

/// Cache key of an octave's noise: all that the numbers depend on besides the texels and the
/// kernel. The noise is cached without the octave's scale and offset, which are no part of the key.
struct NoiseKey {
    NoiseSpec noise;
    OctaveShape shape = OctaveShape::plain;
    /// Map to the lattice of the group's first octave; an octave without a kernel is a group.
    Affine3 lattice_from_solid;
    int doublings = 0;       ///< number of doublings from the group's lattice to this octave's
    int most_doublings = 0;  ///< number of doublings of the group's finest octave
    bool operator==(const NoiseKey&) const = default;
};

/// An octave's cached noise, one float per texel of the picture.
struct KeptNoise {
    float* noise = nullptr;  ///< null: the octave is not cached and evaluated every time
    bool known = false;      ///< whether `noise` is valid, or a known prefix holds the octave
};

/// Cached prefix of the field's sum, one number per texel of the picture: the quadric, the
/// constants and the leading groups of octaves.
struct FieldStart {
    double* values = nullptr;             ///< null: no prefix is cached
    bool known = false;                   ///< whether `values` holds the prefix
    std::size_t groups = 0, octaves = 0;  ///< numbers of leading groups and octaves in the prefix
};

/// The caches of a picture's field and the place of one batch in them. `octaves` has one entry per
/// key of FieldSampler::noise_keys. Kernels read, but do not write, up to batch_padding numbers
/// beyond the last texel. The octaves of a known prefix are not read. A batch needs no pieces if
/// the quadric and every octave are known, or if `lines` is set and FieldSampler::needs_pieces is
/// false.
struct KeptBatch {
    std::span<const KeptNoise> octaves;
    double* quadric = nullptr;  ///< cached values of the quadric; null: not cached
    /// Whether `quadric` holds valid values.
    bool quadric_known = false;
    /// Index of the batch's first texel in all cached arrays.
    std::size_t at = 0;
    FieldStart start{};
    /// Span lines of the batch's texels; null: the batch has pieces.
    const SpanLines* lines = nullptr;

    /// The batch with the octaves [first, first + count) alone.
    KeptBatch part(std::size_t first, std::size_t count) const {
        return {octaves.subspan(first, count), quadric, quadric_known, at, start, lines};
    }
};

/// The summands of a field, in the order they are added: the cache key of a prefix besides the
/// texels and the kernel. Octaves without a vectorised kernel are added last and belong to no
/// prefix.
struct FieldSum {
    /// A group of octaves (octave_groups.h): its scale, and the weight and key of each octave.
    struct Group {
        double scale = 0.0;
        std::vector<float> weights{};
        std::vector<NoiseKey> keys{};
        bool operator==(const Group&) const = default;
    };
    Quadric quadric{};
    /// Sum of the octaves' offsets.
    double constant = 0.0;
    std::vector<Group> groups{};
    bool operator==(const FieldSum&) const = default;
};

/// Decides, for one field after another, which prefix of the sum is cached and whether it is valid.
class KeptStart {
  public:
    /// Begins a field with the sum `sum`; gives the prefix that it shares with the field before, to
    /// be cached in `values`. The caller must not have written to `values` since the last call of
    /// end() without forget(). If `values` is null or no group is shared, nothing is cached and the
    /// prefix is empty.
    FieldStart begin(FieldSum sum, double* values);
    /// Ends the field; the prefix counts as valid if it was written for all texels (`complete`).
    void end(bool complete);
    /// Marks the cached prefix as invalid.
    void forget() { known_.reset(); }

  private:
    std::optional<FieldSum> last_, wanted_, known_;
};

}  // namespace burl
