#pragma once
// Cache of one atlas's unpainted texture, from one recipe to the next: the picture, which is valid
// while its recipe's TextureKey stays the same, and the field and octaves that it was made of,
// within a budget.
#include <optional>
#include <variant>

#include "app/pipeline/fill_texture.h"
#include "procedural/cache/graph.h"
#include "procedural/cache/synthesis.h"

namespace burl {

/// Cached texture of one atlas. Not to be used by two threads at a time.
class KeptTexture {
  public:
    /// `solid` must outlive this object. `budget` is the most bytes that fields and octaves may
    /// take (CachedSynthesis, CachedGraph); 0: only the picture is cached.
    KeptTexture(const SolidAtlas& solid, std::size_t budget) : solid_(&solid), budget_(budget) {}

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
    void fill(const Recipe& recipe, const HostWay& way, const Economy& economy,
              Image<Pixel>& image);

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
