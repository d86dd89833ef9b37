// Planes to the horizon against ray-plane intersection by linear equations, and in pictures.
#include "app/direct/render.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/direct/picture.h"
#include "atlas/base/error.h"
#include "tests/app/programs/run_program.h"

namespace burl {
namespace {

using test::expect_one_sentence;
using test::run_burl;
using test::Scratch;

constexpr double degree = std::numbers::pi / 180.0;

/// The point of the plane that is seen at (x, y) in samples, from three linear equations: it lies
/// on the plane and on two planes through the eye, one per picture coordinate.
Vec3d seen_at(const Camera& c, const PictureSize& size, double x, double y, const Plane& plane) {
    const double X = 2.0 * x / size.width - 1.0, Y = 1.0 - 2.0 * y / size.height;
    const Mat3d rows(plane.normal, c.focal_x * c.right + X * c.back, c.focal_y * c.up + Y * c.back);
    const Vec3d right(plane.offset - glm::dot(plane.normal, c.eye), 0.0, 0.0);
    return c.eye + glm::inverse(glm::transpose(rows)) * right;
}

TEST(InfinitePlane, PointsAndStepsAgreeWithLinearEquations) {
    const PictureSize size{40, 30};
    const Plane planes[] = {
        {{0, 1, 0}, -1.0}, {{0, 1, 0}, 4.0}, {{0, 0, 1}, 0.0}, {{1, -2, 0.5}, -3.0}};
    int met = 0;
    for (const View& view : {View{0, 3, 3.5}, View{130, -25, 2.0}, View{40, 90, 5.0}}) {
        const Camera camera = orbit_camera(view, {{0.2, -0.1, 0.4}, 1.3}, size);
        const SampleRays rays(camera, size);
        for (const Plane& plane : planes)
            for (int y = 0; y < size.height; y += 3)
                for (int x = 0; x < size.width; x += 3) {
                    const auto hit = meet(rays, x, y, plane);
                    const auto reference = [&](double dx, double dy) {
                        return seen_at(camera, size, x + 0.5 + dx, y + 0.5 + dy, plane);
                    };
                    const double depth = glm::dot(camera.eye - reference(0, 0), camera.back);
                    ASSERT_EQ(hit.has_value(), depth > 0.0) << x << ',' << y;
                    if (!hit) continue;
                    ++met;
                    const double far = 1e-9 * (1.0 + hit->depth);
                    EXPECT_NEAR(hit->depth, depth, far);
                    EXPECT_LT(glm::distance(hit->point, reference(0, 0)), far);
                    const double h = 1e-5;
                    const Vec3d u = (reference(h, 0) - reference(-h, 0)) / (2.0 * h);
                    const Vec3d v = (reference(0, h) - reference(0, -h)) / (2.0 * h);
                    EXPECT_LT(glm::distance(hit->steps.u, u), 1e-4 * (1e-3 + glm::length(u)));
                    EXPECT_LT(glm::distance(hit->steps.v, v), 1e-4 * (1e-3 + glm::length(v)));
                }
    }
    EXPECT_GT(met, 500);
}

TEST(InfinitePlane, NoneWhereTheRayIsParallelOrTheEyeWithin) {
    const PictureSize size{9, 9};
    const Camera camera = orbit_camera({0, 0, 3.5}, {}, size);  // eye (0,0,3.5), level
    const SampleRays rays(camera, size);
    for (int x = 0; x < 9; ++x) {
        EXPECT_FALSE(meet(rays, x, 4, {{0, 1, 0}, -1.0}));  // along the horizon
        EXPECT_FALSE(meet(rays, x, 3, {{0, 1, 0}, -1.0}));
        EXPECT_TRUE(meet(rays, x, 5, {{0, 1, 0}, -1.0}));
        EXPECT_TRUE(meet(rays, x, 3, {{0, -1, 0}, -1.0}));  // y = 1
        for (int y = 0; y < 9; ++y) {
            EXPECT_FALSE(meet(rays, x, y, {{0, 1, 0}, 0.0}));  // the eye lies in it
            EXPECT_FALSE(meet(rays, x, y, {{0, 0, 1}, 4.0}));  // behind
        }
    }
}

TEST(InfinitePlane, ParsesArguments) {
    const PlaneArgument named = parse_plane("clouds:0,2,0,8");
    EXPECT_EQ(named.recipe, "clouds");
    EXPECT_EQ(named.plane.normal, Vec3d(0, 1, 0));
    EXPECT_EQ(named.plane.offset, 4.0);
    const PlaneArgument path = parse_plane("./a:b.json:3,0,4,-10");
    EXPECT_EQ(path.recipe, "./a:b.json");
    EXPECT_NEAR(path.plane.normal.z, 0.8, 1e-15);
    EXPECT_NEAR(path.plane.offset, -2.0, 1e-15);
    EXPECT_EQ(parse_plane("0,0,1e-300,1e-300").plane.offset, 1.0);
    EXPECT_EQ(parse_plane("0,0,1,0").recipe, "");
    for (const char* wrong : {"", "clouds", "clouds:", ":0,1,0,4", "0,1,0", "0,1,0,4,5", "0,0,0,1",
                              "0,1,0,nan", "0,inf,0,1", "a:0,1,0,x", "0,1,0,4 "})
        EXPECT_THROW(parse_plane(wrong), Error) << wrong;
}

// Pictures

DirectOptions unlit(const std::string& view, const std::string& size) {
    DirectOptions options;
    options.view = view;
    options.size = size;
    options.unlit = true;
    options.picture.supersample = 1;
    return options;
}

Image<Rgb8> drawn(const DirectOptions& options) {
    return DirectPicture(options)(picture_recipes(options, {}).front());
}

/// A file with a recipe of one colour.
std::string plain(const Scratch& scratch, const std::string& name, const std::string& color) {
    return scratch.write(name, R"({"texture": {"node": "layer_over", "top": ")" + color +
                                   R"(", "base": "#00000000"}})");
}

