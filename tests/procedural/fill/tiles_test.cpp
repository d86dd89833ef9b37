// Textures of a part of an atlas against those of the whole: bytes must agree wherever the part
// reaches, whatever kernel, filter or precision makes them.
#include "atlas/solid/texel_set.h"

#include <gtest/gtest.h>

#include "procedural/fill/forward.h"
#include "procedural/fill/graph.h"
#include "procedural/fill/synthesize.h"
#include "procedural/fill/texels.h"
#include "tests/procedural/graph/cases.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

const Affine3 tiles_twice{2.0 * Mat3d(1.0), Vec3d(0.25, 0.0, -1.0)};

Texture tiles_marble(NoiseKind kind, Fade fade) {
    Texture texture;
    texture.quadric.i = 0.5, texture.quadric.a = 0.3;
    NoiseTerm term;
    term.kind = kind, term.fade = fade, term.octaves = 3;
    term.amplitude = 0.7, term.frequency = Vec3d(2.1, 1.9, 2.0);
    texture.noise = {term};
    texture.colors.stops = {{-1.0, {244, 39, 230}}, {0.2, {0, 200, 30}}, {1.0, {59, 58, 164}}};
    return texture;
}

/// Single texels and cells, about a third of all.
TexelSet some_texels(std::uint32_t size, std::uint32_t seed) {
    std::mt19937 random(seed);
    TexelSet texels(size), cells(size);
    const auto insert_any = [&](TexelSet& set) {
        const std::uint32_t x = std::uint32_t(random()) % size;
        set.insert(x, std::uint32_t(random()) % size);
    };
    for (std::uint32_t i = 0; i < size * size / 16; ++i) insert_any(texels);
    for (std::uint32_t i = 0; i < size * size / 512; ++i) insert_any(cells);
    texels |= cells.whole_cells(8);
    return texels;
}

/// `make(atlas)` of the part equals that of the whole in the part's spans, and elsewhere shows what
/// no span owns.
template <class Make>
void expect_part_of_whole(const SolidAtlas& solid, const Make& make, const std::string& what) {
    const TexelSet wanted = some_texels(solid.size, 3);
    const SolidAtlas part = cut_to(solid, wanted);
    const auto whole = make(solid), cut = make(part);
    SolidAtlas nothing = solid;
    nothing.spans.clear();
    nothing.row_begin.assign(solid.size + 1, 0);
    const auto background = make(nothing)(0, 0);
    std::size_t same = 0, left_out = 0, wrong = 0;
    for (std::uint32_t y = 0; y < solid.size; ++y) {
        TexelSet owned(solid.size);
        for (const Span& span : solid.row(y)) owned.insert({span.x, span.x + span.count}, y);
        for (std::uint32_t x = 0; x < solid.size; ++x) {
            const bool is_in = owned.contains(x, y) && wanted.contains(x, y);
            wrong += !(cut(x, y) == (is_in ? whole(x, y) : background));
            same += is_in;
            left_out += !is_in && !(whole(x, y) == background);
        }
    }
    EXPECT_EQ(wrong, 0u) << what;
    EXPECT_GT(same, 500u) << what;
    EXPECT_GT(left_out, 500u) << what;
}

/// Short spans, and one a row, which scan lines take.
std::vector<SolidAtlas> atlases() {
    return {SyntheticAtlas{64, 16, 0.0, 0.02, true}.make(1),
            SyntheticAtlas{160, 160, 0.0, 0.002, false}.make(2)};
}

