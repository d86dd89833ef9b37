#pragma once
// Textures synthesised again and again while somebody moves sliders: the field, its slopes where a
// filter wants them, and every octave's unscaled noise are kept, and the next texture evaluates
// only what it does not share with the last one. Sums run over the kept noise in the order of a
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

/// Textures of one atlas. Not to be used by two threads at a time.
class KeptSynthesis {
  public:
    /// What the last call did. Octaves are those of expand_octaves.
    struct Work {
        bool field_kept = false;  ///< only the colours were new
        std::size_t octaves_kept = 0, octaves_evaluated = 0;
    };

    /// `solid` must outlive this. At most `budget` bytes are kept of texels: 8 each for the field,
    /// then 4 for every octave of the texture, as many as fit, then 8 for the quadric, while
    /// octaves change 52 for every span, and while colours change 4 for f's place in the colour
    /// map; with a filter 8 for the field and 8 for its slopes, no octaves. With less memory more
    /// is worked out again; nothing else changes. (The texels' maps, 80 bytes a triangle, are not
    /// counted.)
    KeptSynthesis(const SolidAtlas& solid, const Affine3& texture_from_atlas, std::size_t budget,
                  Kernel kernel = Kernel::automatic);

    /// Another map from the atlas's space to the texture's; all that was kept is worth nothing.
    void set_map(const Affine3& texture_from_atlas);
    Kernel kernel() const { return kernel_; }

    /// The bytes of synthesize_rgb8, _rgb16 or _rgbf, for Pixel Rgb8, Rgb16 or RgbF. An image of
    /// the atlas's size is written over; that spares the system clearing memory for another.
    /// An octave or quadric that is new twice running, as while a slider of it moves, is not kept
    /// until it stays, nor is a field that is new twice for the same reason: its place has the sum
    /// of what comes before the octaves that move. Supersampled textures, and without a filter
    /// those of a band limit, keep no octaves.
    template <class Pixel>
    void synthesize(const Texture& texture, int threads, Image<Pixel>& image,
                    const Filter& filter = {}, const Economy& economy = {});

    const Work& work() const { return work_; }
    /// Bytes kept of texels.
    std::size_t bytes() const;

  private:
    struct KeptOctave {
        NoiseKey key{};
        KeptArray<float> noise{};
        bool known = false;  ///< since before this call
    };
    /// What f and its slopes depend on besides the atlas; the kinds of filters that want the same
    /// of f count as one of them.
    struct FieldKey {
        Quadric quadric{};
        std::vector<NoiseTerm> noise{};
        FilterKind kind = FilterKind::none;
        bool band_limit = false;
        bool operator==(const FieldKey&) const = default;
    };
    static FieldKey field_key(const Texture& texture, const Filter& filter);
    /// What changed from the texture before, and whether it had changed then, too.
    struct Change {
        bool now = false, again = false;
        void note(bool changed) { again = std::exchange(now, changed) && changed; }
    };

    std::size_t bytes_per_texel() const { return rows_.size() > 0 ? budget_ / rows_.size() : 0; }
    void forget();
    void forget_octaves();
    std::vector<KeptOctave> keep(const std::vector<NoiseKey>& keys);
    void note_changes(const std::vector<NoiseKey>& keys, const FieldKey& field);
    /// Whether there is room for f, and for its slopes if the filter wants them.
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
    /// By a shader (procedural/fill/texel_shaders.h).
    template <class Shader>
    void recolor_with(const Shader& shader, int threads, const Economy& economy,
                      Image<typename Shader::Pixel>& image) const;
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
    std::vector<TexelMap> maps_;  ///< of the texture's coordinates; empty before the first call
    KeptRows rows_;
    KeptLines lines_;
    bool lines_fit_ = false;  ///< within the budget

    KeptArray<double> field_, quadric_;
    KeptArray<float> slopes_u_, slopes_v_;
    KeptArray<std::int32_t> entries_;    ///< of the known field in tables of 8-bit colours
    std::optional<Wrap> known_entries_;  ///< for which they hold
    std::optional<FieldKey> known_field_;
    KeptStart start_;  ///< where the field would be
    std::optional<Quadric> known_quadric_;
    std::vector<KeptOctave> octaves_;
    bool moved_ = false;  ///< since the last texture
    std::vector<NoiseKey> last_keys_;
    std::vector<Change> octave_changes_;
    std::optional<FieldKey> last_field_;
    Change quadric_change_;
    /// Whether the quadric and which octaves changed when f did last; empty: f did not.
    std::vector<bool> field_cause_;
    bool field_again_ = false;  ///< f changed for the same reason as before
    std::uint64_t octaves_per_texel_ = 0;
    Work work_;
};

}  // namespace burl
