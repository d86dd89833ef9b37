#pragma once
// One atlas's texture, before paint, from one recipe to the next: the picture itself, which does
// while nothing of its recipe changes, and the field and octaves it was made of, within a budget.
#include <optional>
#include <variant>

#include "app/pipeline/fill_texture.h"
#include "procedural/kept/graph.h"
#include "procedural/kept/kept.h"

namespace burl {

class KeptTexture {
  public:
    /// `solid` must outlive this; `budget` as KeptSynthesis has it, 0: nothing but the picture.
    KeptTexture(const SolidAtlas& solid, std::size_t budget) : solid_(&solid), budget_(budget) {}

    const SolidAtlas& solid() const { return *solid_; }
    /// The picture, if it is this recipe's and of such pixels.
    template <class Pixel>
    const Image<Pixel>* find(const Recipe& recipe) const {
        return key_ == TextureKey(recipe) ? std::get_if<Image<Pixel>>(&picture_) : nullptr;
    }
    /// The picture to be written over, which from now on is nobody's.
    template <class Pixel>
    Image<Pixel>& open() {
        key_.reset();
        if (auto* image = std::get_if<Image<Pixel>>(&picture_)) return *image;
        return picture_.emplace<Image<Pixel>>();
    }
    /// It has become this recipe's.
    void close(const Recipe& recipe) {
        key_.emplace(recipe);
        ++number_of_picture_;
    }
    /// From 1 on, another one for every picture.
    std::uint64_t number_of_picture() const { return number_of_picture_; }
    void forget_picture() { key_.reset(); }

    /// As fill_unpainted, into `image`, from what is kept where that serves.
    template <class Pixel>
    void fill(const Recipe& recipe, const HostWay& way, const Economy& economy,
              Image<Pixel>& image);

    /// Of fields and octaves.
    std::size_t bytes() const {
        return (terms_ ? terms_->bytes() : 0) + (number_ ? number_->bytes() : 0);
    }

  private:
    KeptSynthesis& terms(const Recipe& recipe, Kernel kernel);
    KeptGraph& number();

    const SolidAtlas* solid_;
    std::size_t budget_;
    std::variant<std::monostate, Image<Rgb8>, Image<Rgb16>, Image<RgbF>> picture_;
    std::optional<TextureKey> key_;
    std::uint64_t number_of_picture_ = 0;
    std::optional<KeptSynthesis> terms_;  ///< of the 1999 model, or
    std::optional<KeptGraph> number_;     ///< of a graph
};

}  // namespace burl