TEST(PlanePicture, HorizonLiesWhereTheCameraSays) {
    const Scratch scratch;
    const std::string white = plain(scratch, "white.json", "#ffffff");
    for (const double elevation : {-6.0, 0.0, 2.0, 11.0}) {
        DirectOptions options = unlit(fmt::format("70,{},3.5", elevation), "24x200");
        // Level with the eye or 2 below it, so that it is a floor in every view.
        const double eye = 3.5 * std::sin(elevation * degree);
        options.planes = {fmt::format("{}:0,1,0,{}", white, eye - 2.0)};
        const Image<Rgb8> picture = drawn(options);
        const double horizon =
            100.0 * (1.0 - std::tan(elevation * degree) / std::tan(17.5 * degree));
        for (int y = 0; y < 200; ++y)
            EXPECT_EQ(picture(12, std::size_t(y)),
                      y + 0.5 > horizon ? (Rgb8{255, 255, 255}) : background_srgb)
                << elevation << ' ' << y;
    }
}

TEST(PlanePicture, FromBelowItIsACeiling) {
    const Scratch scratch;
    DirectOptions options = unlit("0,0,3.5", "8x8");
    options.planes = {plain(scratch, "white.json", "#ffffff") + ":0,1,0,3"};
    const Image<Rgb8> picture = drawn(options);
    EXPECT_EQ(picture(4, 3), (Rgb8{255, 255, 255}));
    EXPECT_EQ(picture(4, 4), background_srgb);
}

TEST(PlanePicture, NearerCoversFartherAsFarAsItIsOpaque) {
    const Scratch scratch;
    const std::string red = plain(scratch, "red.json", "#ff0000");
    const std::string mist = plain(scratch, "mist.json", "#ffffff80");
    const auto middle = [&](const std::vector<std::string>& planes, const std::string& mesh) {
        DirectOptions options = unlit("0,0,4", "9x9");
        options.scene = mesh;
        options.planes = planes;
        options.recipe.recipe = plain(scratch, "blue.json", "#0000ff");
        return drawn(options)(4, 4);
    };
    const std::string red_front = red + ":0,0,1,1.5", red_back = red + ":0,0,1,-1.5";
    EXPECT_EQ(middle({}, "sample:cube"), (Rgb8{0, 0, 255}));
    EXPECT_EQ(middle({red_back}, "sample:cube"), (Rgb8{0, 0, 255}));
    EXPECT_EQ(middle({red_front}, "sample:cube"), (Rgb8{255, 0, 0}));
    EXPECT_EQ(middle({"0,0,1,1.7", red_front}, "sample:cube"), (Rgb8{0, 0, 255}));
    // Half of white light over blue: 128/255 of full light is sRGB code 188.
    const std::string mist_front = mist + ":0,0,1,1.2";
    EXPECT_EQ(middle({mist_front}, "sample:cube"), (Rgb8{188, 188, 255}));
    EXPECT_EQ(middle({red_back, mist_front}, ""), (Rgb8{255, 188, 188}));
    EXPECT_EQ(middle({mist_front, mist + ":0,0,1,1.4", red_back}, ""), (Rgb8{255, 225, 225}));
}

TEST(PlanePicture, ShowsWhatAMeshInThePlaneShows) {
    // The mesh's footprints come from its triangles' edges, the plane's from rays.
    const Scratch scratch;
    const std::string square =
        scratch.write("square.obj", "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nf 4 3 2 1\n");
    for (const char* filter : {"none", "trapezoid", "exact", "table-sat"})
        for (const char* recipe : {"zoneplate", "marble", "checks"}) {
            DirectOptions mesh = unlit("20,14,1.1", "90x70"), plane = mesh;
            mesh.filter = plane.filter = filter;
            mesh.recipe.recipe = plane.recipe.recipe = recipe;
            mesh.recipe.settings = plane.recipe.settings = {"solid.space=object"};
            mesh.scene = plane.scene = square;
            plane.planes = {"0,1,0,1e-9"};  // just above the square, whose camera it shares
            Image<Rgb8> a = drawn(mesh);
            const Image<Rgb8> b = drawn(plane);
            int shown = 0, different = 0;
            for (std::size_t i = 0; i < a.pixels().size(); ++i) {
                if (a.pixels()[i] == background_srgb) continue;
                ++shown;
                different += std::abs(a.pixels()[i].g - b.pixels()[i].g) > 1;
            }
            EXPECT_GT(shown, 1000) << recipe;
            EXPECT_LE(different, 3) << recipe << ' ' << filter;
        }
}

