#pragma once
// The conversion of linear light to a pixel of any of the image formats: sRGB codes of 8 or 16
// bits, or floats of linear light.
#include "atlas/base/image.h"
#include "atlas/base/vec.h"
#include "procedural/color/srgb.h"

namespace burl {

template <class Pixel>
class PixelEncoder;

template <class Code>
class PixelEncoder<Rgb<Code>> {
  public:
    Rgb<Code> operator()(const Vec3d& c) const {
        return {encode_(c.x), encode_(c.y), encode_(c.z)};
    }

  private:
    SrgbEncoder<Code> encode_;
};

template <>
class PixelEncoder<RgbF> {
  public:
    RgbF operator()(const Vec3d& c) const { return {float(c.x), float(c.y), float(c.z)}; }
};

}  // namespace burl
