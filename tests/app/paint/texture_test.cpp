// Paint against a search over every texel and every segment, with distances by another formula; and
// paint that is kept against paint made anew.
#include "app/paint/texture.h"
#include "app/recipe/edit/recipe_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "app/pipeline/pipeline.h"
#include "atlas/build/block_levels.h"
#include "procedural/color/srgb.h"
#include "tests/app/support/sample_scene.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

using Random = std::mt19937;

double uniform(Random& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

PaintStroke random_stroke(Random& random, double reach) {
    PaintStroke stroke;
    const auto count = std::size_t(uniform(random, 1.0, 5.99));
    for (std::size_t i = 0; i < count; ++i)
        stroke.points.emplace_back(uniform(random, -reach, reach), uniform(random, -reach, reach),
                                   uniform(random, -reach, reach));
    stroke.radius = uniform(random, 0.05, 0.3);
    stroke.hardness = uniform(random, 0.0, 1.0);
    stroke.opacity = uniform(random, 0.2, 1.0);
    stroke.color = {std::uint8_t(random()), std::uint8_t(random()), std::uint8_t(random())};
    if (random() % 4 == 0) stroke.mode = PaintMode::erase;
    return stroke;
}

std::vector<PaintStroke> random_strokes(std::uint32_t seed, std::size_t count, double reach) {
    Random random(seed);
    std::vector<PaintStroke> strokes(count);
    for (PaintStroke& stroke : strokes) stroke = random_stroke(random, reach);
    return strokes;
}

/// By the angles at the segment's ends: beside it the area over the length, else the nearer end.
double distance_from(const Vec3d& p, const Vec3d& a, const Vec3d& b) {
    if (glm::dot(p - a, b - a) <= 0.0) return glm::length(p - a);
    if (glm::dot(p - b, a - b) <= 0.0) return glm::length(p - b);
    return glm::length(glm::cross(p - a, p - b)) / glm::length(b - a);
}

/// A texel's point and the longer of its steps.
struct Texel {
    Vec3d point{0.0};
    double width = 0.0;
};

double coverage_of(const PaintStroke& stroke, const Texel& texel) {
    double least = 1e300;
    for (std::size_t i = 0; i < stroke.points.size(); ++i)
        least = std::min(
            least, distance_from(texel.point, stroke.points[i], stroke.points[i == 0 ? 0 : i - 1]));
    const double x = least / stroke.radius;
    const double hardness =
        std::max(0.0, std::min(stroke.hardness, 1.0 - texel.width / stroke.radius));
    if (x >= 1.0) return 0.0;
    if (x <= hardness) return 1.0;
    const double t = 1.0 - (x - hardness) / (1.0 - hardness);
    return 3.0 * t * t - 2.0 * t * t * t;
}

/// Colour and alpha one after the other, not multiplied.
Vec3d painted_slowly(const std::vector<PaintStroke>& strokes, const Texel& texel,
                     const Vec3d& below) {
    Vec3d color(0.0);
    double alpha = 0.0;
    for (const PaintStroke& stroke : strokes) {
        const double share = stroke.opacity * coverage_of(stroke, texel);
        if (stroke.mode == PaintMode::erase) {
            alpha *= 1.0 - share;
            continue;
        }
        const double now = share + alpha * (1.0 - share);
        if (now > 0.0)
            color = (share * linear_light(stroke.color) + alpha * (1.0 - share) * color) / now;
        alpha = now;
    }
    return alpha * color + (1.0 - alpha) * below;
}

Texel texel_of(const TexelMap& map, std::uint32_t x, std::uint32_t y) {
    return {map(x, y), std::sqrt(std::max(glm::dot(map.step_x, map.step_x),
                                          glm::dot(map.step_y, map.step_y)))};
}

template <class Visit>
void for_each_texel(const SolidAtlas& solid, const Visit& visit) {
    for (std::uint32_t y = 0; y < solid.size; ++y)
        for (const Span& span : solid.row(y))
            for (std::uint32_t x = span.x; x < span.x + span.count; ++x)
                visit(x, y, texel_of(solid.maps[span.map], x, y));
}

Image<RgbF> random_texture(std::uint32_t size) {
    Random random(7);
    Image<RgbF> image(size, size);
    for (std::uint32_t y = 0; y < size; ++y)
        for (RgbF& texel : image.row(y))
            texel = {float(uniform(random, 0, 1)), float(uniform(random, 0, 1)),
                     float(uniform(random, 0, 1))};
    return image;
}

/// Largest difference, in linear light, and how many texels were painted.
struct Difference {
    double most = 0.0;
    std::size_t painted = 0;
};

Difference difference_from_search(const SolidAtlas& solid, const std::vector<PaintStroke>& strokes,
                                  const Image<RgbF>& base, const Image<RgbF>& image) {
    Difference result;
    for_each_texel(solid, [&](std::uint32_t x, std::uint32_t y, const Texel& texel) {
        const RgbF &before = base(x, y), &after = image(x, y);
        const Vec3d expected = painted_slowly(strokes, texel, {before.r, before.g, before.b});
        const Vec3d apart = glm::abs(Vec3d(after.r, after.g, after.b) - expected);
        result.most = std::max({result.most, apart.x, apart.y, apart.z});
        result.painted += before != after;
    });
    return result;
}

TEST(PaintTexture, IsWhatASearchOverAllTexelsFinds) {
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
        SyntheticAtlas atlas;
        atlas.size = 61 + seed, atlas.step = 0.05;
        const SolidAtlas solid = atlas.make(seed);
        const std::vector<PaintStroke> strokes = random_strokes(seed, 12, 1.0);
        const Image<RgbF> base = random_texture(solid.size);
        Image<RgbF> image = base;
        EXPECT_GT(paint_over(solid, strokes, 1, image), 0u);
        const Difference difference = difference_from_search(solid, strokes, base, image);
        EXPECT_LT(difference.most, 2e-6);
        EXPECT_GT(difference.painted, 300u);
    }
}