/// Largest difference of green codes to the left or right neighbour in a row.
int unrest(const Image<Rgb8>& picture, std::size_t y) {
    int most = 0;
    for (std::size_t x = 1; x < picture.width(); ++x)
        most = std::max(most, std::abs(picture(x, y).g - picture(x - 1, y).g));
    return most;
}

TEST(PlanePicture, DistanceTurnsIntoTheMapsMean) {
    // The horizon of an odd height seen from elevation 2 lies in row 113.
    DirectOptions options = unlit("0,2,3.5", "160x255");
    options.planes = {"0,1,0,-1"};
    options.recipe.recipe = "zoneplate";  // rings in the plane of s and r
    options.recipe.settings = {"texture.input.quadric.E=0", "texture.input.quadric.H=50"};
    const Image<Rgb8> filtered = drawn(options);
    options.filter = "none";
    const Image<Rgb8> aliased = drawn(options);
    for (std::size_t y = 115; y < 125; ++y) {
        EXPECT_LT(unrest(filtered, y), 12) << y;
        EXPECT_EQ(unrest(aliased, y), 255) << y;
        EXPECT_NEAR(filtered(80, y).g, 188, 6) << y;  // half the light
    }
}

TEST(PlanePicture, WidthsAreTheGradientTimesTheStep) {
    // f = 50 s^2 + 50 t^2 seen head on: 64 samples over [-1,1]^2 are steps of 1/32.
    DirectOptions options = unlit(fmt::format("0,0,{}", 1.0 / std::tan(17.5 * degree)), "64x64");
    options.planes = {"0,0,1,0"};
    options.recipe.recipe = "zoneplate";
    options.recipe.settings = {"texture.input.quadric.A=5", "texture.input.quadric.E=5"};
    options.widths = true;
    const Image<Rgb8> picture = drawn(options);
    for (std::size_t y = 0; y < 64; y += 7)
        for (std::size_t x = 0; x < 64; x += 7) {
            const double s = (double(x) + 0.5) / 32.0 - 1.0, t = (double(y) + 0.5) / 32.0 - 1.0;
            const double entries = 256.0 * 10.0 * std::hypot(s, t) / 32.0;
            EXPECT_NEAR(picture(x, y).r, std::clamp(entries - 1.0, 0.0, 255.0), 0.51);
            EXPECT_EQ(picture(x, y).r, picture(x, y).b);
        }
    options.recipe = {};
    options.recipe.recipe = "checks";
    EXPECT_THROW(drawn(options), Error);
}

TEST(PlaneProgram, SaysWhatIsWrong) {
    const Scratch scratch;
    const std::string png = scratch / "p.png";
    const auto code = [&](const std::string& arguments) {
        const test::Outcome outcome =
            run_burl(scratch, fmt::format("render {} -o '{}'", arguments, png));
        if (outcome.exit_code != 0) expect_one_sentence(outcome.err);
        return outcome.exit_code;
    };
    EXPECT_EQ(code("--direct --plane clouds:0,1,0,2 --plane marble:0,1,0,-1 --size 20x10"), 0);
    EXPECT_TRUE(test::fs::exists(png));
    EXPECT_EQ(code("--direct"), 1);
    EXPECT_EQ(code(""), 1);
    EXPECT_EQ(code("--plane clouds:0,1,0,2"), 1);
    EXPECT_EQ(code("--direct --plane clouds:0,0,0,2"), 1);
    EXPECT_EQ(code("--direct --plane cloud:0,1,0,2"), 1);
    EXPECT_EQ(code("--direct --plane 0,1,0,2 --filter linear"), 1);
    EXPECT_EQ(code("--direct --plane 0,1,0,2 --filter supersample:4"), 1);
    EXPECT_EQ(code("--direct --plane 0,1,0,2 -r checks --precision fixed:8.8"), 1);
    EXPECT_EQ(code("--direct --plane 0,1,0,2 --precision fixed:8.8 --size 9x9"), 0);
    EXPECT_EQ(code("--direct --plane 0,1,0,2 --precision fixed:8.8 --filter none --size 9x9"), 0);
    EXPECT_EQ(code("sample:teapot --filter trapezoid"), 1);
    EXPECT_EQ(code("--direct sample:kettle"), 1);
    EXPECT_EQ(code("--direct sample:cube --size 20x10"), 0);
}

}  // namespace
}  // namespace burl
