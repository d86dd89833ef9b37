#include "procedural/fill/synthesize.h"

#include <memory>
#include <utility>

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

/// Stores the pixels of a shaded batch.
template <class Shader>
void store(const ShadedBatch& batch, const Shader& shader,
           const RowBand<typename Shader::Pixel>& image) {
    std::size_t at = 0;
    for (std::size_t i = 0; i < batch.pieces.size();) {
        auto* pixels = &image(batch.pieces[i].x, batch.pieces[i].y);
        const auto [end, count] = run_of(batch.pieces, i);
        if constexpr (requires { shader.pixels(batch, at, count, pixels); })
            shader.pixels(batch, at, count, pixels);
        else
            for (std::size_t j = 0; j < count; ++j) pixels[j] = shader.pixel(batch, at + j);
        at += count;
        i = end;
    }
}

/// The loop over rows of a texture, whose rows threads share out in groups.
template <class Shader>
struct RowLoop {
    const SolidAtlas& solid;
    const MovedMaps& maps;
    const FieldSampler& sampler;
    const Shader& shader;
    const Skips& skips;
    const RowGroups& groups;
    const RowBand<typename Shader::Pixel>& image;
    WorkSum& work;
    const Economy& economy;

    /// Fills the rows of the groups of `range`: f, colours and pixels, batch by batch.
    void operator()(const RowRange& range) const {
        const auto batch = std::make_unique_for_overwrite<ShadedBatch>();
        for (std::size_t group = range.begin(); group != range.end(); ++group) {
            const RowWindow rows{image.first + groups.begin(group),
                                 image.first + groups.begin(group + 1)};
            fill_outside(rows, batch->streams.work);
            PieceReader pieces(solid, maps, rows);
            while (pieces.read(*batch)) {
                if constexpr (requires { shader.sample(sampler, *batch); })
                    shader.sample(sampler, *batch);
                else
                    sampler.values(*batch);
                shader.shade(*batch);
                store(*batch, shader, image);
            }
            economy.count(1, texels_of(solid, rows.first, rows.end));
        }
        work.add(batch->streams.work += batch->corners.batch->streams.work);
    }

  private:
    /// Fills the rows' texels that no span owns, and counts the others.
    void fill_outside(const RowWindow& rows, SynthesisWork& done) const {
        const auto background = shader.background(0.0);
        for (std::size_t y = rows.first; y != rows.end; ++y) {
            const std::span<typename Shader::Pixel> row(&image(0, y), solid.size);
            const std::size_t texels = texels_of(solid.row(y));
            if (skips.allows(Skip::unread_texels)) {
                done.texels += texels;
                done.skip_texels(Skip::unread_texels, solid.size - texels);
                fill_gaps(solid.row(y), background, row);
            } else {
                done.texels += solid.size;
                for (auto& pixel : row) pixel = shader.background(0.0);
            }
        }
    }
};

/// The rows `window` of an image that a shader makes of the texture's field.
template <class Shader>
Image<typename Shader::Pixel> fill_rows(const SolidAtlas& solid, const Texture& texture,
                                        const Affine3& map, bool band_limit, int threads,
                                        Kernel kernel, const Economy& economy,
                                        const RowWindow& window, const Shader& shader) {
    const RowWindow rows = window.of(solid.size);
    auto image = Image<typename Shader::Pixel>::unset(solid.size, rows.count());
    const FieldSampler sampler(texture, band_limit, kernel, economy.skips);
    const MovedMaps maps(solid.maps, map);
    RowGroups groups(solid.size, 8 * batch_capacity);
    groups.size = rows.count();
    const RowBand band(image, rows.first);
    WorkSum work(economy.work);
    const RowLoop<Shader> loop{solid,  maps, sampler, shader, economy.skips,
                               groups, band, work,    economy};
    for_row_ranges(groups.count(), 1, threads, loop, economy.stop);
    return image;
}

/// The result of fill(shader) for the shader of the filter, whose tables are made here.
template <class Pixel, class Fill>
auto with_shader(const ColorMap& colors, const Filter& filter, const Fill& fill) {
    if (filter.kind == FilterKind::none) return fill(PointColor<Pixel>(colors));
    if (filter.kind == FilterKind::supersample)
        return fill(SupersampledColor<Pixel>(colors, filter.samples));
    return fill(FilteredColor<PointColor<Pixel>>(colors, filter.kind));
}

}  // namespace

template <class Pixel>
Image<Pixel> synthesize_model(const SolidAtlas& solid, const Texture& texture, const Affine3& map,
                              int threads, const Filter& filter, Kernel kernel,
                              const Economy& economy, const RowWindow& rows) {
    return with_shader<Pixel>(texture.colors, filter, [&](const auto& shader) {
        return fill_rows(solid, texture, map, filter.band_limit, threads, kernel, economy, rows,
                         shader);
    });
}

void synthesize_model_in_bands(const SolidAtlas& solid, const Texture& texture, const Affine3& map,
                               int threads, const Filter& filter, Kernel kernel,
                               const Economy& economy, std::size_t rows, const TakeRows& take) {
    with_shader<RgbF>(texture.colors, filter, [&](const auto& shader) {
        for (std::size_t first = 0; first < solid.size; first += rows)
            take(first, fill_rows(solid, texture, map, filter.band_limit, threads, kernel, economy,
                                  {first, first + rows}, shader));
    });
}

template Image<Rgb8> synthesize_model(const SolidAtlas&, const Texture&, const Affine3&, int,
                                      const Filter&, Kernel, const Economy&, const RowWindow&);
template Image<Rgb16> synthesize_model(const SolidAtlas&, const Texture&, const Affine3&, int,
                                       const Filter&, Kernel, const Economy&, const RowWindow&);
template Image<RgbF> synthesize_model(const SolidAtlas&, const Texture&, const Affine3&, int,
                                      const Filter&, Kernel, const Economy&, const RowWindow&);

Image<float> synthesize_field(const SolidAtlas& solid, const Texture& texture,
                              const Affine3& texture_from_atlas, int threads, Kernel kernel,
                              const Economy& economy) {
    return fill_rows(solid, texture, texture_from_atlas, false, threads, kernel, economy, {},
                     FieldCopy());
}

}  // namespace burl
