#pragma once
// Caches of one atlas's texture from one recipe to the next. Unpainted: the picture, which is valid
// while its recipe's TextureKey stays the same, and the field and octaves that it was made of,
// within a budget. Painted: a new stroke changes the texels that it reaches, and a new texture
// below leaves the paint layer valid.
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <variant>

#include "app/paint/texture.h"
#include "app/pipeline/fill_texture.h"
#include "procedural/cache/graph.h"
#include "procedural/cache/synthesis.h"

namespace burl {

/// Cached paint layer and painted texture of one atlas. Not to be used by two threads at a time.
class PaintCache {
  public:
    /// `solid` must outlive this object. `threads` 0 means all; no result depends on it.
    PaintCache(const SolidAtlas& solid, int threads) : layer_(solid, threads) {}

    /// The texture `base` with the strokes of colour over it; the reference is valid until the next
    /// call. `number`, from 1 on, identifies the base: a number that differs from the last call's
    /// means that the base has changed. Adds the count of texels that were mixed to `texels`.
    template <class Pixel>
    const Image<Pixel>& show(const Image<Pixel>& base, std::uint64_t number,
                             std::span<const PaintStroke> strokes, std::uint64_t& texels);
    /// The size of the paint layer in bytes.
    std::size_t bytes() const { return layer_.bytes(); }

  private:
    /// The painted texture in one kind of pixel.
    template <class Pixel>
    struct Shown {
        PaintMixer<Pixel> mixer{};
        Image<Pixel> image{};
    };

    PaintLayer layer_;
    std::uint64_t number_ = 0;  ///< number of the base below the painted texture; 0: none
    std::variant<std::monostate, Shown<Rgb8>, Shown<Rgb16>, Shown<RgbF>> shown_;
};

/// Cached texture of one atlas. Not to be used by two threads at a time.
class TextureCache {
  public:
    /// `solid` must outlive this object. `budget` is the most bytes that fields and octaves may
    /// take (CachedSynthesis, CachedGraph); 0: only the picture is cached.
    TextureCache(const SolidAtlas& solid, std::size_t budget) : solid_(&solid), budget_(budget) {}

    const SolidAtlas& solid() const { return *solid_; }
    /// The picture, if it is valid for `recipe` and has pixels of this kind, else null.
    template <class Pixel>
    const Image<Pixel>* find(const Recipe& recipe) const {
        return key_ == TextureKey(recipe) ? std::get_if<Image<Pixel>>(&picture_) : nullptr;
    }
    /// Invalidates the picture and gives its memory to be overwritten.
    template <class Pixel>
    Image<Pixel>& open() {
        key_.reset();
        if (auto* image = std::get_if<Image<Pixel>>(&picture_)) return *image;
        return picture_.emplace<Image<Pixel>>();
    }
    /// Marks the picture as valid for `recipe`.
    void close(const Recipe& recipe) {
        key_.emplace(recipe);
        ++number_of_picture_;
    }
    /// The number of the latest picture, counted from 1; 0: there was none.
    std::uint64_t number_of_picture() const { return number_of_picture_; }
    void forget_picture() { key_.reset(); }

    /// Sets `image` to what fill_unpainted gives, using and filling the caches where the recipe and
    /// `budget` allow.
    template <class Pixel>
    void fill(const Recipe& recipe, const HostWay& way, const Economy& economy, Image<Pixel>& image,
              const MaskImages& masks = {});

    /// The size of cached fields and octaves in bytes, without the picture.
    std::size_t bytes() const {
        return (terms_ ? terms_->bytes() : 0) + (number_ ? number_->bytes() : 0);
    }

  private:
    /// The cache of the 1999 model, for the recipe's map; frees that of a graph.
    CachedSynthesis& terms(const Recipe& recipe, Kernel kernel);
    /// The cache of a graph; frees that of the 1999 model.
    CachedGraph& number();

    const SolidAtlas* solid_;
    std::size_t budget_;
    std::variant<std::monostate, Image<Rgb8>, Image<Rgb16>, Image<RgbF>> picture_;
    std::optional<TextureKey> key_;
    std::uint64_t number_of_picture_ = 0;
    std::optional<CachedSynthesis> terms_;  ///< cache of the 1999 model
    std::optional<CachedGraph> number_;     ///< cache of a graph
};

}  // namespace burl
