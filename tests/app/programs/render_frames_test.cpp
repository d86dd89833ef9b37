// Frames, animations and sheets of `burl render` against single pictures of it.
#include <fstream>

#include <gmock/gmock.h>

#include "app/image/image_diff.h"
#include "app/image/image_io.h"
#include "app/image/sheet.h"
#include "atlas/base/json.h"
#include "tests/app/programs/run_program.h"
#include "tests/app/support/decoded_frames.h"

namespace burl::test {
namespace {

const std::string small = "--size 40x30 --supersample 1 --light headlight";
const std::string small_atlas = "--set atlas.size=64";

/// Pictures of a small cube by every way that `burl render` has.
class RenderFrames : public testing::TestWithParam<const char*> {
  protected:
    /// The arguments of the way: a scene, or a mesh with a recipe.
    std::string arguments() {
        const std::string way = GetParam();
        if (way == "--direct") return "sample:cube --direct --recipe wood";
        if (way == "--lazy") return "sample:cube --lazy --recipe wood " + small_atlas;
        const std::string scene = scratch / "scene.glb";
        if (!fs::exists(scene)) bake(scene);
        return "'" + scene + "'";
    }
    void bake(const std::string& scene) {
        const Outcome outcome = run_burl(
            scratch, fmt::format("bake sample:cube -o '{}' --recipe wood --size 64 -q", scene));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    }
    Outcome render(const std::string& out, const std::string& options) {
        return run_burl(scratch, fmt::format("render {} {} -o '{}' {}", arguments(), small,
                                             scratch / out, options));
    }
    Image<Rgb8> still(const std::string& options) {
        const Outcome outcome = render("still.png", options);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return read_png(scratch / "still.png");
    }

