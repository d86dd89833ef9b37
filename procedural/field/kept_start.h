#pragma once
// While a slider moves some of a field's octaves again and again, the sum of what comes before them
// stays: it is kept, one number a texel instead of the quadric's and every octave's.
#include <optional>
#include <vector>

#include "procedural/field/kept_noise.h"
#include "procedural/model/texture.h"

namespace burl {

/// All that a field is summed from, in order, besides the texels, the kernel, and octaves without a
/// vectorised kernel, which come last.
struct FieldSum {
    struct Group {
        double scale = 0.0;
        std::vector<float> weights{};
        std::vector<NoiseKey> keys{};
        bool operator==(const Group&) const = default;
    };
    Quadric quadric{};
    double constant = 0.0;
    std::vector<Group> groups{};
    bool operator==(const FieldSum&) const = default;
};

/// Of one field after the other.
class KeptStart {
  public:
    /// What this field shares with the one before, in `values`, which nobody else may have written
    /// since, or null: nothing is kept.
    FieldStart begin(FieldSum sum, double* values);
    /// The field is there; `complete`: at all texels.
    void end(bool complete);
    /// The values are others from now on.
    void forget() { known_.reset(); }

  private:
    std::optional<FieldSum> last_, wanted_, known_;
};

}  // namespace burl
