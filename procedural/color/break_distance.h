#pragma once
// The distance from an index to the nearest break of the colour map: a footprint without a break
// inside has the colour at its middle, so that most texels of a smooth texture need no filter.
#include <cstdint>
#include <vector>

#include "procedural/color/map_pieces.h"

namespace burl {

class BreakDistance {
  public:
    static constexpr std::uint32_t entry_count = 4096;

    explicit BreakDistance(const MapPieces& map);

    /// Whether the map is straight within `half` of every f whose map_index lies in the entry.
    bool straight(std::uint32_t entry, double half) const {
        return half < double(distances_[entry]);
    }
    /// The distances of all entries to the nearest break, rounded down by a relative 1e-6.
    const float* data() const { return distances_.data(); }

  private:
    std::vector<float> distances_;  ///< entry_count + 1 distances: index 1 has an entry of its own
};

}  // namespace burl
