#pragma once
// The 1999 paper's first filter (Hart et al., section 3.3.1): tables of the colour map at halved
// resolutions, looked up in the one whose entries are as wide as the footprint. The program keeps
// it for comparison with the exact filter.
#include <vector>

#include "atlas/base/vec.h"
#include "procedural/color/map.h"

namespace burl {

class ColorMip {
  public:
    static constexpr int finest = 10;  ///< the full table has 2^finest entries

    explicit ColorMip(const ColorMap& map);

    /// c(f) averaged over about `width`, in linear light: linear interpolation in the two tables
    /// whose entries are just narrower and just wider, and between the two results. (The paper's
    /// clut_i[f/i] means f / 2^i.) A footprint beyond an end of a `clamp` map counts as lying at
    /// the end.
    Vec3d operator()(double f, double width) const;

    /// Tables of 2^finest, ..., 1 entries; entry i is the mean from i to i + 1, in entries.
    const std::vector<std::vector<Vec3d>>& levels() const { return levels_; }

  private:
    Vec3d at_level(int level, double index) const;

    Wrap wrap_;
    std::vector<std::vector<Vec3d>> levels_;
};

}  // namespace burl
