#pragma once
// The nearest claimed texel of every texel: exact distances between centres by a lower envelope of
// parabolas per row (Meijster, Roerdink, Hesselink, "A General Algorithm for Computing Distance
// Transforms in Linear Time", 2000).
#include <cstdint>
#include <vector>

#include "atlas/base/image.h"

namespace burl {

/// The nearest claimed texels of an image's texels.
class NearestClaims {
  public:
    /// `owner` holds `unclaimed` (claims.h) for texels that are not claimed.
    explicit NearestClaims(const Image<std::uint32_t>& owner);

    /// Column and row of a claimed texel.
    struct Place {
        std::uint32_t x = 0, y = 0;
    };
    /// Sets `places` to the nearest claimed texel of every texel of row y; to nothing where no
    /// texel is claimed. Of equally near texels of a column it is the upper one; of columns, any,
    /// but always the same.
    void find(std::uint32_t y, std::vector<Place>& places) const;

  private:
    Image<std::uint32_t> rows_;  ///< row of the nearest claimed texel of the column, or `unclaimed`
};

}  // namespace burl
