#pragma once
// Synthesis of a whole material on the host: every channel of every texel in one pass over batches
// of texels, so that what channels share is evaluated once, stored as pictures of up to four
// components each. Points, batches and filters are those of a texture alone (fill/graph.h).
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "atlas/base/image.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/economy.h"
#include "procedural/batch/filter.h"
#include "procedural/batch/precision.h"
#include "procedural/batch/row_window.h"
#include "procedural/fill/mask_images.h"
#include "procedural/graph/planes.h"

namespace burl {

/// A component of a picture: `factor` times the planes (graph/planes.h) that it names, of which
/// `times`, an opacity, counts within 0 to 1, plus `offset`.
struct PictureComponent {
    double factor = 1.0;
    std::optional<std::size_t> plane{}, times{};
    double offset = 0.0;
    bool operator==(const PictureComponent&) const = default;
};

/// The content of a picture: red, green, blue and alpha.
struct PicturePlan {
    std::array<PictureComponent, 4> components{};
    /// Whether red, green and blue are stored as sRGB codes; otherwise codes are linear.
    bool is_color = true;
    /// The plane by which red, green and blue are multiplied; codes are stored without it.
    std::optional<std::size_t> alpha{};
};

/// The pictures of the graph's material, one per plan. Pixel is Rgba8 or Rgba16, which hold codes
/// with colours not multiplied by alpha, or RgbaF, which holds linear numbers and colours times the
/// picture's alpha, that is their own times `factor` and `times` of its component. Numbers
/// are clamped to [0,1]. Texels outside every span show the planes at the origin.
/// `texture_from_atlas` maps the SolidAtlas's space to the texture's; `threads` 0 means all, and no
/// byte depends on it. `precision` is float32 or float64. `masks` has an image for each mask that
/// the material reads, else Error(unsupported) is thrown. The pictures have the rows `rows` alone,
/// with the same bytes; they are not whole where `economy` is stopped.
template <class Pixel>
std::vector<Image<Pixel>> synthesize_pictures(
    const SolidAtlas& solid, const TextureGraph& graph, const std::vector<PicturePlan>& plans,
    const Affine3& texture_from_atlas, const Filter& filter, int threads,
    PrecisionKind precision = PrecisionKind::float32, const Economy& economy = {},
    const MaskImages& masks = {}, const RowWindow& rows = {});

/// Takes the next rows of pictures, from row `first` on, an image per plan.
template <class Pixel>
using TakePictures = std::function<void(std::size_t first, std::vector<Image<Pixel>> rows)>;

}  // namespace burl
