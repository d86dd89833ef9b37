// The editor's view of the object: whatever was drawn before, a frame is what a view of its own
// shows.
#include "app/editor/window/object.h"
#include "app/recipe/edit/recipe_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "app/light/environment.h"
#include "app/light/prefilter.h"
#include "app/recipe/recipe.h"
#include "app/surface/sample_meshes.h"
#include "tests/app/gl/device/fixture.h"

namespace burl {
namespace {

class GlEditObjectTest : public GlTest {
  protected:
    /// Pictures of the torus's recipe with these amplitudes.
    void make(const std::string& atlas, const std::vector<std::string>& amplitudes) {
        EditBaker baker([] {});
        baker.set_mesh(sample_mesh("sample:torus", {}));
        for (const std::string& amplitude : amplitudes) {
            baker.request(load_recipe("marble", {"atlas.size=128", "atlas.tries=1", atlas,
                                                 "texture.input.noise.0.amplitude=" + amplitude}),
                          false);
            baker.wait();
            pictures.push_back(baker.front().picture());
        }
        surface = baker.front().surface();
    }

    static std::vector<std::uint8_t> texels(GlEditObject& object) {
        return object.target()->read<std::uint8_t>();
    }
    /// By a view that has drawn nothing before.
    std::vector<std::uint8_t> fresh(std::size_t picture, const ObjectViewOptions& options) const {
        GlEditObject object(context->gl());
        object.show(surface, pictures[picture]);
        object.draw(options);
        return texels(object);
    }
    void expect_frames_as_fresh() {
        GlEditObject object(context->gl());
        ObjectViewOptions options;
        options.size = {96, 80};
        const auto expect_as_fresh = [&](std::size_t picture) {
            object.show(surface, pictures[picture]);
            object.draw(options);
            std::vector<std::uint8_t> now = texels(object);
            EXPECT_EQ(now, fresh(picture, options)) << picture;
            return now;
        };
        const auto turn = [&] { options.camera = orbited({}, {10.0, 5.0}, 80.0); };
        const auto light = [&] { options.lit = !options.lit; };
        const auto widen = [&] { options.size.width += 8; };
        const auto refine = [&] { options.supersample = 3 - options.supersample; };
        const std::vector<std::uint8_t> first = expect_as_fresh(0);
        EXPECT_NE(expect_as_fresh(1), first);
        EXPECT_EQ(expect_as_fresh(0), first);
        std::size_t picture = 0;
        for (const auto& change : std::vector<std::function<void()>>{turn, light, widen, refine}) {
            change();
            expect_as_fresh(picture);
            expect_as_fresh(picture = 1 - picture);
        }
        light();
        expect_as_fresh(1 - picture);
    }

    std::shared_ptr<const EditSurface> surface;
    std::vector<std::shared_ptr<const EditPicture>> pictures;
};

TEST_F(GlEditObjectTest, ATextureThatChangesAloneLooksAsInAViewOfItsOwn) {
    make("atlas.kind=patch", {"0.2", "0.5"});
    EXPECT_TRUE(GlScene(context->gl(), surface->scene).has_places());
    expect_frames_as_fresh();
}

/// Blocks of a quad atlas are not kept as places.
TEST_F(GlEditObjectTest, SoDoesThatOfAQuadAtlas) {
    make("atlas.kind=quad", {"0.2", "0.5"});
    EXPECT_FALSE(GlScene(context->gl(), surface->scene).has_places());
    expect_frames_as_fresh();
}

TEST_F(GlEditObjectTest, AMovementThatWasPreparedLooksAsOneThatWasNot) {
    make("atlas.kind=patch", {"0.2", "0.5"});
    ObjectViewOptions still;
    still.size = {96, 80};
    still.supersample = 2;
    ObjectViewOptions moving = still;
    moving.supersample = 1;
    moving.coarse = true;
    GlEditObject object(context->gl());
    object.show(surface, pictures[0]);
    object.draw(still);
    const std::vector<std::uint8_t> before = texels(object);
    for (int i = 0; i < 3; ++i) object.prepare(moving);
    EXPECT_EQ(texels(object), before);
    object.show(surface, pictures[1]);
    object.draw(moving);
    EXPECT_EQ(texels(object), fresh(1, moving));
    moving.half = true;
    object.draw(moving);
    EXPECT_EQ(object.target()->size(), glm::ivec2(48, 40));
    EXPECT_EQ(texels(object), fresh(1, moving));
    object.draw(still);
    EXPECT_EQ(texels(object), fresh(1, still));
}

/// A view of so many samples that it is drawn in parts.
TEST_F(GlEditObjectTest, PartsMakeTheWhole) {
    make("atlas.kind=patch", {"0.2", "0.5"});
    ObjectViewOptions options;
    options.size = {640, 560};
    GlEditObject object(context->gl());
    object.show(surface, pictures[0]);
    object.draw(options);
    const std::vector<std::uint8_t> rough = texels(object);
    options.supersample = 2;
    int calls = 0;
    do {
        object.draw(options);
        ++calls;
        if (object.drawing()) {
            EXPECT_FALSE(object.drew());
            EXPECT_EQ(texels(object), rough) << "what was drawn before is shown until then";
        }
        if (calls == 1) object.show(surface, pictures[1]);  // begins anew
    } while (object.drawing());
    EXPECT_TRUE(object.drew());
    EXPECT_GT(calls, 3);
    EXPECT_EQ(texels(object), fresh(1, options));
}

/// The root mean square of the difference of two views' codes.
double difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    EXPECT_EQ(a.size(), b.size());
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double by = double(a[i]) - double(b[i]);
        sum += by * by;
    }
    return std::sqrt(sum / double(a.size()));
}

/// A torus of 8,192 faces by a quarter of them, under both lights, with every kind of atlas.
TEST_F(GlEditObjectTest, ACoarseViewLooksMuchLikeTheWholeOne) {
    const auto light =
        std::make_shared<const GlLight>(context->gl(), prefilter(make_environment("studio")));
    for (const char* atlas : {"atlas.kind=patch", "atlas.kind=quad", "atlas.kind=area"}) {
        pictures.clear();
        make(atlas, {"0.2"});
        const auto coarse = std::make_shared<const CoarseSurfaces>(
            coarse_surfaces(surface->scene, surface->triangles / 2));
        ASSERT_LT(coarse->front().triangles.size(), surface->triangles * 2 / 3);
        GlEditObject object(context->gl());
        object.show(surface, pictures[0]);
        ObjectViewOptions options;
        options.size = {96, 80};
        for (const auto& lit_by : {std::shared_ptr<const GlLight>(), light}) {
            options.light = lit_by;
            options.coarse = false;
            object.draw(options);
            const std::vector<std::uint8_t> whole = texels(object);
            object.show_coarse(coarse);
            options.coarse = true;
            object.draw(options);
            const double least = difference(texels(object), whole);
            EXPECT_LT(least, 9.0) << atlas << ' ' << bool(lit_by);
            options.camera = orbited({}, {40.0, 0.0}, 80.0);
            object.draw(options);
            EXPECT_GT(difference(texels(object), whole), 2.0 * least) << "another side";
            options.camera = {};
            object.draw(options);
            std::cerr << atlas << " " << bool(lit_by) << " " << least << "\n";
            EXPECT_NE(texels(object), whole);
            object.show_coarse(nullptr);
            EXPECT_FALSE(object.has_coarse());
        }
    }
}

}  // namespace
}  // namespace burl
