#pragma once
// Which triangle corners meet at a point of the mesh, as compressed rows.
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/mesh/mesh.h"

namespace burl {

/// Corners 3t+k by their point, ascending at each.
class CornersByPoint {
  public:
    explicit CornersByPoint(const Mesh& mesh);

    std::size_t points() const { return begin_.size() - 1; }
    std::span<const std::uint32_t> operator[](std::size_t point) const {
        return {corners_.data() + begin_[point], begin_[point + 1] - begin_[point]};
    }

  private:
    std::vector<std::uint32_t> begin_, corners_;  ///< the former one more than there are points
};

}  // namespace burl
