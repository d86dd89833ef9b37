// The editor's baker with large meshes: pairs at once, then the recipe's own atlas, and neither
// closing nor another mesh waits for that.
#include "app/editor/jobs/baker.h"
#include "app/recipe/edit/recipe_json.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <atomic>
#include <utility>

#include "app/bench/meshes.h"
#include "app/editor/jobs/atlas.h"
#include "app/surface/sample_meshes.h"

namespace burl {
namespace {

Recipe recipe_of(std::uint32_t size, const std::vector<std::string>& more = {}) {
    std::vector<std::string> settings{fmt::format("atlas.size={}", size), "atlas.tries=1"};
    settings.insert(settings.end(), more.begin(), more.end());
    return load_recipe("marble", settings);
}

Image<Rgb8> picture_of(const Mesh& mesh, const Recipe& recipe) {
    Pipeline pipeline(mesh);
    pipeline.set_recipe(recipe);
    return pipeline.synthesize<Rgb8>();
}

/// Until charts of these texels a side are being laid out, or there already.
void wait_for_layout(const EditBaker& baker, std::uint32_t size) {
    const auto done = [&] {
        const auto surface = baker.front().surface();
        return surface && surface->atlas == "chart" && surface->size == size;
    };
    while (!baker.laying_out() && !done()) std::this_thread::yield();
}

TEST(EditJobQueue, AreDoneInOrderAndCancelledAtOnce) {
    JobQueue jobs;
    std::vector<int> done;
    jobs.add([&](const std::stop_token&) { done.push_back(1); });
    jobs.add([&](const std::stop_token&) { done.push_back(2); });
    jobs.wait();
    EXPECT_EQ(done, (std::vector{1, 2}));
    std::atomic<bool> begun = false, stopped = false;
    jobs.add([&](const std::stop_token& stop) {
        begun = true;
        while (!stop.stop_requested()) std::this_thread::yield();
        stopped = true;
    });
    jobs.add([&](const std::stop_token&) { done.push_back(3); });
    while (!begun) std::this_thread::yield();
    jobs.cancel();
    jobs.wait();
    EXPECT_TRUE(stopped);
    jobs.end();
    jobs.add([&](const std::stop_token&) { done.push_back(4); });
    EXPECT_TRUE(jobs.idle());
    EXPECT_EQ(done, (std::vector{1, 2}));
}

TEST(EditJobQueue, WaitWhileTheyAreHeld) {
    JobQueue jobs;
    std::atomic<int> done = 0;
    jobs.hold(true);
    jobs.add([&](const std::stop_token&) { ++done; });
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_EQ(done, 0);
    EXPECT_FALSE(jobs.idle());
    jobs.hold(false);
    jobs.wait();
    EXPECT_EQ(done, 1);
    jobs.hold(true);
    jobs.add([&](const std::stop_token&) { ++done; });
    jobs.cancel();
    jobs.wait();
    EXPECT_EQ(done, 1);
}

TEST(EditAtlas, OnlyPatchesOfManyFacesComeLater) {
    AtlasOptions own;
    own.size = 1000;
    EXPECT_EQ(atlas_at_once(own, many_faces), own);
    const AtlasOptions quick = atlas_at_once(own, many_faces + 1);
    EXPECT_EQ(quick.kind, AtlasKind::quad);
    EXPECT_EQ(quick.size, 512u);
    own.kind = AtlasKind::area;
    EXPECT_EQ(atlas_at_once(own, 10 * many_faces), own);
}

TEST(EditBaker, ALargeMeshHasPairsAtOnceAndThenPatches) {
    const Mesh mesh = bumpy_sphere(many_faces + 1000);
    ASSERT_GT(mesh.triangles.size(), many_faces);
    const Recipe recipe = recipe_of(256);
    std::vector<std::string> atlases;
    EditBaker* made = nullptr;
    std::mutex mutex;
    EditBaker baker([&] {
        const std::scoped_lock lock(mutex);
        if (made && made->front().surface() &&
            (atlases.empty() || atlases.back() != made->front().surface()->atlas))
            atlases.push_back(made->front().surface()->atlas);
    });
    {
        const std::scoped_lock lock(mutex);
        made = &baker;
    }
    baker.set_mesh(mesh);
    baker.request(recipe, false);
    baker.wait();
    EXPECT_EQ(atlases, (std::vector<std::string>{"quad", "chart"}));
    EXPECT_FALSE(baker.laying_out());
    EXPECT_EQ(baker.front().surface()->size, 256u);
    EXPECT_EQ(baker.front().picture()->surface, baker.front().surface()->number);
    EXPECT_EQ(baker.front().picture()->level, 0u);
    EXPECT_EQ(baker.front().picture()->texels, picture_of(mesh, recipe));
    ASSERT_TRUE(baker.front().pick());
    EXPECT_EQ(&baker.front().pick()->scene(), &baker.front().surface()->scene);
    // The atlas stays while the recipe's others change.
    const auto surface = baker.front().surface();
    const Recipe scaled = recipe_of(256, {"solid.scale=2"});
    baker.request(scaled, false);
    baker.wait();
    EXPECT_EQ(baker.front().surface(), surface);
    EXPECT_EQ(baker.front().picture()->texels, picture_of(mesh, scaled));
    EXPECT_FALSE(baker.take_problem());
}

TEST(EditBaker, AnotherMeshOrAnotherAtlasDoesNotWaitForPatches) {
    EditBaker baker([] {});
    baker.set_mesh(bumpy_sphere(many_faces + 1000));
    baker.request(recipe_of(256), false);
    wait_for_layout(baker, 256);
    baker.request(recipe_of(128), false);
    baker.wait();
    EXPECT_EQ(baker.front().surface()->atlas, "chart");
    EXPECT_EQ(baker.front().surface()->size, 128u);
    baker.request(recipe_of(256), false);
    wait_for_layout(baker, 256);
    const Mesh cube = sample_mesh("sample:cube");
    baker.set_mesh(cube);
    baker.request(recipe_of(64), false);
    baker.wait();
    EXPECT_EQ(baker.front().surface()->triangles, cube.triangles.size());
    EXPECT_EQ(baker.front().picture()->texels, picture_of(cube, recipe_of(64)));
}

TEST(EditBaker, ASurfaceComesBeforeItsFirstPicture) {
    std::mutex mutex;
    std::vector<std::shared_ptr<const EditSurface>> coming;
    EditBaker* made = nullptr;
    EditBaker baker([&] {
        const std::scoped_lock lock(mutex);
        if (made && made->front().coming()) {
            EXPECT_TRUE(made->opening());
            EXPECT_NE(made->front().coming(), made->front().surface());
            coming.push_back(made->front().coming());
        }
    });
    {
        const std::scoped_lock lock(mutex);
        made = &baker;
    }
    EXPECT_FALSE(baker.opening());
    baker.set_mesh(sample_mesh("sample:cube"));
    baker.request(recipe_of(64), false);
    baker.wait();
    ASSERT_EQ(coming.size(), 1u);
    EXPECT_EQ(coming.front(), baker.front().surface());
    EXPECT_FALSE(coming.front()->scene.surfaces.empty());
    EXPECT_FALSE(baker.front().coming());
    EXPECT_FALSE(baker.opening());
}

TEST(EditBaker, WhatIsHeldWaitsUntilThePicturesAreSeen) {
    EditBaker baker([] {});
    baker.hold_jobs(true);
    baker.set_mesh(bumpy_sphere(many_faces + 1000));
    baker.request(recipe_of(64), false);
    while (!baker.front().picture() || baker.opening()) std::this_thread::yield();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_FALSE(baker.front().pick());
    EXPECT_FALSE(baker.idle());
    EXPECT_EQ(baker.front().surface()->atlas, "quad");
    baker.hold_jobs(false);
    baker.wait();
    EXPECT_TRUE(baker.front().pick());
    EXPECT_EQ(baker.front().surface()->atlas, "chart");
}

TEST(EditBaker, EndsWhilePatchesAreLaidOut) {
    EditBaker baker([] {});
    baker.set_mesh(bumpy_sphere(many_faces + 1000));
    baker.request(recipe_of(256), false);
    wait_for_layout(baker, 256);
    EXPECT_EQ(baker.front().picture()->level, 0u);
}

TEST(EditBaker, TheOldSurfaceStaysUntilThereIsAPictureOfTheNewOne) {
    EditBaker baker([] {});
    baker.set_mesh(sample_mesh("sample:cube"));
    baker.request(recipe_of(64), false);
    baker.wait();
    const auto surface = baker.front().surface();
    baker.set_mesh(sample_mesh("sample:teapot"));
    // Noise so far from the origin has no picture.
    Recipe far = recipe_of(64);
    far.solid.scale = 1e18;
    baker.request(far, false);
    baker.wait();
    EXPECT_EQ(baker.front().surface(), surface);
    const auto problem = baker.take_problem();
    ASSERT_TRUE(problem);
    EXPECT_NE(problem->find("lattice cells"), std::string::npos) << *problem;
    baker.request(recipe_of(64), false);
    baker.wait();
    EXPECT_NE(baker.front().surface(), surface);
    EXPECT_EQ(baker.front().picture()->surface, baker.front().surface()->number);
}

}  // namespace
}  // namespace burl
