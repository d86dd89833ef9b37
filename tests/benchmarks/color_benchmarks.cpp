#include <memory>
#include <random>

#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/recipe.h"
#include "procedural/color/map_filter_kernels.h"
#include "procedural/color/srgb.h"
#include "procedural/color/table.h"
#include "tests/benchmarks/micro_benchmarks.h"

namespace burl {

namespace {

/// Field values of a batch, within a few turns of the map.
std::vector<double> random_field() {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> value(-3.0, 3.0);
    std::vector<double> field(batch_capacity + batch_padding);
    for (double& f : field) f = value(random);
    return field;
}

void register_look_up(const ColorMap& map) {
    struct Batch {
        explicit Batch(const ColorMap& colors) : table(colors) {}
        ColorTable8 table;
        std::vector<double> field = random_field();
        alignas(64) std::int32_t places[batch_capacity + batch_padding] = {};
        alignas(64) ColorCode codes[batch_capacity + batch_padding] = {};
        std::uint32_t later[batch_capacity + 2 * batch_padding] = {};
    };
    const auto batch = std::make_shared<Batch>(map);
    const auto index = [batch] {
        index_colors(batch->table.wrap(), batch->field.data(), batch_capacity, ColorTable8::places,
                     batch->places);
    };
    index();
    register_batch("index_colors", index);
    register_batch("ColorTable8::look_up", [batch] {
        batch->table.look_up(batch->places, batch->field.data(), batch_capacity, batch->codes,
                             batch->later);
    });
}

/// Footprints between these widths, both axes.
std::shared_ptr<FootprintStream> footprints(double least, double most) {
    std::mt19937 random(10);
    std::uniform_real_distribution<double> width(least, most);
    auto stream = std::make_shared<FootprintStream>();
    const std::vector<double> field = random_field();
    for (std::size_t j = 0; j < field.size(); ++j) {
        const double a = width(random), b = width(random);
        stream->f[j] = field[j];
        stream->wide[j] = std::max(a, b), stream->narrow[j] = std::min(a, b);
    }
    return stream;
}

void register_filters(const ColorMap& map) {
    const auto breaks = std::make_shared<const MapBreaks>(MapPieces(map));
    register_batch("filter_narrow", [breaks, stream = footprints(0.01, 0.2)] {
        filter_narrow(*breaks, *stream, batch_capacity);
    });
    const auto wide = footprints(0.1, 2.0);
    register_batch("filter_boxes", [=] { filter_boxes(*breaks, *wide, batch_capacity); });
    register_batch("filter_trapezoids", [=] { filter_trapezoids(*breaks, *wide, batch_capacity); });
}

}  // namespace

void register_color_benchmarks() {
    const ColorMap map = plain_texture(load_recipe("marble").texture)->colors;
    register_look_up(map);
    const auto linear = footprints(0.0, 1.0);  // its widths are as good as light
    register_batch(
        "SrgbStreamEncoder",
        [linear, encode = SrgbStreamEncoder(),
         codes = std::vector<std::uint8_t>(batch_capacity + 64 + batch_padding)]() mutable {
            auto* at = codes.data();
            while (reinterpret_cast<std::uintptr_t>(at) % 64 != 0) ++at;
            encode(linear->wide, batch_capacity, at);
        });
    register_filters(map);
}

}  // namespace burl
