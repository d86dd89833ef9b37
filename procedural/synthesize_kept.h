#pragma once
// Textures synthesised again and again while somebody moves sliders: the field and every octave's
// unscaled noise are kept, and the next texture evaluates only what it does not share with the last
// one. Sums run over the kept noise in the order of a synthesis from scratch, so that the bytes are
// the same.
#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

#include "atlas/image.h"
#include "atlas/solid_atlas.h"
#include "procedural/field_sampler.h"
#include "procedural/kernel.h"

namespace burl {

/// Uninitialised numbers that begin on a line of the cache.
template <class T>
class KeptArray {
  public:
    KeptArray() = default;
    explicit KeptArray(std::size_t count)
        : data_(static_cast<T*>(std::aligned_alloc(64, count * sizeof(T) / 64 * 64 + 64))) {
        if (!data_) throw std::bad_alloc();
    }
    T* data() const { return data_.get(); }

  private:
    struct Free {
        void operator()(T* data) const { std::free(data); }
    };
    std::unique_ptr<T, Free> data_;
};

/// Textures without filter or band limit of one atlas. Not to be used by two threads at a time.
class KeptSynthesis {
  public:
    /// What the last call did. Octaves are those of expand_octaves.
    struct Work {
        bool field_kept = false;  ///< only the colours were new
        std::size_t octaves_kept = 0, octaves_evaluated = 0;
    };

    /// `solid` must outlive this. At most `budget` bytes are kept of texels: 8 each for the field,
    /// then 4 for every octave of the texture, as many as fit, then 8 for the quadric. With less
    /// memory more is worked out again; nothing else changes. (The texels' maps, 80 bytes a
    /// triangle, are not counted.)
    KeptSynthesis(const SolidAtlas& solid, const Affine3& texture_from_atlas, std::size_t budget,
                  Kernel kernel = Kernel::automatic);

    /// The bytes of synthesize_rgb8, _rgb16 or _rgbf, for Pixel Rgb8, Rgb16 or RgbF. An image of
    /// the atlas's size is written over; that spares the system clearing memory for another.
    template <class Pixel>
    void synthesize(const Texture& texture, int threads, Image<Pixel>& image);

    const Work& work() const { return work_; }
    /// Bytes kept of texels.
    std::size_t bytes() const;

  private:
    /// Texels that follow one another in a row.
    struct Run {
        std::uint32_t x = 0, count = 0;
    };
    struct KeptOctave {
        NoiseKey key;
        KeptArray<float> noise;
        bool known = false;  ///< since before this call
    };
    template <class Pixel>
    class RowPainter;

    void find_runs();
    std::span<const Run> runs(std::size_t y) const {
        return {runs_.data() + run_begin_[y], run_begin_[y + 1] - run_begin_[y]};
    }
    std::size_t bytes_per_texel() const {
        return row_begin_.back() > 0 ? budget_ / row_begin_.back() : 0;
    }
    std::vector<KeptOctave> keep(const std::vector<NoiseKey>& keys);
    /// Calls visit(first, count) for the kept texels of a row, a batch at a time.
    template <class Visit>
    void for_each_batch(std::size_t y, const Visit& visit) const;
    template <class Pixel>
    void recolor(const Texture& texture, int threads, Image<Pixel>& image) const;
    template <class Pixel>
    void evaluate(const Texture& texture, int threads, Image<Pixel>& image);

    const SolidAtlas* solid_;
    Affine3 texture_from_atlas_;
    std::size_t budget_;
    Kernel kernel_;
    std::vector<TexelMap> maps_;  ///< of the texture's coordinates; empty before the first call
    std::vector<Run> runs_;
    std::vector<std::size_t> run_begin_;  ///< N+1 offsets into runs_
    /// N+1 offsets into what is kept, multiples of a vector's length
    std::vector<std::size_t> row_begin_;

    KeptArray<double> field_, quadric_;
    bool field_known_ = false, quadric_known_ = false;
    Texture texture_;  ///< that they are of
    std::vector<KeptOctave> octaves_;
    Work work_;
};

}  // namespace burl