TEST(PaintTexture, TexelsOutOfReachKeepTheirBitsInEveryFormat) {
    SyntheticAtlas atlas;
    atlas.step = 0.05;
    const SolidAtlas solid = atlas.make(4);
    const std::vector<PaintStroke> strokes = random_strokes(4, 9, 0.9);
    const auto check = [&](auto image, auto wanted) {
        const auto base = image;
        paint_over(solid, strokes, 1, image);
        std::size_t painted = 0, kept = 0;
        for_each_texel(solid, [&](std::uint32_t x, std::uint32_t y, const Texel& texel) {
            const bool reached = std::ranges::any_of(
                strokes, [&](const PaintStroke& s) { return coverage_of(s, texel) > 0.0; });
            if (!reached) {
                EXPECT_EQ(image(x, y), base(x, y));
            }
            ++(reached ? painted : kept);
            wanted(painted_slowly(strokes, texel, Vec3d(0.2122)), image(x, y));
        });
        EXPECT_GT(painted, 50u);
        EXPECT_GT(kept, 100u);
    };
    // 127 of 255 is 0.2122 in linear light.
    check(Image<Rgb8>(64, 64, {127, 127, 127}), [](const Vec3d& light, const Rgb8& code) {
        EXPECT_NEAR(code.g, 255.0 * srgb_encode(light.y), 0.51);
    });
    check(Image<Rgb16>(64, 64, {32639, 32639, 32639}), [](const Vec3d& light, const Rgb16& code) {
        EXPECT_NEAR(code.r, 65535.0 * srgb_encode(light.x), 3.0);
    });
}

