#include "procedural/fill/synthesize.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "procedural/batch/work_sum.h"
#include "procedural/fill/pieces.h"
#include "procedural/fill/texel_shaders.h"

namespace burl {

namespace {

/// The run of pieces from `begin` on that follow one another in a row of the image: the end of the
/// run, and the number of its texels.
std::pair<std::size_t, std::size_t> run_of(std::span<const Piece> pieces, std::size_t begin) {
    std::size_t end = begin + 1, count = pieces[begin].solid.count;
    while (end < pieces.size() && pieces[end].y == pieces[begin].y &&
           pieces[end].x == pieces[begin].x + count)
        count += pieces[end++].solid.count;
    return {end, count};
}

/// Rows of the texture from `first` on.
template <class Pixel>
struct Band {
    Image<Pixel>& image;
    std::size_t first = 0;

    Pixel* at(std::size_t x, std::size_t y) const { return &image(x, y - first); }
    std::span<Pixel> row(std::size_t y) const { return image.row(y - first); }
};

/// Evaluates and colours the batch, and stores its pixels.
template <class Shader>
void flush(ShadedBatch& batch, const FieldSampler& sampler, const Shader& shader,
           const Band<typename Shader::Pixel>& band) {
    if (batch.count == 0) return;
    shader.sample(sampler, batch);
    shader.shade(batch);
    std::size_t at = 0;
    for (std::size_t i = 0; i < batch.pieces.size();) {
        auto* pixels = band.at(batch.pieces[i].x, batch.pieces[i].y);
        const auto [end, count] = run_of(batch.pieces, i);
        if constexpr (requires { shader.pixels(batch, at, count, pixels); })
            shader.pixels(batch, at, count, pixels);
        else
            for (std::size_t j = 0; j < count; ++j) pixels[j] = shader.pixel(batch, at + j);
        at += count;
        i = end;
    }
    batch.pieces.clear();
    batch.count = 0;
}

/// Fills the rows of some groups and returns the work done.
template <class Shader>
SynthesisWork synthesize_rows(const SolidAtlas& solid, const MovedMaps& maps,
                              const FieldSampler& sampler, const Shader& shader, const Skips& skips,
                              const RowGroups& groups, const RowRange& range,
                              const Band<typename Shader::Pixel>& band) {
    const auto background = shader.background(0.0);
    const auto batch = std::make_unique_for_overwrite<ShadedBatch>();
    SynthesisWork& work = batch->streams.work;
    const auto empty = [&] { flush(*batch, sampler, shader, band); };
    for (std::size_t y = groups.begin(range.begin()); y != groups.begin(range.end()); ++y) {
        if (y % groups.rows == 0) empty();
        const std::size_t texels = texels_of(solid.row(y));
        if (skips.allows(Skip::unread_texels)) {
            work.texels += texels;
            work.skip_texels(Skip::unread_texels, solid.size - texels);
            fill_gaps(solid.row(y), background, band.row(y));
        } else {
            work.texels += solid.size;
            for (auto& pixel : band.row(y)) pixel = shader.background(0.0);
        }
        add_row(solid, maps, y, *batch, empty);
    }
    empty();
    return work += batch->corners.batch->streams.work;
}

/// A texture prepared for synthesis of some groups of rows at a time.
template <class Shader>
class RowSynthesis {
  public:
    using Pixel = typename Shader::Pixel;

    RowSynthesis(const SolidAtlas& solid, const Texture& texture, const Affine3& map,
                 const Filter& filter, Kernel kernel, const Economy& economy, const Shader& shader)
        : groups(solid.size, 8 * batch_capacity),
          solid_(solid),
          economy_(economy),
          shader_(shader),
          sampler_(texture, filter.band_limit, kernel, economy.skips),
          maps_(solid.maps, map) {}

    /// Fills the rows of groups [begin, end); row 0 of the image is the first of them.
    void fill(std::size_t begin, std::size_t end, int threads, Image<Pixel>& image) const {
        WorkSum work(economy_.work);
        const Band<Pixel> band{image, groups.begin(begin)};
        const auto fill_groups = [&](const RowRange& range) {
            const RowRange these(begin + range.begin(), begin + range.end());
            work.add(synthesize_rows(solid_, maps_, sampler_, shader_, economy_.skips, groups,
                                     these, band));
        };
        for_row_ranges(end - begin, 1, threads, fill_groups, economy_.stop);
    }

