#include "procedural/synthesize.h"

#include <algorithm>
#include <memory>

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "procedural/color_table.h"
#include "procedural/noise.h"
#include "procedural/noise_kernels.h"
#include "procedural/octaves.h"

namespace burl {

namespace {

/// Consecutive texels of one row of the image and the line of solid coordinates they show.
struct Piece {
    std::size_t x = 0, y = 0;
    LatticeLine solid;
};

/// What a thread works with: pieces of several spans packed into one stream of texels.
struct Batch {
    std::vector<Piece> pieces;
    std::size_t count = 0;
    std::vector<LatticeLine> lines;
    std::vector<ParabolaLine> parabolas;
    LatticeBatch lattice;
    alignas(64) double field[batch_capacity + batch_padding];
    alignas(64) std::int32_t entries[batch_capacity + batch_padding];
};

/// Whether add_noise knows the octave's noise.
bool has_kernel(const Octave& octave) {
    const NoiseSpec& noise = octave.noise;
    return (noise.kind == NoiseKind::value || noise.kind == NoiseKind::perlin) &&
           noise.period == Period<4>{} && octave.shape == OctaveShape::plain;
}

/// Texel by texel in float32, for the other noises: adds the octave to batch.field.
void add_scalar_noise(const Octave& octave, Batch& batch) {
    double* sum = batch.field;
    for (const LatticeLine& line : batch.lines)
        for (std::size_t j = 0; j < line.count; ++j) {
            const Vec3d p = line.start + (line.first + double(j)) * line.step;
            const float n = noise_value<float, 3>(octave.noise, {p.x, p.y, p.z});
            *sum++ += octave.scale * double(shaped(octave.shape, n));
        }
}

/// The texture's field prepared for batches. Every texel is computed from its own span's start and
/// its distance from it, so the batches' limits leave no trace.
class FieldSampler {
  public:
    explicit FieldSampler(const Texture& texture)
        : quadric_(texture.quadric), octaves_(expand_octaves(texture)) {
        for (const Octave& octave : octaves_) constant_ += octave.offset;
    }

    /// batch.field = f of the texels of batch.pieces.
    void operator()(Batch& batch) const {
        fill_quadric(batch);
        for (const Octave& octave : octaves_) {
            fill_lines(octave.lattice_from_solid, batch);
            if (!has_kernel(octave)) {
                add_scalar_noise(octave, batch);
                continue;
            }
            split_lattice_lines(batch.lines, batch.lattice);
            add_noise(octave.noise.kind, octave.noise.fade, octave.noise.seed, octave.scale,
                      batch.lattice, batch.count, batch.field);
        }
    }

  private:
    /// The quadric along a line is a parabola; the noise's constant parts come with it.
    void fill_quadric(Batch& batch) const {
        batch.parabolas.clear();
        for (const Piece& piece : batch.pieces) {
            const auto& [start, step, first, count] = piece.solid;
            const Vec3d direction = half_gradient(quadric_, step) - half_gradient(quadric_, {});
            batch.parabolas.push_back({evaluate_quadric(quadric_, start) + constant_,
                                       2.0 * glm::dot(half_gradient(quadric_, start), step),
                                       glm::dot(step, direction), first, count});
        }
        fill_parabolas(batch.parabolas, batch.field);
    }

    static void fill_lines(const Affine3& map, Batch& batch) {
        batch.lines.clear();
        for (const Piece& piece : batch.pieces) {
            LatticeLine line{map(piece.solid.start), map.linear * piece.solid.step,
                             piece.solid.first, piece.solid.count};
            const double last = line.first + double(line.count);
            for (int axis = 0; axis < 3; ++axis) {
                const double reach = std::abs(line.start[axis]) + last * std::abs(line.step[axis]);
                if (!(reach < lattice_limit)) line.start[axis] = line.step[axis] = 0.0;
            }
            batch.lines.push_back(line);
        }
    }

    Quadric quadric_;
    std::vector<Octave> octaves_;
    double constant_ = 0.0;
};

/// Colours (or copies) the field values of a piece; `at` is the piece's first texel in the batch.
class FieldCopy {
  public:
    using Pixel = float;
    void prepare(Batch&) const {}
    float pixel(const Batch& batch, std::size_t at) const { return float(batch.field[at]); }
    float background(double f) const { return float(f); }
};

class Color8 {
  public:
    using Pixel = Rgb8;
    explicit Color8(const ColorMap& map) : table_(map) {}
    void prepare(Batch& batch) const {
        index_colors(table_.wrap(), batch.field, batch.count, ColorTable8::entry_count,
                     batch.entries);
    }
    Rgb8 pixel(const Batch& batch, std::size_t at) const {
        return table_.color(std::uint32_t(batch.entries[at]), batch.field[at]);
    }
    Rgb8 background(double f) const { return table_(f); }

