#pragma once
// Cache for graphs whose outermost node is a colour map, while somebody edits the colours: the
// map's input, one number per texel, stays in the cache, and the next texture only looks colours
// up.
#include <cstddef>
#include <optional>

#include "atlas/base/image.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/economy.h"
#include "procedural/batch/filter.h"
#include "procedural/cache/texel_layout.h"
#include "procedural/fill/mask_images.h"
#include "procedural/graph/graph.h"

namespace burl {

/// Synthesis of graphs on one atlas with a cache of the colour map's input. Not to be used by two
/// threads at a time.
class CachedGraph {
  public:
    /// `solid` must outlive this object. The cache takes 8 bytes per texel of the whole square; if
    /// `budget`, in bytes, is less, nothing is cached.
    CachedGraph(const SolidAtlas& solid, std::size_t budget)
        : solid_(&solid), rows_(solid), budget_(budget) {}

    /// Whether the cache serves the graph: its last node is a colour map over the node before,
    /// nobody else uses the map's texture, and the filter is `none`.
    static bool splits(const TextureGraph& graph, const Filter& filter);

    /// Sets `image` to the bytes of synthesize_graph, for Pixel Rgb8, Rgb16 or RgbF, in float32
    /// without a filter. splits() must hold for the graph. `threads` 0 means all. If economy.stop
    /// is requested, the image is unspecified. An image of `masks` must not change once it was
    /// given.
    template <class Pixel>
    void synthesize(const TextureGraph& graph, const Affine3& texture_from_atlas, int threads,
                    Image<Pixel>& image, const Economy& economy = {}, const MaskImages& masks = {});

    /// The size of the cache in bytes.
    std::size_t bytes() const { return values_.width() * values_.height() * sizeof(double); }

  private:
    /// Cache key of the numbers besides the atlas: the graph below the map, the map from atlas to
    /// texture space, and the images of masks, of which one that differs is another object.
    struct Key {
        TextureGraph graph{};
        Affine3 map{};
        MaskImages masks{};
        bool operator==(const Key&) const = default;
    };

    const SolidAtlas* solid_;
    TexelLayout rows_;
    std::size_t budget_;
    Image<double> values_;
    std::optional<Key> known_;
    std::uint64_t octaves_ = 0;  ///< octaves that a texel's number takes
};

}  // namespace burl