TEST(CutTo, KeepsTheWantedTexelsAndTheirMaps) {
    const SolidAtlas solid = SyntheticAtlas{}.make(4);
    const TexelSet wanted = some_texels(solid.size, 5);
    const SolidAtlas part = cut_to(solid, wanted);
    std::uint64_t texels = 0;
    for (std::uint32_t y = 0; y < solid.size; ++y) {
        std::uint32_t end = 0;
        for (const Span& span : part.row(y)) {
            EXPECT_GE(span.x, end);
            end = span.x + span.count;
            for (std::uint32_t x = span.x; x < end; ++x) EXPECT_TRUE(wanted.contains(x, y));
        }
        for (const Span& span : solid.row(y))
            for (std::uint32_t x = span.x; x < span.x + span.count; ++x) {
                if (!wanted.contains(x, y)) continue;
                ++texels;
                const auto owner = std::ranges::find_if(
                    part.row(y), [&](const Span& s) { return x >= s.x && x < s.x + s.count; });
                ASSERT_NE(owner, part.row(y).end());
                EXPECT_EQ(owner->map, span.map);
                EXPECT_EQ(part.whole(*owner).x, span.x);
                EXPECT_EQ(part.whole(*owner).count, span.count);
            }
    }
    EXPECT_EQ(texel_count(part), texels);
    EXPECT_GT(texels, 500u);
    const SolidAtlas again = cut_to(part, some_texels(solid.size, 6));
    for (const Span& span : again.row(20)) {
        const auto owner = std::ranges::find(solid.row(20), span.map, &Span::map);
        EXPECT_EQ(again.whole(span).x, owner->x);
    }
}

TEST(SynthesizeTiles, PointSamplesOfEveryKernel) {
    for (const SolidAtlas& solid : atlases())
        for (const NoiseKind kind : {NoiseKind::value, NoiseKind::perlin, NoiseKind::simplex})
            for (const Fade fade : {Fade::linear, Fade::smooth})
                for (const auto& [name, kernel] : kernel_names) {
                    const Texture texture = tiles_marble(kind, fade);
                    expect_part_of_whole(
                        solid,
                        [&](const SolidAtlas& atlas) {
                            return synthesize_model<RgbF>(atlas, texture, tiles_twice, 2, {},
                                                          kernel);
                        },
                        std::string(name));
                    expect_part_of_whole(
                        solid,
                        [&](const SolidAtlas& atlas) {
                            return synthesize_model<Rgb8>(atlas, texture, tiles_twice, 2, {},
                                                          kernel);
                        },
                        std::string(name));
                }
}

TEST(SynthesizeTiles, EveryFilter) {
    const Texture texture = tiles_marble(NoiseKind::perlin, Fade::quintic);
    for (const SolidAtlas& solid : atlases())
        for (const FilterKind kind :
             {FilterKind::table_mip, FilterKind::table_sat, FilterKind::table_sat3,
              FilterKind::exact, FilterKind::trapezoid, FilterKind::trapezoid2,
              FilterKind::supersample})
            for (const bool fades : {false, true}) {
                Filter filter{kind, 3};
                filter.band_limit = fades;
                expect_part_of_whole(
                    solid,
                    [&](const SolidAtlas& atlas) {
                        return synthesize_model<RgbF>(atlas, texture, tiles_twice, 2, filter);
                    },
                    "filter " + std::to_string(int(kind)));
            }
}

TEST(SynthesizeTiles, EveryPrecision) {
    const Texture texture = tiles_marble(NoiseKind::value, Fade::smooth);
    for (const SolidAtlas& solid : atlases()) {
        for (const PrecisionKind kind : {PrecisionKind::float64, PrecisionKind::fixed})
            expect_part_of_whole(
                solid,
                [&](const SolidAtlas& atlas) {
                    return synthesize_texels<Rgb16>(atlas, texture, tiles_twice, {kind, {}}, {}, 2);
                },
                "texel by texel");
        for (const ForwardPrecision kind : {ForwardPrecision::float32, ForwardPrecision::float64})
            expect_part_of_whole(
                solid,
                [&](const SolidAtlas& atlas) {
                    return synthesize_forward<Rgb8>(atlas, texture, tiles_twice, kind, 2);
                },
                "forward differences");
    }
}

TEST(SynthesizeTiles, Graphs) {
    const TextureGraph graph = graph_of(R"({"node": "mix", "a": {"node": "marble"}, "b": "#204080",
        "amount": {"node": "abs", "input": {"node": "fbm", "octaves": 3}}})");
    for (const SolidAtlas& solid : atlases())
        for (const Filter& filter :
             {Filter{}, Filter{FilterKind::trapezoid}, Filter{FilterKind::supersample, 3}})
            expect_part_of_whole(
                solid,
                [&](const SolidAtlas& atlas) {
                    return synthesize_graph<RgbF>(atlas, graph, tiles_twice, filter, 2);
                },
                "graph");
}

}  // namespace
}  // namespace burl
