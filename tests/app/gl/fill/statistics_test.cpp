// Every preset with every filter through OpenGL, without stored pictures: statistics of |gl -
// host|, no channel that is no number, and the same bits from one run to the next. The everyday
// suite takes each preset with one filter in turn, for compiling a shader takes a tenth of a second
// to a second; the long one has all pairs.
#include <algorithm>
#include <cmath>
#include <ostream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/base/embedded.h"
#include "app/bench/meshes.h"
#include "app/gl/fill/synthesizer.h"
#include "app/pipeline/pipeline.h"
#include "app/recipe/edit/recipe_json.h"
#include "tests/app/gl/device/fixture.h"

namespace burl {
namespace {

struct Pair {
    std::string preset, filter;
};

void PrintTo(const Pair& pair, std::ostream* out) {
    *out << pair.preset << " with " << pair.filter;
}

constexpr std::string_view filters[] = {"none",  "table-mip", "table-sat",  "table-sat3",
                                        "exact", "trapezoid", "trapezoid2", "supersample"};

std::vector<std::string> statistics_presets() {
    std::vector<std::string> names;
    for (const EmbeddedFile& preset : embedded_recipes())
        names.emplace_back(preset.name.substr(0, preset.name.rfind('.')));
    return names;
}

std::vector<Pair> all_pairs() {
    std::vector<Pair> pairs;
    for (const std::string& preset : statistics_presets())
        for (const std::string_view filter : filters)
            pairs.push_back({preset, std::string(filter)});
    return pairs;
}

/// The filters in turn, apart for textures of the 1999 model and for graphs.
std::vector<Pair> pairs_in_turn() {
    std::vector<Pair> pairs;
    std::size_t next[2] = {0, 0};
    for (const std::string& preset : statistics_presets()) {
        std::size_t& turn = next[plain_texture(load_recipe(preset).texture) ? 0 : 1];
        pairs.push_back({preset, std::string(filters[turn++ % std::size(filters)])});
    }
    return pairs;
}

struct Differences {
    double mean = 0.0, largest = 0.0;
    std::size_t not_numbers = 0;
};

Differences differences(const Image<RgbF>& a, const Image<RgbF>& b) {
    Differences result;
    const std::size_t count = 3 * a.pixels().size();
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        const RgbF &p = a.pixels()[i], &q = b.pixels()[i];
        for (const auto& [x, y] : {std::pair(p.r, q.r), std::pair(p.g, q.g), std::pair(p.b, q.b)}) {
            if (!std::isfinite(x)) ++result.not_numbers;
            const double away = std::abs(double(x) - double(y));
            result.mean += away / double(count);
            result.largest = std::max(result.largest, away);
        }
    }
    return result;
}

class GlPresetFilterTest : public GlTest, public testing::WithParamInterface<Pair> {
  protected:
    static Image<RgbF> drawn(TextureSynthesizer& gl, Pipeline& pipeline) {
        Image<RgbF> image;
        gl.synthesize(pipeline.solid(), pipeline.recipe(), 2, &image);
        return image;
    }
};

TEST_P(GlPresetFilterTest, IsTheHostsAndRepeats) {
    const auto& [preset, filter] = GetParam();
    const Recipe recipe =
        load_recipe(preset, {"atlas.size=64", "atlas.kind=area", "filter.samples=4",
                             fmt::format("filter.kind={}", filter)});
    const std::unique_ptr<TextureSynthesizer> gl = make_gl_synthesizer(std::move(context));
    if (const std::string why = gl->problem(recipe); !why.empty()) {
        ASSERT_FALSE(plain_texture(recipe.texture)) << why;
        ASSERT_TRUE(filter.starts_with("table")) << why;
        GTEST_SKIP() << "refused: " << why;
    }
    // A graph's filtered nodes take sine, angle and power from the C library on the host.
    const bool nodes_filter =
        !plain_texture(recipe.texture) && filter != "none" && filter != "supersample";
    const double tolerance = nodes_filter ? 2e-6 : 0.0;
    Pipeline pipeline(torus(300));
    pipeline.set_recipe(recipe);
    const Image<RgbF> host = pipeline.synthesize<RgbF>(), first = drawn(*gl, pipeline);
    ASSERT_EQ(first.pixels().size(), host.pixels().size());
    const Differences away = differences(first, host);
    EXPECT_EQ(away.not_numbers, 0u);
    EXPECT_LE(away.mean, 0.1 * tolerance);
    EXPECT_LE(away.largest, tolerance);
    EXPECT_EQ(differing(drawn(*gl, pipeline), first), 0u) << "from the maps and shaders kept";
    gl->forget_atlas();
    EXPECT_EQ(differing(drawn(*gl, pipeline), first), 0u) << "from new maps";
}

std::string name_of(const testing::TestParamInfo<Pair>& test) {
    std::string name = test.param.preset + "_" + test.param.filter;
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(InTurn, GlPresetFilterTest, testing::ValuesIn(pairs_in_turn()), name_of);
INSTANTIATE_TEST_SUITE_P(LongAll, GlPresetFilterTest, testing::ValuesIn(all_pairs()), name_of);

}  // namespace
}  // namespace burl
