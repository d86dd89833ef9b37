#pragma once
// Graphs whose outermost node is a colour map, synthesised again and again while somebody edits the
// colours: the number below the map is kept, and the next texture looks its colours up alone.
#include <cstddef>
#include <optional>

#include "atlas/base/image.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/economy.h"
#include "procedural/batch/filter.h"
#include "procedural/graph/graph.h"
#include "procedural/kept/rows.h"

namespace burl {

/// Textures of one atlas. Not to be used by two threads at a time.
class KeptGraph {
  public:
    /// `solid` must outlive this. 8 bytes a texel are kept, if `budget` allows them.
    KeptGraph(const SolidAtlas& solid, std::size_t budget)
        : solid_(&solid), rows_(solid), budget_(budget) {}

    /// Whether the graph is a colour map over a number, in point samples.
    static bool splits(const TextureGraph& graph, const Filter& filter);

    /// The bytes of synthesize_graph_rgb8, _rgb16 or _rgbf, for Pixel Rgb8, Rgb16 or RgbF, without
    /// filter and in float32, of a graph that splits. An image of the atlas's size is written over.
    template <class Pixel>
    void synthesize(const TextureGraph& graph, const Affine3& texture_from_atlas, int threads,
                    Image<Pixel>& image, const Economy& economy = {});

    /// Bytes kept of texels.
    std::size_t bytes() const { return values_.width() * values_.height() * sizeof(double); }

  private:
    /// What the number depends on.
    struct Key {
        TextureGraph graph{};
        Affine3 map{};
        bool operator==(const Key&) const = default;
    };

    const SolidAtlas* solid_;
    KeptRows rows_;
    std::size_t budget_;
    Image<double> values_;
    std::optional<Key> known_;
    std::uint64_t octaves_ = 0;  ///< per texel
};

}  // namespace burl
