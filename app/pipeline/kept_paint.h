#pragma once
// Cache of one atlas's painted texture, from one recipe to the next: a new stroke changes the
// texels that it reaches, and a new texture below leaves the paint layer valid.
#include <cstdint>
#include <memory>
#include <span>
#include <variant>

#include "app/paint/texture.h"

namespace burl {

/// Cached paint layer and painted texture of one atlas. Not to be used by two threads at a time.
class KeptPaint {
  public:
    /// `solid` must outlive this object. `threads` 0 means all; no result depends on it.
    KeptPaint(const SolidAtlas& solid, int threads) : layer_(solid, threads) {}

    /// The texture `base` with the strokes over it; the reference is valid until the next call.
    /// `number`, from 1 on, identifies the base: a number that differs from the last call's means
    /// that the base has changed. Adds the count of texels that were mixed to `texels`.
    template <class Pixel>
    const Image<Pixel>& show(const Image<Pixel>& base, std::uint64_t number,
                             std::span<const PaintStroke> strokes, std::uint64_t& texels);
    /// The size of the paint layer in bytes.
    std::size_t bytes() const { return layer_.bytes(); }

  private:
    template <class Pixel>
    /// The painted texture in one kind of pixel.
    struct Shown {
        PaintMixer<Pixel> mixer{};
        Image<Pixel> image{};
    };

    PaintLayer layer_;
    std::uint64_t number_ = 0;  ///< number of the base below the painted texture; 0: none
    std::variant<std::monostate, Shown<Rgb8>, Shown<Rgb16>, Shown<RgbF>> shown_;
};

}  // namespace burl
