#include "app/pipeline/picture_bands.h"

#include <chrono>
#include <cstdint>

namespace burl {

template <class Pixel>
std::vector<Image<Pixel>> PictureBands<Pixel>::rows(const StageContext& context,
                                                    const SolidAtlas& solid,
                                                    const RowWindow& window) {
    const auto start = std::chrono::steady_clock::now();
    std::vector<Image<Pixel>> bands = synthesize_pictures<Pixel>(
        solid, recipe_.texture, plans_, texture_from_solid(recipe_), recipe_.filter,
        context.way.threads, recipe_.precision.kind.value_or(PrecisionKind::float32),
        {context.skips, &cost_.work, context.stop, context.meter}, masks_, window);
    for (const Image<Pixel>& band : bands) cost_.bytes += bytes_of(band);
    seconds_ += seconds_since(start);
    return bands;
}

SolidAtlas with_own_maps(SolidAtlas solid) {
    constexpr std::uint32_t none = 0xffffffff;
    std::vector<std::uint32_t> numbers(solid.maps.size(), none);
    std::vector<TexelMap> maps;
    for (Span& span : solid.spans) {
        std::uint32_t& number = numbers[span.map];
        if (number == none) {
            number = std::uint32_t(maps.size());
            maps.push_back(solid.maps[span.map]);
        }
        span.map = number;
    }
    maps.shrink_to_fit();
    solid.maps = std::move(maps);
    solid.turned = {};
    return solid;
}

template class PictureBands<Rgba8>;
template class PictureBands<Rgba16>;
template class PictureBands<RgbaF>;

}  // namespace burl
