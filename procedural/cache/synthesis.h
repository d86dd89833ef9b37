#pragma once
// Synthesis with a cache, while somebody moves sliders: the field, its slopes where a filter wants
// them, and the unscaled noise of every octave stay in memory, and the next texture evaluates only
// what it does not share with the last one. Sums run over the cached noise in the order of a
// synthesis from scratch, so that the bytes are the same.
#include <vector>

#include "atlas/base/image.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/economy.h"
#include "procedural/batch/filter.h"
#include "procedural/cache/field_cache.h"

namespace burl {

/// Synthesis of the 1999 model on one atlas with a cache. Not to be used by two threads at a time.
class CachedSynthesis {
  public:
    /// Cache statistics of the last call, in octaves of expand_octaves.
    struct Work {
        bool field_cached = false;  ///< whether f came from the cache and was only coloured
        std::size_t octaves_cached = 0, octaves_evaluated = 0;
    };

    /// `solid` must outlive this object. The cache takes at most `budget` bytes. In order of
    /// priority it holds, per texel, 8 bytes for the field, 4 for each octave of the texture (as
    /// many as fit) and 8 for the quadric; then, while octaves change, 52 bytes per span for span
    /// lines, and, while colours change, 4 bytes per texel for f's entry in the colour table. With
    /// a filter it holds 8 bytes for the field and 8 for its slopes, and no octaves. A smaller
    /// budget costs time alone; no byte of a texture depends on it. (The texels' maps, 80 bytes per
    /// triangle, are not counted.)
    CachedSynthesis(const SolidAtlas& solid, const Affine3& texture_from_atlas, std::size_t budget,
                    Kernel kernel = Kernel::automatic);

    /// Sets the map from the atlas's space to the texture's; a different map invalidates the cache.
    void set_map(const Affine3& texture_from_atlas);
    Kernel kernel() const { return kernel_; }

    /// Sets `image` to the bytes of synthesize_model, for Pixel Rgb8, Rgb16 or
    /// RgbF. An image of the atlas's size is overwritten in place, which spares the allocation of a
    /// cleared one. `threads` 0 means all. Filtered and band-limited textures cache no octaves,
    /// supersampled ones nothing. If economy.stop is requested, the image is unspecified; cached
    /// noise of the texture's octaves stays valid.
    template <class Pixel>
    void synthesize(const Texture& texture, int threads, Image<Pixel>& image,
                    const Filter& filter = {}, const Economy& economy = {});

    const Work& work() const { return work_; }
    /// The size of the cache in bytes.
    std::size_t bytes() const { return cache_.memory().bytes(); }

  private:
    struct Job;
    struct Batch;
    template <class Pixel>
    struct Evaluation;

    template <class Pixel>
    Image<Pixel> from_scratch(const Job& job) const;
    template <class Pixel>
    void evaluate(const Job& job, Image<Pixel>& image);
    template <class Pixel>
    void evaluate_row(std::size_t y, const Evaluation<Pixel>& to, Batch& batch,
                      Image<Pixel>& image) const;
    template <class Pixel>
    void recolor(const Job& job, Image<Pixel>& image);
    /// Evaluates the field and its colours by a shader (procedural/fill/texel_shaders.h), and
    /// caches f and its slopes.
    template <class Shader>
    void evaluate_by(const Shader& shader, const Job& job, Image<typename Shader::Pixel>& image);
    /// Colours the cached field by a shader.
    template <class Shader>
    void recolor_by(const Shader& shader, const Job& job,
                    Image<typename Shader::Pixel>& image) const;
    template <class Shader>
    void synthesize_by(const Shader& shader, const Job& job, Image<typename Shader::Pixel>& image);
    /// Calls color(at, count, buffers, painter) for all batches of cached numbers: `count` texels,
    /// of which the first has the index `at`.
    template <class Buffers, class Pixel, class Color>
    void recolor_rows(const Job& job, const Pixel& background, Image<Pixel>& image,
                      const Color& color) const;

    const SolidAtlas* solid_;
    Affine3 texture_from_atlas_;
    Kernel kernel_;
    std::vector<TexelMap> maps_;  ///< texel maps to texture space; empty: to be computed
    FieldCache cache_;
    std::uint64_t octaves_per_texel_ = 0;  ///< octaves of the cached field
    Work work_;
};

}  // namespace burl
