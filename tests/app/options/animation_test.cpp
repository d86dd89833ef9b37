// Frames of an animation against bakes and pictures of single recipes, and what is refused before
// anything is written.
#include "app/options/animation.h"

#include <algorithm>

#include <gmock/gmock.h>

#include "app/image/image_io.h"
#include "app/pipeline/pipeline.h"
#include "app/recipe/edit/recipe_json.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "procedural/model/octaves.h"
#include "tests/app/programs/run_program.h"
#include "tests/app/support/sample_scene.h"

namespace burl::test {
namespace {
const char* const square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
const std::string amplitude = "texture.input.noise.0.amplitude";
const std::string phase = "texture.input.noise.0.phase.2";
const std::string seed = "texture.input.noise.0.seed";

double between(double from, double to, int i, int last) {
    const double t = i / double(last);
    return (1.0 - t) * from + t * to;
}

TEST(Animation, GoesLinearlyAndExactlyFromOneEndToTheOther) {
    for (const bool loop : {false, true}) {
        const int last = loop ? 10 : 9;
        const auto recipes =
            frame_recipes(RecipeOptions(), {{amplitude + "=0.1:0.7", seed + "=1:4"}, 10, loop});
        ASSERT_EQ(recipes.size(), 10u);
        for (int i = 0; i < 10; ++i)
            EXPECT_EQ(recipes[std::size_t(i)],
                      load_recipe("marble",
                                  {fmt::format("{}={}", amplitude, between(0.1, 0.7, i, last)),
                                   fmt::format("{}={}", seed, std::round(1 + 3.0 * i / last))}));
        EXPECT_EQ(recipes[0], load_recipe("marble", {amplitude + "=0.1", seed + "=1"}));
        EXPECT_EQ(recipes[9] == load_recipe("marble", {amplitude + "=0.7", seed + "=4"}), !loop);
    }
}

TEST(Animation, NumbersItsFiles) {
    EXPECT_EQ(frame_path("a/b.c/out.png", 1), "a/b.c/out.0001.png");
    EXPECT_EQ(frame_path("out.v2.EXR", 9999), "out.v2.9999.EXR");
    EXPECT_EQ(frame_paths("o.png", {}), std::vector<std::string>{"o.png"});
    EXPECT_EQ(frame_paths("o.png", {{"x=0:1"}, 12, false}).back(), "o.0012.png");
}

TEST(Animation, SetsEveryKeyInEveryFrameAndNothingElse) {
    RecipeOptions options;
    options.recipe = "fire";
    options.settings = {"texture.input.noise.0.octaves=2"};
    const auto recipes =
        frame_recipes(options, {{phase + "=0:-3", "solid.scale=1:2", "texture.stops.1.0=0.1:0.4",
                                 "texture.input.noise.0.seed=5:8"},
                                4,
                                false});
    ASSERT_EQ(recipes.size(), 4u);
    for (int i = 0; i < 4; ++i) {
        const Recipe expected =
            load_recipe("fire", {"texture.input.noise.0.octaves=2", fmt::format("{}={}", phase, -i),
                                 fmt::format("solid.scale={}", between(1, 2, i, 3)),
                                 fmt::format("texture.stops.1.0={}", between(0.1, 0.4, i, 3)),
                                 fmt::format("texture.input.noise.0.seed={}", 5 + i)});
        EXPECT_EQ(recipes[std::size_t(i)], expected) << i;
    }
}

TEST(Animation, MovesNumbersOfATextureGraph) {
    const Scratch scratch;
    RecipeOptions options;
    options.recipe =
        scratch.write("g.json", R"({"texture": {"node": "scale", "a": "#ff8040", "b": 0.7}})");
    const auto recipes = frame_recipes(options, {{"texture.b=0:1"}, 3, false});
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(recipes.at(std::size_t(i)),
                  load_recipe(options.recipe, {fmt::format("texture.b={}", 0.5 * i)}));
    EXPECT_NE(recipes[0], recipes[2]);
    EXPECT_THROW(frame_recipes(options, {{"texture.bb=1:3"}, 3, false}), Error);
}

TEST(Animation, LaysTheMeshOutOnce) {
    RecipeOptions options;
    options.settings = {"atlas.size=64"};
    Pipeline pipeline(cube_mesh());
    for (const Recipe& recipe : frame_recipes(options, {{amplitude + "=0:1"}, 5, false})) {
        pipeline.set_recipe(recipe);
        pipeline.synthesize<Rgb8>();
    }
    EXPECT_EQ(pipeline.records()[Stage::layout].runs, 1u);
    EXPECT_EQ(pipeline.records()[Stage::spans].runs, 1u);
    EXPECT_EQ(pipeline.records()[Stage::synthesis].runs, 5u);
}

TEST(Animation, LoopsWithPeriodicNoise) {
    // As docs/reference/usage.md says: period 2, three octaves, so the phase must move by 2 * 2^2
    // cells.
    const std::vector<std::string> periodic{"texture.input.noise.0.period=[2,2,2]",
                                            "texture.input.noise.0.octaves=3"};
    const auto field = [&](int cells, const Vec3d& s) {
        std::vector<std::string> settings = periodic;
        settings.push_back(fmt::format("{}={}", phase, cells));
        return evaluate_field(*plain_texture(load_recipe("fire", settings).texture), s);
    };
    for (int i = 0; i < 20; ++i) {
        const Vec3d s(0.37 * i, 0.1, -0.23 * i);
        EXPECT_NEAR(field(8, s), field(0, s), 1e-12);
        EXPECT_GT(std::abs(field(4, s) - field(0, s)), 1e-6);
    }
}

TEST(Animation, TimeIsTheFourthCoordinateOfEveryOctave) {
    const auto recipe = [](const std::string& time) {
        return load_recipe("clouds", {"texture.input.noise.0.time=" + time,
                                      "texture.input.noise.0.time_period=4"});
    };
    for (int i = 0; i < 20; ++i) {
        const Vec3d s(0.3711 * i + 0.0313, 0.1017, 0.0417 - 0.2319 * i);
        double sum = 0.0, a = 0.25, frequency = 2.0;  // half the amplitudes: unit range
        for (std::uint32_t k = 0; k < 4; ++k, a *= 0.5, frequency *= 2.0) {
            NoiseSpec noise{.seed = k};
            noise.period[3] = 4;
            sum += a + a * sample_noise<double, 4>(
                               noise, {frequency * s.x, frequency * s.y, frequency * s.z, 1.3})
                               .value;
        }
        EXPECT_NEAR(evaluate_field(*plain_texture(recipe("1.3").texture), s), sum, 1e-13);
        EXPECT_EQ(evaluate_field(*plain_texture(recipe("0.5").texture), s),
                  evaluate_field(*plain_texture(recipe("4.5").texture), s));
        const auto octaves = expand_octaves(*plain_texture(recipe("1.3").texture));
        const FieldSample f = sample_field<double>({}, octaves, s);
        for (int axis = 0; axis < 3; ++axis) {
            Vec3d h(0.0);
            h[axis] = 1e-6;
            const double slope =
                (evaluate_field({}, octaves, s + h) - evaluate_field({}, octaves, s - h)) / 2e-6;
            EXPECT_NEAR(f.gradient[axis], slope, 1e-6);
        }
    }
    EXPECT_EQ(parse_recipe(to_json(recipe("1.3")), "again"), recipe("1.3"));
}

class AnimatedBake : public testing::Test {
  protected:
    Outcome burl(const std::string& arguments) {
        return run_burl(scratch, fmt::format("{} --size 64", arguments));
    }
    /// The file that a bake of its own gives.
    std::string single(const std::string& out, const std::string& options) {
        EXPECT_EQ(burl(fmt::format("bake '{}' -o '{}' {}", mesh, scratch / out, options)).exit_code,
                  0);
        return slurp(scratch / out);
    }

    const Scratch scratch;
    const std::string mesh = scratch.write("m.obj", square);
};

TEST_F(AnimatedBake, GivesTheBytesOfSingleBakesForEveryThreadCount) {
    const std::vector<std::string> expected{single("0.png", "--set " + amplitude + "=0"),
                                            single("1.png", "--set " + amplitude + "=0.25"),
                                            single("2.png", "--set " + amplitude + "=0.5")};
    EXPECT_NE(expected[0], expected[1]);
    EXPECT_NE(expected[1], expected[2]);
    const std::size_t before = scratch.files();
    for (const int threads : {1, 3}) {
        const Outcome outcome =
            burl(fmt::format("bake '{}' -o '{}' --animate {}=0:0.5 --frames 3 -j {}", mesh,
                             scratch / fmt::format("j{}.png", threads), amplitude, threads));
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_THAT(outcome.out, testing::HasSubstr(".0001.png to "));
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_EQ(slurp(scratch / fmt::format("j{}.000{}.png", threads, i + 1)), expected[i]);
    }
    EXPECT_EQ(scratch.files(), before + 8);  // with a record of each run
}

TEST_F(AnimatedBake, LoopsAndReportsItsFiles) {
    const Outcome outcome = burl(
        fmt::format("bake '{}' -o '{}' --recipe fire --animate {}=0:4 --frames 4 --loop --json",
                    mesh, scratch / "f.exr", phase));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto report = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(report["outputs"].size(), 4u);
    EXPECT_EQ(report["outputs"][3].get<std::string>(), scratch / "f.0004.exr");
    EXPECT_EQ(report["animation"].size(), 1u);
    EXPECT_EQ(slurp(scratch / "f.0004.exr"),
              single("s.exr", "--recipe fire --set " + phase + "=3"));
}

TEST_F(AnimatedBake, ReportsNoTracksWhereTheRecipeHasItsOwn) {
    const Outcome outcome = burl(fmt::format(
        "bake '{}' -o '{}' --recipe forming-marble --frames 2 --json", mesh, scratch / "k.png"));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto report = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(report["outputs"].size(), 2u);
    EXPECT_FALSE(report.contains("animation"));
}

TEST_F(AnimatedBake, ComesBackToItsFirstFrameAfterThePeriodOfTime) {
    const std::string time = "texture.input.noise.0.time";
    const Outcome outcome =
        burl(fmt::format("bake '{}' -o '{}' --set {}_period=3 --animate {}=0:3 --frames 5", mesh,
                         scratch / "t.png", time, time));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(slurp(scratch / "t.0001.png"), slurp(scratch / "t.0005.png"));
    EXPECT_NE(slurp(scratch / "t.0001.png"), slurp(scratch / "t.0002.png"));
    EXPECT_EQ(slurp(scratch / "t.0003.png"),
              single("s.png", fmt::format("--set {}_period=3 --set {}=1.5 -j 1", time, time)));
}

TEST_F(AnimatedBake, RefusesWithOneSentenceAndWritesNothing) {
    fs::create_directory(scratch / "blocked.0002.png");
    const std::string good = "--animate solid.scale=1:2 --frames 3";
    const struct {
        std::string out, options;
        int exit_code;
        std::string hint;
    } cases[] = {
        {"a.png", "--animate gain=0:1 --frames 3", 1, "noise.0.gain"},
        {"a.png", "--animate solid.scal=1:2 --frames 3", 1, "--animate: there is no parameter"},
        {"a.png", "--animate solid.scale --frames 3", 1, "PATH=FROM:TO"},
        {"a.png", "--animate solid.scale=1 --frames 3", 1, "PATH=FROM:TO"},
        {"a.png", "--animate solid.scale=1:two --frames 3", 1, "two"},
        {"a.png", "--animate solid.scale=nan:2 --frames 3", 1, "numbers"},
        {"a.png", "--animate solid.scale=1: --frames 3", 1, "numbers"},
        {"a.png", "--animate solid.scale=1:-1 --frames 3", 1, "(frame 2)"},
        {"a.png",
         "--animate texture.input.noise.0.time=0:1 --frames 3 --set "
         "texture.input.noise.0.kind=perlin1985",
         1, "perlin1985"},
        {"a.png",
         "--animate texture.input.noise.0.time=0:3 --frames 3 --set "
         "texture.input.noise.0.kind=simplex --set texture.input.noise.0.time_period=3",
         1, "no period"},
        {"a.png", "--animate texture.wrap=0:1 --frames 3", 1, "choice"},
        {"a.png", "--animate texture.stops.0.1=0:1 --frames 3", 1, "color"},
        {"a.png", "--animate texture.input.noise.0.phase=0:1 --frames 3", 1, "phase.0=FROM:TO"},
        {"a.png", "--animate texture.input.noise.0.phase.7=0:1 --frames 3", 1, "0 to 2"},
        {"a.png", "--animate atlas.size=64:128 --frames 3", 1, "share one atlas"},
        {"a.png", "--animate texture.stops.0.0=0:1 --frames 3", 1, "(frame 2)"},
        {"a.png", good + " --animate solid.scale=3:4", 1, "twice"},
        {"a.png", good + " --set solid.scale=9", 1, "--set solid.scale=9 does nothing: --animate"},
        {"a.png", "--filter supersample:4 --animate filter.samples=4:16 --frames 2", 1,
         "--filter supersample:4 does nothing: --animate filter.samples=4:16"},
        {"a.png", "-r forming-marble --frames 2 --set " + amplitude + "=0.1", 1,
         "amplitude=0.1 does nothing: the recipe has keys"},
        {"a.png", "-r forming-marble --time 3 --set " + amplitude + "=0.1", 1,
         "amplitude=0.1 does nothing: the recipe has keys"},
        {"a.png", "--animate solid.scale=1:2", 1, "--frames"},
        {"a.png", "--frames 3", 1, "has no keys over time"},
        {"a.png", "--frames 3 --time 1", 1, "--time"},
        {"a.png", "--loop", 1, "--frames"},
        {"a.png", "--animate solid.scale=1:2 --frames 1", 1, "--frames"},
        {"a.png", "--animate solid.scale=1:2 --frames 10000", 1, "--frames"},
        {"a.png", good + " --levels 2", 1, "--levels"},
        {"a.glb", good, 1, "once without --frames"},
        {"blocked.png", good, 2, "blocked.0002.png"},
    };
    const std::size_t before = scratch.files();
    for (const auto& bad : cases) {
        const Outcome outcome =
            burl(fmt::format("bake '{}' -o '{}' {}", mesh, scratch / bad.out, bad.options));
        EXPECT_EQ(outcome.exit_code, bad.exit_code) << bad.options << outcome.err;
        EXPECT_THAT(outcome.err, testing::HasSubstr(bad.hint)) << bad.options;
        expect_one_sentence(outcome.err);
        EXPECT_EQ(scratch.files(), before) << bad.options;
    }
}

TEST(AnimatedPicture, EndsWithThePicturesOfSingleRecipes) {
    const Scratch scratch;
    const std::string mesh = scratch.write("m.obj", square);
    const auto render = [&](const std::string& out, const std::string& options) {
        const Outcome outcome =
            run_burl(scratch, fmt::format("render --direct '{}' -o '{}' --size 48x32 {}", mesh,
                                          scratch / out, options));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return slurp(scratch / out);
    };
    render("a.png", "--animate " + amplitude + "=0:0.5 --frames 3");
    EXPECT_FALSE(fs::exists(scratch / "a.png"));
    for (const auto& [frame, value] : {std::pair(1, 0.0), std::pair(2, 0.25), std::pair(3, 0.5)})
        EXPECT_EQ(slurp(scratch / fmt::format("a.000{}.png", frame)),
                  render("b.png", fmt::format("--set {}={}", amplitude, value)));
    EXPECT_NE(slurp(scratch / "a.0001.png"), slurp(scratch / "a.0003.png"));
}

/// Pictures of a sea under a sky, each with a recipe of its own.
class AnimatedPlanes : public testing::Test {
  protected:
    Outcome render(const std::string& out, const std::string& options,
                   const std::string& planes = "--plane sea:0,1,0,-0.6 --plane clouds:0,1,0,1") {
        return run_burl(scratch,
                        fmt::format("render --direct {} --view 0,-3,3.5 --unlit --size 40x30 "
                                    "--supersample 1 -o '{}' {}",
                                    planes, scratch / out, options));
    }
    /// The file of a picture that must be made.
    std::string picture(const std::string& options) {
        const Outcome outcome = render("one.png", options);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return slurp(scratch / "one.png");
    }
    std::string frame(int number) { return slurp(scratch / fmt::format("f.000{}.png", number)); }

    const Scratch scratch;
};

TEST_F(AnimatedPlanes, MoveByTheNamesOfTheirRecipes) {
    const Outcome outcome = render("f.png",
                                   "--animate sea:solid.translate.2=0:-4 --animate "
                                   "clouds:solid.translate.2=0:-2 --frames 3");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(frame(1), frame(2));
    EXPECT_NE(frame(2), frame(3));
    EXPECT_EQ(frame(1), picture(""));
    EXPECT_EQ(frame(2),
              picture("--set sea:solid.translate.2=-2 --set clouds:solid.translate.2=-1"));
    EXPECT_EQ(frame(3),
              picture("--set clouds:solid.translate.2=-2 --set sea:solid.translate.2=-4"));
    EXPECT_NE(frame(3), picture("--set sea:solid.translate.2=-4"));
    EXPECT_NE(frame(3), picture("--set clouds:solid.translate.2=-2"));
}

TEST_F(AnimatedPlanes, EditOneRecipeAndLeaveTheOther) {
    const Image<Rgb8> plain = [&] {
        picture("");
        return read_png(scratch / "one.png");
    }();
    picture("--set 'sea:texture.stops=[[0,\"#ff0000\"]]'");
    const Image<Rgb8> red = read_png(scratch / "one.png");
    // The horizon lies above the middle; the picture looks up by three degrees.
    EXPECT_EQ(red(20, 29), (Rgb8{255, 0, 0}));
    EXPECT_NE(plain(20, 29), red(20, 29));
    for (std::size_t x = 0; x < 40; ++x) EXPECT_EQ(plain(x, 0), red(x, 0));
}

TEST_F(AnimatedPlanes, ShareOneClockOfTheirKeys) {
    const auto keyed = [&](const char* name, double seconds) {
        return scratch.write(
            name, fmt::format(R"({{"texture": {{"node": "scale", "a": "#ff8040", "b": 0}},
                "animation": {{"seconds": {0}, "tracks":
                [{{"path": "texture.b", "keys": [[0, 0], [{0}, 1]]}}]}}}})",
                              seconds));
    };
    const std::string planes = fmt::format("--plane '{}:0,1,0,-0.6' --plane '{}:0,1,0,1'",
                                           keyed("a.json", 2), keyed("b.json", 4));
    ASSERT_EQ(render("f.png", "--frames 3", planes).exit_code, 0);
    for (const auto& [number, seconds] : {std::pair(1, 0), std::pair(2, 2), std::pair(3, 4)}) {
        ASSERT_EQ(render("one.png", fmt::format("--time {}", seconds), planes).exit_code, 0);
        EXPECT_EQ(frame(number), slurp(scratch / "one.png")) << number;
    }
    EXPECT_NE(frame(1), frame(2));
    EXPECT_NE(frame(2), frame(3));
}

