#pragma once
// A level of a cube map that is fast to look up: in floats, and each face with a border of its
// neighbours' texels.
#include <array>

#include "app/light/prefilter.h"

namespace burl {

class PaddedCube {
  public:
    explicit PaddedCube(const CubeFaces& faces);

    /// The value that a direction of any length but 0 sees: bilinear, as cube_lookup() has it.
    Vec3f operator()(const Vec3f& direction) const;

  private:
    std::size_t side_, stride_;
    std::array<Image<Vec3f>, 6> faces_;
};

}  // namespace burl