    const Scratch scratch;
};

TEST_P(RenderFrames, OfATurntableAreStillsOfTheirAzimuths) {
    ASSERT_EQ(render("t.png", "--turntable 4 --view 10,25,3").exit_code, 0);
    EXPECT_FALSE(fs::exists(scratch / "t.png"));
    for (int k = 0; k < 4; ++k)
        EXPECT_EQ(read_png(scratch / fmt::format("t.000{}.png", k + 1)),
                  still(fmt::format("--view {},25,3", 10 + 90 * k)))
            << k;
    EXPECT_NE(slurp(scratch / "t.0001.png"), slurp(scratch / "t.0002.png"));
}

TEST_P(RenderFrames, OfOneFileAreThoseOfManyFiles) {
    ASSERT_EQ(render("t.png", "--turntable 3").exit_code, 0);
    ASSERT_EQ(render("t.webp", "--turntable 3 --quality 100 --fps 10").exit_code, 0);
    ASSERT_EQ(render("t.apng", "--turntable 3 --fps 10").exit_code, 0);
    ASSERT_EQ(render("t.gif", "--turntable 3 --fps 10").exit_code, 0);
    for (const char* name : {"t.webp", "t.apng", "t.gif"}) {
        const DecodedFrames decoded = decoded_frames(scratch / name);
        ASSERT_EQ(decoded.frames.size(), 3u) << name;
        EXPECT_EQ(decoded.duration(), 300) << name;
        for (std::size_t k = 0; k < 3; ++k) {
            const Image<Rgb8> frame = read_png(scratch / fmt::format("t.000{}.png", k + 1));
            const auto shown = converted<Rgb8>(decoded.frames[k], [](const Rgba8& c) {
                return Rgb8{c.r, c.g, c.b};
            });
            if (std::string(name) != "t.gif")
                EXPECT_EQ(shown, frame) << name << k;
            else
                EXPECT_LT(diff_images(frame, shown).rmse, 0.01) << k;
        }
    }
}

TEST_P(RenderFrames, MoveTheCameraAlongItsNumbers) {
    ASSERT_EQ(
        render("m.png", "--frames 3 --animate camera.elevation=0:60 --animate camera.distance=3:5")
            .exit_code,
        0);
    EXPECT_EQ(read_png(scratch / "m.0002.png"), still("--view 30,30,4"));
    EXPECT_EQ(read_png(scratch / "m.0003.png"), still("--view 30,60,5"));
}

TEST_P(RenderFrames, StandUprightByUp) {
    // From above, upright for z, one sees what one saw before along z; of a mesh the recipe is made
    // for the upright one, so that only its outline is where it was.
    const Image<Rgb8> seen = still("--view 0,0,3.5");
    const Image<Rgb8> upright = still("--view 0,90,3.5 --up z");
    EXPECT_GT(diff_images(seen, upright).psnr_db, GetParam() == std::string("scene") ? 45.0 : 20.0);
    EXPECT_LT(diff_images(seen, still("--view 0,90,3.5")).psnr_db, 30.0);
    EXPECT_EQ(still("--up y"), still(""));
}

INSTANTIATE_TEST_SUITE_P(Ways, RenderFrames, testing::Values("scene", "--lazy", "--direct"),
                         [](const auto& way) {
                             const std::string name = way.param;
                             return name.substr(name.find_first_not_of('-'));
                         });

TEST(RenderAnisotropy, IsOfMipLevels) {
    const Scratch scratch;
    const auto run = [&](const std::string& arguments) {
        return run_burl(scratch, arguments, fmt::format("cd '{}';", scratch.path().string()));
    };
    const std::string flat = "--view 0,8,3.5 " + small;
    ASSERT_EQ(
        run("bake sample:cube -o s.glb --recipe wood --set solid.scale=9 --size 256 -q").exit_code,
        0);
    ASSERT_EQ(run("render s.glb -o one.png " + flat).exit_code, 0);
    ASSERT_EQ(run("render s.glb -o same.png --anisotropy 1 " + flat).exit_code, 0);
    ASSERT_EQ(run("render s.glb -o sixteen.png --anisotropy 16 " + flat).exit_code, 0);
    EXPECT_EQ(slurp(scratch / "same.png"), slurp(scratch / "one.png"));
    EXPECT_NE(slurp(scratch / "sixteen.png"), slurp(scratch / "one.png"));
    const Outcome linear = run("render s.glb -o l.png --anisotropy 16 --filter linear " + flat);
    EXPECT_EQ(linear.exit_code, 1);
    EXPECT_THAT(linear.err, testing::HasSubstr("--filter linear looks none up"));
    for (const char* way : {"--direct", "--lazy"})
        EXPECT_EQ(run(fmt::format("render sample:cube {} -o d.png --anisotropy 4", way)).exit_code,
                  1)
            << way;
    EXPECT_EQ(run("render s.glb -o m.png --anisotropy 17").exit_code, 1);
    for (const char* name : {"l.png", "d.png", "m.png"}) EXPECT_FALSE(fs::exists(scratch / name));
}

class RenderRecipes : public testing::Test {
  protected:
    Outcome render(const std::string& arguments) {
        return run_burl(scratch, fmt::format("render {} {}", arguments, small),
                        fmt::format("cd '{}';", scratch.path().string()));
    }
    Image<Rgb8> picture(const std::string& name) { return read_png(scratch / name); }
    void expect_done(const std::string& arguments) {
        const Outcome outcome = render(arguments);
        EXPECT_EQ(outcome.exit_code, 0) << arguments << outcome.err;
    }

