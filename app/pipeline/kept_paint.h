#pragma once
// One atlas's painted texture from one recipe to the next: strokes redo the texels they reach, and
// another texture below redoes no stroke.
#include <cstdint>
#include <memory>
#include <span>
#include <variant>

#include "app/paint/texture.h"

namespace burl {

class KeptPaint {
  public:
    /// `solid` must outlive this. `threads` 0: all; no result depends on it.
    KeptPaint(const SolidAtlas& solid, int threads) : layer_(solid, threads) {}

    /// `base` under the strokes, valid until the next call. Another number says that the base is
    /// another one than at the last call. Adds the texels gone through to `texels`.
    template <class Pixel>
    const Image<Pixel>& show(const Image<Pixel>& base, std::uint64_t number,
                             std::span<const PaintStroke> strokes, std::uint64_t& texels);
    std::size_t bytes() const { return layer_.bytes(); }

  private:
    template <class Pixel>
    struct Shown {
        PaintMixer<Pixel> mixer{};
        Image<Pixel> image{};
    };

    PaintLayer layer_;
    std::uint64_t number_ = 0;  ///< of the base shown; 0: none
    std::variant<std::monostate, Shown<Rgb8>, Shown<Rgb16>, Shown<RgbF>> shown_;
};

}  // namespace burl
