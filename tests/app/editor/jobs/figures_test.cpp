// The editor's figures of an atlas against those of atlas/measure/atlas_measures.h, which have
// other sources: the atlas's own corners in place of the scene's coordinates.
#include "app/editor/jobs/figures.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <numeric>

#include "app/gl/draw/view_scene.h"
#include "app/surface/sample_meshes.h"
#include "atlas/measure/atlas_measures.h"

namespace burl {
namespace {

Scene square(double stretch) {
    Surface surface;
    surface.positions = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    surface.uvs = {{0, 0}, {0.5, 0}, {0.5, stretch}, {0, 0.5}};
    surface.triangles = {{0, 1, 2}, {0, 2, 3}};
    Scene scene;
    scene.surfaces.push_back(surface);
    return scene;
}

TEST(AtlasFigures, AreThoseOfTheAtlasItself) {
    Recipe recipe;
    recipe.atlas.size = 256;
    recipe.atlas.tries = 1;
    for (const AtlasKind kind : {AtlasKind::patch, AtlasKind::uniform}) {
        recipe.atlas.kind = kind;
        Pipeline pipeline(sample_mesh("sample:torus"));
        pipeline.set_recipe(recipe);
        const AtlasFigures figures = atlas_figures(baked_scene(pipeline), recipe.atlas.size);
        const AtlasMetrics metrics =
            measure(pipeline.atlas_mesh(), pipeline.atlas(), pipeline.solid());
        EXPECT_NEAR(figures.coverage, metrics.coverage, 1e-6);
        EXPECT_NEAR(figures.relative_scale, metrics.relative_scale, 1e-4);
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_NEAR(figures.density[i] * metrics.coverage, metrics.density[i], 1e-4);
    }
}

TEST(AtlasFigures, EvenDensityIsOneBarInTheMiddle) {
    const AtlasFigures figures = atlas_figures(square(0.5), 128);
    EXPECT_DOUBLE_EQ(figures.coverage, 0.25);
    EXPECT_DOUBLE_EQ(figures.texels_per_unit, 32.0);
    ASSERT_EQ(figures.histogram.size(), AtlasFigures::bins);
    EXPECT_DOUBLE_EQ(
        figures.histogram[AtlasFigures::bins / 2] + figures.histogram[AtlasFigures::bins / 2 - 1],
        1.0);
}

TEST(AtlasFigures, UnevenDensityIsSpread) {
    // Triangles of the same area, one with seven times the other's texels.
    const AtlasFigures figures = atlas_figures(square(3.5), 128);
    EXPECT_DOUBLE_EQ(figures.density[0], 0.25);
    EXPECT_DOUBLE_EQ(figures.density[2], 1.75);
    const auto place = [](double density) {
        return std::size_t((0.5 + 0.5 * std::log(density) / std::log(AtlasFigures::reach)) *
                           double(AtlasFigures::bins));
    };
    EXPECT_DOUBLE_EQ(figures.histogram[0], 0.5);
    EXPECT_DOUBLE_EQ(figures.histogram[place(1.75)], 0.5);
    EXPECT_DOUBLE_EQ(std::accumulate(figures.histogram.begin(), figures.histogram.end(), 0.0), 1.0);
    EXPECT_EQ(atlas_figures(Scene{}, 128).coverage, 0.0);
}

TEST(EditFigures, ComeOncePerSurface) {
    std::atomic<int> woken = 0;
    EditFigures figures([&] { ++woken; });
    auto surface = std::make_shared<EditSurface>();
    surface->number = 7;
    surface->scene = square(0.5);
    surface->size = 64;
    EXPECT_EQ(figures.of(surface), nullptr);
    figures.wait();
    const auto first = figures.of(surface);
    ASSERT_NE(first, nullptr);
    EXPECT_DOUBLE_EQ(first->coverage, 0.25);
    EXPECT_EQ(figures.of(surface), first);
    auto other = std::make_shared<EditSurface>(*surface);
    other->number = 8;
    other->size = 128;
    EXPECT_EQ(figures.of(other), nullptr);
    figures.wait();
    ASSERT_NE(figures.of(other), nullptr);
    EXPECT_DOUBLE_EQ(figures.of(other)->texels_per_unit, 2.0 * first->texels_per_unit);
}

}  // namespace
}  // namespace burl
