#pragma once
// The triangle corners that meet at each point of a mesh, in compressed rows (CSR).
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/mesh/mesh.h"

namespace burl {

/// Corners 3t+k grouped by point, in ascending order.
class CornersByPoint {
  public:
    explicit CornersByPoint(const Mesh& mesh);

    std::size_t points() const { return begin_.size() - 1; }
    std::span<const std::uint32_t> operator[](std::size_t point) const {
        return {corners_.data() + begin_[point], begin_[point + 1] - begin_[point]};
    }

  private:
    /// The corners of point p are corners_[begin_[p]] to corners_[begin_[p + 1] - 1].
    std::vector<std::uint32_t> begin_, corners_;
};

}  // namespace burl