    const Scratch scratch;
    const std::string lazy = "sample:cube --lazy " + small_atlas;
};

TEST_F(RenderRecipes, MoveWithTheCamera) {
    for (const std::string& way : {lazy, std::string("sample:cube --direct")}) {
        expect_done(way +
                    " -r wood -o m.png --frames 3 --animate solid.scale=1:3 --animate "
                    "camera.azimuth=0:90");
        expect_done(way + " -r wood -o s.png --view 45,20,3.5 --set solid.scale=2");
        EXPECT_EQ(picture("m.0002.png"), picture("s.png"));
    }
}

TEST_F(RenderRecipes, WithKeysRunOrAreHeldWhileTheCameraMoves) {
    expect_done("sample:cube --direct -r forming-marble --turntable 4 -o r.png");
    expect_done("sample:cube --direct -r forming-marble --turntable 4 --time 3 -o h.png");
    const double seconds =
        0.25 * nlohmann::json::parse(
                   run_burl(scratch, "show forming-marble --json").out)["animation"]["seconds"]
                   .get<double>();
    expect_done(
        fmt::format("sample:cube --direct -r forming-marble --view 120,20,3.5 --time {} "
                    "-o rs.png",
                    seconds));
    expect_done("sample:cube --direct -r forming-marble --view 120,20,3.5 --time 3 -o hs.png");
    EXPECT_EQ(picture("r.0002.png"), picture("rs.png"));
    EXPECT_EQ(picture("h.0002.png"), picture("hs.png"));
    EXPECT_NE(picture("rs.png"), picture("hs.png"));
}

TEST_F(RenderRecipes, OfASheetAreTheirPictures) {
    for (const std::string& way : {lazy, std::string("sample:cube --direct")}) {
        expect_done(way + " --recipes wood,checks,marble --columns 2 -o sheet.png");
        const Image<Rgb8> sheet = picture("sheet.png");
        const SheetGrid grid = sheet_grid(3, 2, {40, 30});
        ASSERT_EQ(sheet.width(), 80u);
        ASSERT_EQ(sheet.height(), grid.size().height);
        const char* names[] = {"wood", "checks", "marble"};
        for (std::size_t i = 0; i < 3; ++i) {
            expect_done(fmt::format("{} -r {} -o one.png", way, names[i]));
            EXPECT_EQ(
                std::get<Image<Rgb8>>(cut(sheet, {40 * (i % 2), i / 2 * grid.cell_height, 40, 30})),
                picture("one.png"))
                << way << names[i];
        }
    }
}

TEST_F(RenderRecipes, OfASheetTurnTogether) {
    expect_done(lazy + " --recipes wood,marble --turntable 3 -o s.apng");
    const DecodedFrames decoded = decoded_apng(scratch / "s.apng");
    ASSERT_EQ(decoded.frames.size(), 3u);
    expect_done(lazy + " --recipes wood,marble --view 150,20,3.5 -o s.png");
    EXPECT_EQ(decoded.frames[1], opaque(picture("s.png")));
}

TEST_F(RenderRecipes, KeepATransparentBackground) {
    expect_done(lazy + " -r wood --background transparent --turntable 2 -o t.png");
    for (const std::string name : {"t.webp --quality 100", "t.apng", "t.gif"}) {
        expect_done(lazy + " -r wood --background transparent --turntable 2 -o " + name);
        const DecodedFrames decoded =
            decoded_frames(scratch / name.substr(0, name.find_first_of(' ')));
        ASSERT_EQ(decoded.frames.size(), 2u) << name;
        for (std::size_t k = 0; k < 2; ++k) {
            const std::string path = scratch / fmt::format("t.000{}.png", k + 1);
            const auto wanted =
                std::get<Image<Rgba8>>(decode_png_with_alpha(read_png_bytes(path), path));
            EXPECT_EQ(wanted(0, 0).a, 0);
            EXPECT_EQ(wanted(20, 15).a, 255);
            for (std::size_t i = 0; i < wanted.pixels().size(); ++i) {
                const Rgba8 &w = wanted.pixels()[i], &d = decoded.frames[k].pixels()[i];
                ASSERT_EQ(d.a, name == "t.gif" ? (w.a >= 128 ? 255 : 0) : w.a) << name;
                if (name != "t.gif" && w.a > 0) {
                    ASSERT_EQ(d, w) << name;
                }
            }
        }
    }
}

TEST_F(RenderRecipes, TellTheWorkOfAllPictures) {
    expect_done(lazy + " -r wood --turntable 2 -o a.gif --report two.json");
    expect_done(lazy + " -r wood -o a.png --report one.json");
    const auto two = nlohmann::json::parse(slurp(scratch / "two.json"));
    const auto one = nlohmann::json::parse(slurp(scratch / "one.json"));
    EXPECT_EQ(two["pictures"], 2);
    EXPECT_EQ(one["pictures"], 1);
    EXPECT_EQ(two["texels_whole"].get<int>(), 2 * one["texels_whole"].get<int>());
}

TEST_F(RenderRecipes, RefuseInOneSentenceAndWriteNothing) {
    scratch.write("a.glb", "no scene");
    const std::pair<const char*, const char*> cases[] = {
        {"a.glb -o a.jpg", "must end in .png, .webp, .gif or .apng"},
        {"a.glb -o a.apng", "--turntable or --frames"},
        {"a.glb -o a.png --frames 3", "say how the camera moves"},
        {"a.glb -o a.png --frames 3 --animate solid.scale=1:2", "has its texture already"},
        {"a.glb -o a.png --turntable 3 --animate pose.weight=0:1", "has its texture already"},
        {"a.glb -o a.png --turntable 3 --animate camera.azimuth=0:1", "--turntable turns"},
        {"a.glb -o a.png --turntable 3 --frames 3", "--frames"},
        {"a.glb -o a.png --turntable 3 --loop", "--loop"},
        {"a.glb -o a.png --turntable 1", "--turntable"},
        {"a.glb -o a.png --animate camera.azimuth=0:1", "needs --frames N"},
        {"a.glb -o a.png --frames 3 --animate camera.tilt=0:1", "camera.elevation"},
        {"a.glb -o a.png --recipes oak", "has its texture already"},
        {"a.glb -o a.png --fps 10", "there is one picture"},
        {"a.glb -o a.png --turntable 3 --fps 10", "numbered .png"},
        {"a.glb -o a.gif --turntable 3 --fps 60", "more than 50"},
        {"a.glb -o a.gif --turntable 3 --quality 60", "is of .webp"},
        {"a.glb -o a.webp --quality 101", "--quality"},
        {"a.glb -o a.png --up up", "--up"},
        {"a.glb -o a.png --view 1,2,3 --frames 2 --animate camera.azimuth=0:1 --animate "
         "camera.elevation=0:1 --animate camera.distance=1:2",
         "--view does nothing"},
        {"--direct --plane 0,1,0,-1 -o a.png --up z", "planes alone"},
        {"--direct sample:cube -o a.png --recipes oak --recipe wood", "--recipe"},
        {"--direct sample:cube -o a.png --columns 2", "--recipes"},
        {"--direct sample:cube -o a.png --recipes zz*", "zz*"},
        {"--direct sample:cube -o a.png --recipes oak,waln", "waln: there is no recipe"},
        {"--direct sample:cube -o a.png --recipes oak,wood --set solid.scale=-1", "oak: "},
        {"--direct sample:cube -o a.png --recipes * --size 4000x4000", "with --size"},
        {"--direct sample:cube -o a.png -r forming-marble --frames 3 --time 1", "--time is one"},
        {"--direct sample:cube -o a.png -r wood --turntable 3 --time 1", "has keys"},
        {"--lazy sample:cube -o a.webp --recipes wood,oak --level-rule direct",
         "oak: --level-rule does nothing"},
    };
    for (const auto& [arguments, hint] : cases) {
        const std::size_t before = scratch.files();
        const Outcome outcome = run_burl(scratch, fmt::format("render {}", arguments),
                                         fmt::format("cd '{}'; set -f;", scratch.path().string()));
        EXPECT_NE(outcome.exit_code, 0) << arguments;
        EXPECT_THAT(outcome.err, testing::HasSubstr(hint)) << arguments;
        expect_one_sentence(outcome.err);
        EXPECT_EQ(scratch.files(), before) << arguments;
    }
}

TEST_F(RenderRecipes, LeaveTheOldFileWhereTheyAreKilledOrTheDiskIsFull) {
    for (const std::string name : {"a.webp", "a.gif", "a.apng"}) {
        scratch.write(name, "old");
        const std::size_t before = scratch.files();
        const std::string turn = fmt::format(
            "render sample:cube --direct --supersample 1 -o '{}' --turntable ", scratch / name);
        EXPECT_EQ(run_burl(scratch, turn + "9999 --size 64x64", "timeout -s KILL 1").exit_code,
                  137);
        EXPECT_EQ(run_burl(scratch, turn + "9999 --size 64x64", "timeout -s TERM 1").exit_code,
                  124);
        const Outcome full =
            run_burl(scratch, turn + "6 -r checker --size 256x256", "ulimit -f 2;");
        EXPECT_NE(full.exit_code, 0);
        EXPECT_EQ(slurp(scratch / name), "old");
        EXPECT_EQ(scratch.files(), before);
    }
}

}  // namespace
}  // namespace burl::test