TEST(PaintTexture, IsTheSameForEveryNumberOfThreads) {
    SyntheticAtlas atlas;
    atlas.size = 200, atlas.step = 0.02;
    const SolidAtlas solid = atlas.make(5);
    const std::vector<PaintStroke> strokes = random_strokes(5, 20, 1.0);
    const Image<RgbF> base = random_texture(solid.size);
    Image<RgbF> one = base, three = base;
    EXPECT_EQ(paint_over(solid, strokes, 1, one), paint_over(solid, strokes, 3, three));
    EXPECT_EQ(one, three);
    EXPECT_NE(one, base);
}

/// An edit as an editor makes it.
void edit(std::vector<PaintStroke>& strokes, Random& random) {
    const auto kind = random() % 8;
    if (kind < 4 && !strokes.empty()) {  // the stroke goes on
        const Vec3d from = strokes.back().points.back();
        strokes.back().points.push_back(from + 0.1 * random_stroke(random, 1.0).points[0]);
    } else if (kind == 4 && !strokes.empty()) {  // undone
        strokes.resize(strokes.size() - std::min<std::size_t>(strokes.size(), 1 + random() % 3));
    } else if (kind == 5 && !strokes.empty()) {
        strokes[random() % strokes.size()].color.r ^= 0x55;
    } else if (kind == 6 && random() % 8 == 0) {
        strokes.clear();
    } else {
        strokes.push_back(random_stroke(random, 1.0));
    }
}

TEST(PaintLayer, IsAfterEveryEditAsIfMadeAnew) {
    SyntheticAtlas atlas;
    atlas.size = 70, atlas.step = 0.015;
    const SolidAtlas solid = atlas.make(6);
    Random random(6);
    PaintLayer layer(solid, 1);
    std::vector<PaintStroke> strokes;
    for (int step = 0; step < 150; ++step) {
        edit(strokes, random);
        std::vector<std::vector<PaintLight>> before;
        for (std::size_t tile = 0; tile < layer.tiles().count(); ++tile)
            before.emplace_back(layer.paint(tile).begin(), layer.paint(tile).end());
        const PaintWork work = layer.update(strokes);
        PaintLayer anew(solid, 1);
        anew.update(strokes);
        for (std::uint32_t tile = 0; tile < layer.tiles().count(); ++tile) {
            EXPECT_TRUE(std::ranges::equal(layer.paint(tile), anew.paint(tile))) << step;
            if (!std::ranges::binary_search(work.tiles, tile)) {
                EXPECT_TRUE(std::ranges::equal(layer.paint(tile), before[tile])) << step;
            }
        }
    }
}

TEST(PaintLayer, AStrokeThatGoesOnRedoesOnlyWhatItReaches) {
    SyntheticAtlas atlas;
    atlas.size = 256, atlas.block = 256, atlas.step = 0.004, atlas.holes = false;
    const SolidAtlas solid = atlas.make(8);
    PaintStroke stroke;
    for (const std::uint32_t x : {40u, 60u, 80u, 100u, 120u, 140u, 160u, 180u})
        stroke.points.push_back(solid.maps[0](x, 128));
    stroke.radius = 6.0 * glm::length(solid.maps[0].step_x);
    PaintLayer layer(solid, 1);
    const std::vector<PaintStroke> first{stroke};
    const std::uint64_t all = layer.update(first).texels;
    EXPECT_LT(all, 256u * 256u / 4);
    stroke.points.push_back(solid.maps[0](184, 128));
    const std::vector<PaintStroke> longer{stroke};
    const PaintWork work = layer.update(longer);
    EXPECT_GT(work.texels, 0u);
    EXPECT_LT(work.texels, all / 2);
    EXPECT_TRUE(layer.update(longer).tiles.empty());
    EXPECT_GT(layer.bytes(), 0u);
    layer.update({});
    EXPECT_EQ(layer.bytes(), 0u);
    EXPECT_TRUE(layer.painted_tiles().empty());
}