TEST_F(AnimatedPlanes, ComputeInThePrecisionThatIsAsked) {
    EXPECT_NE(picture("--precision fixed:8.4 --filter none"), picture("--filter none"));
}

TEST_F(AnimatedPlanes, RefuseEditsOfWhatIsNotShown) {
    const std::pair<const char*, const char*> cases[] = {
        {"--set solid.scale=2", "--set sea:PATH="},
        {"--set see:solid.scale=2", "does not show a recipe see"},
        {"--set sea:solid.scal=2", "did you mean \"solid.scale\"?"},
        {"--set sea:texture.input.noise.5.gain=1", "next index"},
        {"--animate solid.scale=1:2 --frames 2", "--animate sea:PATH="},
        {"--animate sea:solid.scal=1:2 --frames 2", "--animate: there is no parameter"},
        {"--frames 2", "no keys over time"},
        {"--time 1", "keys over time"},
        {"--set sea:atlas.size=4", "without an atlas"}};
    for (const auto& [options, hint] : cases) {
        const Outcome outcome = render("f.png", options);
        EXPECT_EQ(outcome.exit_code, 1) << options;
        expect_one_sentence(outcome.err);
        EXPECT_THAT(outcome.err, testing::HasSubstr(hint)) << options;
        EXPECT_EQ(scratch.files(), 0u) << options;
    }
}

TEST_F(AnimatedPlanes, WithoutANameShowWhatTheMeshShows) {
    const auto with_mesh = [&](const std::string& options) {
        EXPECT_EQ(render("m.png", options,
                         "sample:cube -r wood --plane 0,1,0,-1 --plane "
                         "sea:0,1,0,-2")
                      .exit_code,
                  0);
        return slurp(scratch / "m.png");
    };
    EXPECT_EQ(with_mesh("--set solid.scale=3"), with_mesh("--set wood:solid.scale=3"));
    EXPECT_NE(with_mesh("--set solid.scale=3"), with_mesh(""));
}

}  // namespace
}  // namespace burl::test
