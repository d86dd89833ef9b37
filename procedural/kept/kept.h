#pragma once
// Synthesis with a cache, while somebody moves sliders: the field, its slopes where a filter wants
// them, and the unscaled noise of every octave stay in memory, and the next texture evaluates only
// what it does not share with the last one. Sums run over the cached noise in the order of a
// synthesis from scratch, so that the bytes are the same.
#include <optional>
#include <utility>
#include <vector>

#include "atlas/base/image.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/economy.h"
#include "procedural/batch/filter.h"
#include "procedural/field/kept_start.h"
#include "procedural/field/sampler.h"
#include "procedural/kept/lines.h"
#include "procedural/kept/rows.h"

namespace burl {

/// Synthesis of the 1999 model on one atlas with a cache. Not to be used by two threads at a time.
class KeptSynthesis {
  public:
    /// Cache statistics of the last call, in octaves of expand_octaves.
    struct Work {
        bool field_kept = false;  ///< whether f came from the cache and only colours were evaluated
        std::size_t octaves_kept = 0, octaves_evaluated = 0;
    };

    /// `solid` must outlive this object. The cache takes at most `budget` bytes. In order of
    /// priority it holds, per texel, 8 bytes for the field, 4 for each octave of the texture (as
    /// many as fit) and 8 for the quadric; then, while octaves change, 52 bytes per span for span
    /// lines, and, while colours change, 4 bytes per texel for f's entry in the colour table. With
    /// a filter it holds 8 bytes for the field and 8 for its slopes, and no octaves. A smaller
    /// budget costs time alone; no byte of a texture depends on it. (The texels' maps, 80 bytes per
    /// triangle, are not counted.)
    KeptSynthesis(const SolidAtlas& solid, const Affine3& texture_from_atlas, std::size_t budget,
                  Kernel kernel = Kernel::automatic);

    /// Sets the map from the atlas's space to the texture's; a different map invalidates the cache.
    void set_map(const Affine3& texture_from_atlas);
    Kernel kernel() const { return kernel_; }

    /// Sets `image` to the bytes of synthesize_model, for Pixel Rgb8, Rgb16 or RgbF. An image of
    /// the atlas's size is overwritten in place, which spares the allocation of a cleared one.
    /// `threads` 0 means all. An octave or quadric that changes in two calls running, as while its
    /// slider moves, is not cached until it stops changing. A field that changes in two calls
    /// running for the same octaves is not cached either: its memory holds the cached prefix of the
    /// sum (procedural/field/kept_start.h). Filtered, supersampled and band-limited textures cache
    /// no octaves. If economy.stop is requested, the image is unspecified; cached noise of the
    /// texture's octaves stays valid.
    template <class Pixel>
    void synthesize(const Texture& texture, int threads, Image<Pixel>& image,
                    const Filter& filter = {}, const Economy& economy = {});

    const Work& work() const { return work_; }
    /// The size of the cache in bytes.
    std::size_t bytes() const;

  private:
    /// An octave's cached noise for all texels, with its key.
    struct KeptOctave {
        NoiseKey key{};
        KeptArray<float> noise{};
        bool known = false;  ///< whether the noise was valid before this call
    };
    /// Cache key of f and its slopes besides the atlas; all filters that need the same slopes have
    /// one `kind`.
    struct FieldKey {
        Quadric quadric{};
        std::vector<NoiseTerm> noise{};
        FilterKind kind = FilterKind::none;
        bool band_limit = false;
        bool operator==(const FieldKey&) const = default;
    };
    static FieldKey field_key(const Texture& texture, const Filter& filter);
    /// Whether a parameter changed in this call (`now`), and in the call before as well (`again`).
    struct Change {
        bool now = false, again = false;
        void note(bool changed) { again = std::exchange(now, changed) && changed; }
    };

    std::size_t bytes_per_texel() const { return rows_.size() > 0 ? budget_ / rows_.size() : 0; }
    void forget();
    void forget_octaves();
    std::vector<KeptOctave> keep(const std::vector<NoiseKey>& keys);
    void note_changes(const std::vector<NoiseKey>& keys, const FieldKey& field);
    /// Allots the arrays of f, and of its slopes if `slopes`; false if the budget has no room for
    /// them.
    bool keep_field(bool slopes);

    template <class Pixel>
    void recolor(const Texture& texture, int threads, const Economy& economy, Image<Pixel>& image);
    bool keep_entries();
    struct Batch;
    template <class Pixel>
    struct Evaluation;
    template <class Pixel>
    void evaluate_row(std::size_t y, const Evaluation<Pixel>& to, Batch& batch,
                      Image<Pixel>& image);
    template <class Pixel>
    void evaluate(const Texture& texture, int threads, const Economy& economy, Image<Pixel>& image);
    /// Colours the cached field by a shader (procedural/fill/texel_shaders.h).
    template <class Shader>
    void recolor_with(const Shader& shader, int threads, const Economy& economy,
                      Image<typename Shader::Pixel>& image) const;
    /// Evaluates the field and its colours by a shader, and caches the field.
    template <class Shader>
    void evaluate_with(const Shader& shader, const Texture& texture, const Filter& filter,
                       int threads, const Economy& economy, Image<typename Shader::Pixel>& image);
    template <class Pixel, class Shader>
    void synthesize_with(const Shader& shader, const Texture& texture, const Filter& filter,
                         int threads, const Economy& economy, Image<Pixel>& image);
    void count_recolored(const Economy& economy) const;

    const SolidAtlas* solid_;
    Affine3 texture_from_atlas_;
    std::size_t budget_;
    Kernel kernel_;
    std::vector<TexelMap> maps_;  ///< texel maps to texture space; empty: to be computed
    KeptRows rows_;
    KeptLines lines_;
    bool lines_fit_ = false;  ///< whether the budget has room for span lines

    KeptArray<double> field_, quadric_;
    KeptArray<float> slopes_u_, slopes_v_;
    KeptArray<std::int32_t> entries_;    ///< entries of the cached f in the table of 8-bit colours
    std::optional<Wrap> known_entries_;  ///< wrap mode of valid `entries_`; empty: not valid
    std::optional<FieldKey> known_field_;
    KeptStart start_;  ///< prefix of the sum, cached in the memory of `field_`
    std::optional<Quadric> known_quadric_;
    std::vector<KeptOctave> octaves_;
    bool moved_ = false;  ///< whether the map changed since the last texture
    std::vector<NoiseKey> last_keys_;
    std::vector<Change> octave_changes_;
    std::optional<FieldKey> last_field_;
    Change quadric_change_;
    /// Flags of the last change of f: the quadric changed, then for each octave whether it changed;
    /// empty: f did not change.
    std::vector<bool> field_cause_;
    bool field_again_ = false;  ///< whether f changed in two calls running with the same flags
    std::uint64_t octaves_per_texel_ = 0;
    Work work_;
};

}  // namespace burl
