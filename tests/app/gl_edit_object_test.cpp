// The editor's view of the object: whatever was drawn before, a frame is what a view of its own
// shows.
#include "app/gl_edit_object.h"

#include <gtest/gtest.h>

#include <random>

#include "app/recipe.h"
#include "app/sample_meshes.h"
#include "tests/app/gl_fixture.h"

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
            pictures.push_back(baker.picture());
        }
        surface = baker.surface();
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
        std::mt19937 random(7);
        ObjectViewOptions options;
        options.size = {96, 80};
        for (int frame = 0; frame < 30; ++frame) {
            const std::size_t picture = random() % pictures.size();
            switch (random() % 8U) {
                case 0:
                    options.camera = orbited({}, {10.0 * double(random() % 3U), 5.0}, 80.0);
                    break;
                case 1:
                    options.lit = !options.lit;
                    break;
                case 2:
                    options.size.width = 96 + 8 * int(random() % 2U);
                    break;
                case 3:
                    options.supersample = 3 - options.supersample;
                    break;
                default:  // the texture alone
                    break;
            }
            object.show(surface, pictures[picture]);
            object.draw(options);
            ASSERT_EQ(texels(object), fresh(picture, options)) << frame;
        }
        ObjectViewOptions still;
        still.size = {96, 80};
        EXPECT_NE(fresh(0, still), fresh(1, still));
    }

    std::shared_ptr<const EditSurface> surface;
    std::vector<std::shared_ptr<const EditPicture>> pictures;
};

TEST_F(GlEditObjectTest, ATextureThatChangesAloneLooksAsInAViewOfItsOwn) {
    make("atlas.kind=patch", {"0.2", "0.5", "0.9"});
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