  private:
    ColorTable8 table_;
};

class Color16 {
  public:
    using Pixel = Rgb16;
    explicit Color16(const ColorMap& map) : map_(map) {}
    void prepare(Batch&) const {}
    Rgb16 pixel(const Batch& batch, std::size_t at) const { return background(batch.field[at]); }
    Rgb16 background(double f) const {
        const Vec3d linear = map_(f);
        return {encode_(linear.x), encode_(linear.y), encode_(linear.z)};
    }

  private:
    PreparedColorMap map_;
    SrgbEncoder<std::uint16_t> encode_;
};

class ColorF {
  public:
    using Pixel = RgbF;
    explicit ColorF(const ColorMap& map) : map_(map) {}
    void prepare(Batch&) const {}
    RgbF pixel(const Batch& batch, std::size_t at) const { return background(batch.field[at]); }
    RgbF background(double f) const {
        const Vec3d linear = map_(f);
        return {float(linear.x), float(linear.y), float(linear.z)};
    }

  private:
    PreparedColorMap map_;
};

template <class Shader>
void flush(Batch& batch, const FieldSampler& sampler, const Shader& shader,
           Image<typename Shader::Pixel>& image) {
    if (batch.count == 0) return;
    sampler(batch);
    shader.prepare(batch);
    std::size_t at = 0;
    for (const Piece& piece : batch.pieces) {
        auto* pixels = &image(piece.x, piece.y);
        for (std::size_t j = 0; j < piece.solid.count; ++j) pixels[j] = shader.pixel(batch, at + j);
        at += piece.solid.count;
    }
    batch.pieces.clear();
    batch.count = 0;
}

template <class Shader>
void synthesize_rows(const SolidAtlas& solid, const Affine3& map, const FieldSampler& sampler,
                     const Shader& shader, tbb::blocked_range<std::size_t> rows,
                     Image<typename Shader::Pixel>& image) {
    const auto batch = std::make_unique<Batch>();
    for (std::size_t y = rows.begin(); y != rows.end(); ++y) {
        for (const Span& span : solid.row(y)) {
            const TexelMap& texel = solid.maps[span.map];
            const LatticeLine line{map(texel(span.x, std::int64_t(y))), map.linear * texel.step_x};
            for (std::size_t done = 0; done < span.count;) {
                const std::size_t count =
                    std::min(span.count - done, batch_capacity - batch->count);
                batch->pieces.push_back(
                    {span.x + done, y, {line.start, line.step, double(done), count}});
                batch->count += count;
                done += count;
                if (batch->count == batch_capacity) flush(*batch, sampler, shader, image);
            }
        }
    }
    flush(*batch, sampler, shader, image);
}

template <class Shader>
Image<typename Shader::Pixel> synthesize(const SolidAtlas& solid, const Texture& texture,
                                         const Affine3& map, int threads, const Shader& shader) {
    Image<typename Shader::Pixel> image(solid.size, solid.size, shader.background(0.0));
    const FieldSampler sampler(texture);
    // Enough rows to fill a few batches; the grain decides only who works, not what comes out.
    const std::size_t grain = std::max<std::size_t>(1, 8 * batch_capacity / (solid.size + 1));
    const auto most =
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    tbb::task_arena arena(threads > 0 ? std::min(threads, int(most)) : tbb::task_arena::automatic);
    arena.execute([&] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, solid.size, grain),
                          [&](const tbb::blocked_range<std::size_t>& rows) {
                              synthesize_rows(solid, map, sampler, shader, rows, image);
                          });
    });
    return image;
}

}  // namespace

Image<Rgb8> synthesize_rgb8(const SolidAtlas& solid, const Texture& texture,
                            const Affine3& texture_from_atlas, int threads) {
    return synthesize(solid, texture, texture_from_atlas, threads, Color8(texture.colors));
}

Image<Rgb16> synthesize_rgb16(const SolidAtlas& solid, const Texture& texture,
                              const Affine3& texture_from_atlas, int threads) {
    return synthesize(solid, texture, texture_from_atlas, threads, Color16(texture.colors));
}

Image<RgbF> synthesize_rgbf(const SolidAtlas& solid, const Texture& texture,
                            const Affine3& texture_from_atlas, int threads) {
    return synthesize(solid, texture, texture_from_atlas, threads, ColorF(texture.colors));
}

Image<float> synthesize_field(const SolidAtlas& solid, const Texture& texture,
                              const Affine3& texture_from_atlas, int threads) {
    return synthesize(solid, texture, texture_from_atlas, threads, FieldCopy());
}

}  // namespace burl
