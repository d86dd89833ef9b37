#pragma once
// The cached prefix of a field's sum. While a slider changes the same octaves again and again, the
// sum of the quadric and of the groups before them stays valid; caching it costs one number per
// texel instead of one for the quadric and one for every octave.
#include <optional>
#include <vector>

#include "procedural/field/kept_noise.h"
#include "procedural/model/texture.h"

namespace burl {

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