    const RowGroups groups;

  private:
    const SolidAtlas& solid_;
    const Economy& economy_;
    const Shader& shader_;
    FieldSampler sampler_;
    MovedMaps maps_;
};

template <class Shader>
Image<typename Shader::Pixel> synthesize(const SolidAtlas& solid, const Texture& texture,
                                         const Affine3& map, const Filter& filter, int threads,
                                         Kernel kernel, const Economy& economy,
                                         const Shader& shader) {
    auto image = Image<typename Shader::Pixel>::unset(solid.size, solid.size);
    const RowSynthesis<Shader> rows(solid, texture, map, filter, kernel, economy, shader);
    rows.fill(0, rows.groups.count(), threads, image);
    return image;
}

/// Returns use(shader) with the shader of the filter.
template <class Pixel, class Use>
auto with_colors(const ColorMap& colors, const Filter& filter, const Use& use) {
    if (filter.kind == FilterKind::none) return use(PointColor<Pixel>(colors));
    if (filter.kind == FilterKind::supersample)
        return use(SupersampledColor<Pixel>(colors, filter.samples));
    return use(FilteredColor<PointColor<Pixel>>(colors, filter.kind));
}

template <class Pixel>
Image<Pixel> synthesize_colors(const SolidAtlas& solid, const Texture& texture, const Affine3& map,
                               const Filter& filter, int threads, Kernel kernel,
                               const Economy& economy) {
    return with_colors<Pixel>(texture.colors, filter, [&](const auto& shader) {
        return synthesize(solid, texture, map, filter, threads, kernel, economy, shader);
    });
}

}  // namespace

Image<Rgb8> synthesize_rgb8(const SolidAtlas& solid, const Texture& texture,
                            const Affine3& texture_from_atlas, int threads, const Filter& filter,
                            Kernel kernel, const Economy& economy) {
    return synthesize_colors<Rgb8>(solid, texture, texture_from_atlas, filter, threads, kernel,
                                   economy);
}

Image<Rgb16> synthesize_rgb16(const SolidAtlas& solid, const Texture& texture,
                              const Affine3& texture_from_atlas, int threads, const Filter& filter,
                              Kernel kernel, const Economy& economy) {
    return synthesize_colors<Rgb16>(solid, texture, texture_from_atlas, filter, threads, kernel,
                                    economy);
}

Image<RgbF> synthesize_rgbf(const SolidAtlas& solid, const Texture& texture,
                            const Affine3& texture_from_atlas, int threads, const Filter& filter,
                            Kernel kernel, const Economy& economy) {
    return synthesize_colors<RgbF>(solid, texture, texture_from_atlas, filter, threads, kernel,
                                   economy);
}

void synthesize_rgbf_bands(const SolidAtlas& solid, const Texture& texture,
                           const Affine3& texture_from_atlas, int threads, const Filter& filter,
                           Kernel kernel, const Economy& economy, std::size_t texels,
                           const TakeRows& take) {
    const auto in_bands = [&](const auto& shader) {
        const RowSynthesis rows(solid, texture, texture_from_atlas, filter, kernel, economy,
                                shader);
        const RowGroups& groups = rows.groups;
        const std::size_t least = band_rows * groups.rows * solid.size;
        const std::size_t at_once = band_rows * std::max<std::size_t>(1, texels / least);
        for (std::size_t begin = 0; begin < groups.count(); begin += at_once) {
            const std::size_t end = std::min(begin + at_once, groups.count());
            const std::size_t first = groups.begin(begin);
            auto band = Image<RgbF>::unset(solid.size, groups.begin(end) - first);
            rows.fill(begin, end, threads, band);
            take(first, std::move(band));
        }
    };
    with_colors<RgbF>(texture.colors, filter, in_bands);
}

Image<float> synthesize_field(const SolidAtlas& solid, const Texture& texture,
                              const Affine3& texture_from_atlas, int threads, Kernel kernel,
                              const Economy& economy) {
    return synthesize(solid, texture, texture_from_atlas, {}, threads, kernel, economy,
                      FieldCopy());
}

}  // namespace burl
