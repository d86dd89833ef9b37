// The editor's view of the object: whatever was drawn before, a frame is what a view of its own
// shows.
#include "app/editor/window/object.h"
#include "app/recipe/edit/recipe_json.h"

#include <gtest/gtest.h>

#include <functional>

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

}  // namespace
}  // namespace burl