Recipe painted_recipe(AtlasKind kind = AtlasKind::patch) {
    Recipe recipe = load_recipe("marble", {"atlas.size=64", "atlas.tries=1"});
    recipe.atlas.kind = kind;
    recipe.paint = random_strokes(9, 5, 0.5);
    return recipe;
}

template <class Pixel>
Image<Pixel> baked(const Recipe& recipe) {
    Pipeline pipeline(cube_mesh());
    pipeline.set_recipe(recipe);
    return pipeline.synthesize<Pixel>();
}

// The cube's edges are the seams; its texels' gutters and overscan have points beyond them.
TEST(PaintedPipeline, PaintsEveryTexelOfEveryAtlasByItsPoint) {
    for (const AtlasKind kind : {AtlasKind::area, AtlasKind::quad, AtlasKind::patch}) {
        const Recipe recipe = painted_recipe(kind);
        Recipe plain = recipe;
        plain.paint.clear();
        Pipeline pipeline(cube_mesh());
        pipeline.set_recipe(recipe);
        const Difference difference = difference_from_search(
            pipeline.solid(), recipe.paint, baked<RgbF>(plain), pipeline.synthesize<RgbF>());
        EXPECT_LT(difference.most, 2e-6);
        EXPECT_GT(difference.painted, 300u);
    }
}

TEST(PaintedPipeline, LevelsFollow) {
    const Recipe recipe = painted_recipe();
    Pipeline pipeline(cube_mesh());
    pipeline.set_recipe(recipe);
    const Image<RgbF> texture = pipeline.synthesize<RgbF>();
    EXPECT_EQ(pipeline.levels(texture, 3), block_levels(pipeline.mesh_atlas(), texture, 3));
    Recipe plain = recipe;
    plain.paint.clear();
    const LevelRule direct{.direct = true, .samples = 16};
    const Image<RgbF> painted = pipeline.level(3, direct);
    pipeline.set_recipe(plain);
    EXPECT_NE(painted, pipeline.level(3, direct));
}

TEST(PaintedPipeline, EditsRedoOnlyTheirOwnStageAndGiveTheBytesOfABakeAnew) {
    Pipeline pipeline(cube_mesh());
    pipeline.set_cache(std::size_t(1) << 24);
    const auto runs = [&] { return pipeline.records()[Stage::synthesis].runs; };
    const auto painted = [&] { return pipeline.records()[Stage::paint].last.work.texels; };
    const auto show = [&](const Recipe& recipe) {
        pipeline.set_recipe(recipe);
        EXPECT_EQ(*pipeline.picture<Rgb8>(), baked<Rgb8>(recipe));
    };
    Recipe recipe = painted_recipe();
    show(recipe);
    EXPECT_EQ(runs(), 1u);
    recipe.paint.back().points.push_back(recipe.paint.back().points.back() + Vec3d(0.01));
    show(recipe);
    EXPECT_EQ(runs(), 1u);
    EXPECT_LT(painted(), 64u * 64u);
    recipe.paint.resize(2);  // undone
    show(recipe);
    EXPECT_EQ(runs(), 1u);
    plain_texture(recipe.texture)->noise[0].amplitude = 0.75;
    show(recipe);
    EXPECT_EQ(runs(), 2u);
    const Image<Rgb16> other = baked<Rgb16>(recipe);
    EXPECT_EQ(*pipeline.picture<Rgb16>(), other);
    recipe.paint.clear();
    show(recipe);
}

TEST(PaintedPipeline, TheScaleOfTheTextureLeavesPaintWhereItIs) {
    Recipe recipe = painted_recipe();
    plain_texture(recipe.texture)->colors.stops = {
        {0.0, {90, 90, 90}}};  // one colour, whatever the scale
    const Image<Rgb8> before = baked<Rgb8>(recipe);
    recipe.solid.scale = 3.0;
    EXPECT_EQ(baked<Rgb8>(recipe), before);
}

}  // namespace
}  // namespace burl
