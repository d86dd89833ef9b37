// Options and edits that would change nothing are refused in a sentence that names them, before
// anything is read or written; a recipe's file may say what it likes.
#include "app/options/idle_options.h"

#include <gmock/gmock.h>

#include "tests/app/programs/run_program.h"

namespace burl::test {
namespace {

struct IdleLine {
    const char* arguments;
    const char* says;
};

class IdleOptions : public testing::TestWithParam<IdleLine> {};

TEST_P(IdleOptions, AreRefusedInASentence) {
    const Scratch scratch;
    const auto [arguments, says] = GetParam();
    const Outcome outcome =
        run_burl(scratch, arguments, fmt::format("cd '{}';", scratch.path().string()));
    EXPECT_EQ(outcome.exit_code, 1) << arguments << outcome.err;
    expect_one_sentence(outcome.err);
    EXPECT_THAT(outcome.err, testing::HasSubstr(says)) << arguments;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(scratch.files(), 0u) << arguments;
}

INSTANTIATE_TEST_SUITE_P(
    Bake, IdleOptions,
    testing::Values(
        IdleLine{"bake sample:cube -o a.png --gutter 2", "--gutter 2 does nothing"},
        IdleLine{"bake sample:cube -o a.png --weight area", "add --atlas quad"},
        IdleLine{"bake sample:cube -o a.png -a area --partition graph", "this one is area"},
        IdleLine{"bake sample:cube -o a.png --set atlas.gutter=2", "--set atlas.gutter=2 does"},
        IdleLine{"bake sample:cube -o a.png -a quad --overscan nearest --diagonals overscan",
                 "--diagonals overscan does nothing: with overscan nearest"},
        IdleLine{"bake sample:cube -o a.png -a quad --tries 2", "only patch atlases have it"},
        IdleLine{"bake sample:cube -o a.png --set filter.samples=4", "--filter supersample"},
        IdleLine{"bake sample:cube -o a.png --set precision.fraction_bits=4", "fixed:I.F"},
        IdleLine{"bake sample:cube -o a.png --frames 2 --animate filter.samples=4:16",
                 "--animate filter.samples=4:16 does nothing: only --filter supersample"},
        IdleLine{"bake sample:cube -o a.png --frames 2 --animate precision.integer_bits=4:6",
                 "--animate precision.integer_bits=4:6 does nothing: only fixed point"},
        IdleLine{"bake sample:cube -o a.glb --set pose.weight=0.5", "there is no --pose"},
        IdleLine{"bake sample:cube -o a.png --pose sample:cube", "--pose does nothing"},
        IdleLine{"bake sample:cube -o a.png --size 64 --set atlas.size=128",
                 "--size 64 and --set atlas.size=128 say the same thing"},
        IdleLine{"bake sample:cube -o a.png --set atlas.kind=quad --set atlas.kind=area",
                 "--set atlas.kind=area and --set atlas.kind=quad say the same thing"},
        IdleLine{"bake sample:cube -o a.png --set material.base_color=red --set texture=clouds",
                 "--set texture=clouds and --set material.base_color=red say the same thing"},
        IdleLine{"bake sample:cube -o a.glb --set material.alpha_cutoff=0.3",
                 "--set material.alpha_cutoff=0.3 does nothing: only material.alpha mask"},
        IdleLine{"bake sample:cube -o a.png --set texture.input.noise.00.gain=0.3",
                 "texture.input.noise.00.gain"},
        IdleLine{"bake sample:cube -o a.png --channels occlusion,", "ends without a word"},
        IdleLine{"bake sample:cube -o a.png --channels part,,facing", "--channels"},
        IdleLine{"bake sample:cube -o a.png --channels part,part", "part is there twice"},
        IdleLine{
            R"(bake sample:cube -o a.png --channels occlusion --set 'material.occlusion={"node": "fbm"}')",
            "leave occlusion out, or pack"},
        IdleLine{"bake sample:cube -o a.png -r pbrt-marble --kernel share",
                 "--kernel share does nothing: the texture has other nodes"},
        IdleLine{"bake sample:cube -o a.png -r pbrt-marble --kernel direct",
                 "--kernel direct does"},
        IdleLine{"bake sample:cube -o a.png --kernel share --precision float64",
                 "--kernel share does nothing: only --precision float32 has it"},
        IdleLine{"bake sample:cube -o a.png --kernel direct --precision fixed:8.16", "float32"},
        IdleLine{"bake sample:cube -o a.png --kernel scanline --filter exact",
                 "--kernel scanline does nothing: filters take slopes"},
        IdleLine{"bake sample:cube -o a.png -r noise --kernel share --set "
                 "texture.input.noise.0.kind=worley",
                 "--kernel share does nothing: only value and perlin noise"},
        IdleLine{"bake sample:cube -o a.png --time 1", "--time: the recipe marble has no keys"},
        IdleLine{"bake sample:cube -o a.png --time 0", "--time: the recipe marble has no keys"},
        IdleLine{"bake sample:cube -o a.png --crease 30", "--crease does nothing"},
        IdleLine{"bake sample:cube -o a.exr --depth 16", "--depth does nothing"},
        IdleLine{"bake sample:cube -o a.png --cache 64", "--frames"},
        IdleLine{"bake sample:cube -o a.png --unshare-instances", "sample:cube is no glTF"},
        IdleLine{"bake sample:cube -o a.png --json --quiet", "--json prints the report"},
        IdleLine{"bake sample:cube -o a.png --report - -q", "--report - prints the report"},
        IdleLine{"bake sample:cube -o a.png --json --report -", "--json and --report -"},
        IdleLine{"bake sample:cube -o a.stl --levels all", "--levels does nothing: an .stl has no"},
        IdleLine{"bake sample:cube -o a.stl --filter exact", "--filter does nothing"},
        IdleLine{"bake sample:cube -o a.stl --kernel direct", "--kernel does nothing"},
        IdleLine{"bake sample:cube -o a.stl --synth gl", "--synth does nothing"},
        IdleLine{"bake sample:cube -o a.stl --precision float64", "--precision does nothing"},
        IdleLine{"bake sample:cube -o a.stl --depth 16", "--depth does nothing"},
        IdleLine{"bake sample:cube -o a.stl --pack unity", "--pack does nothing"},
        IdleLine{"bake sample:cube -o a.stl --crease 5", "--crease does nothing"},
        IdleLine{"bake sample:cube -o a.stl -r oak --normals object", "--normals does nothing"},
        IdleLine{"bake sample:cube -o a.stl -r rising-fire --time 3", "--time does nothing"},
        IdleLine{"bake sample:cube -o a.stl -a quad --compress 0.1", "--compress does nothing"},
        IdleLine{"bake sample:cube -o a.stl --set solid.scale=2", "--set solid.scale=2 does"},
        IdleLine{"bake sample:cube -o a.png --gl egl", "--gl says where OpenGL comes from"},
        IdleLine{"bake sample:cube -o a.png --gl-precision 8", "--gl-precision"},
        IdleLine{"batch m.json -r oak", R"(write "recipe" in one of them or in "defaults")"},
        IdleLine{"batch m.json -s 64", "m.json: --size is for meshes on the command line"},
        IdleLine{"batch m.json -o a.png", "m.json: --output is for meshes"},
        IdleLine{"batch m.json --with nonsense=3", "m.json: --with nonsense is for meshes"},
        IdleLine{"batch m.json --json --quiet", "--json prints the report"}));

INSTANTIATE_TEST_SUITE_P(
    Render, IdleOptions,
    testing::Values(
        IdleLine{"render a.glb -o a.png --crease 30", "--crease goes with --direct or --lazy"},
        IdleLine{"render a.glb -o a.png --weld 0.1", "--weld goes with --direct or --lazy"},
        IdleLine{"render a.glb -o a.png --unshare-instances", "--unshare-instances goes with"},
        IdleLine{"render a.glb -o a.png --time 1", "--time goes with"},
        IdleLine{"render --direct sample:cube -o a.png --time 1", "no recipe of the picture has"},
        IdleLine{"render --direct sample:cube -o a.png --set atlas.size=64", "without an atlas"},
        IdleLine{"render --direct sample:cube -o a.png --set filter.kind=exact", "--filter"},
        IdleLine{"render --direct sample:cube -o a.png --set pose.weight=0", "there is no --pose"},
        IdleLine{"render --direct sample:cube -o a.png --set precision.integer_bits=5",
                 "--set precision.integer_bits=5 does nothing: only fixed point"},
        IdleLine{"render --direct sample:cube -o a.png --frames 2 --animate "
                 "precision.integer_bits=4:6",
                 "--animate precision.integer_bits=4:6 does nothing"},
        IdleLine{"render --direct sample:cube -o a.png --unlit --crease 9", "--unlit"},
        IdleLine{"render --lazy sample:cube -o a.png --unlit --light sun",
                 "--light is about light"},
        IdleLine{"render --direct sample:cube -o a.png --unlit --rays 9", "--rays is about"},
        IdleLine{"render --direct sample:cube -o a.png --light headlight --rays 9", "--rays is"},
        IdleLine{"render --lazy sample:cube -o a.png --unlit --ground", "--ground is about light"},
        IdleLine{"render --lazy sample:cube -o a.png --light headlight --turn-light 20",
                 "--turn-light does nothing"},
        IdleLine{"render --lazy sample:cube -o a.png --recipe gold --level-rule average",
                 "--level-rule does nothing"},
        IdleLine{"render --lazy sample:cube -o a.png --level-rule sharp",
                 "bake with --levels sharp and render that"},
        IdleLine{"render --direct sample:cube -o a.png --widths --filter exact", "--widths"},
        IdleLine{"render --direct --plane 0,1,0,-1 -o a.png --weld 0.1", "planes alone"},
        IdleLine{"render --direct --plane sea:0,1,0,-1 -o a.png -r wood", "shown nowhere"},
        IdleLine{"render --lazy sample:cube -o a.png --filter linear --level-rule average",
                 "--level-rule"},
        IdleLine{"render --lazy sample:cube -o a.png --set atlas.gutter=2", "only quad"}));

INSTANTIATE_TEST_SUITE_P(
    Others, IdleOptions,
    testing::Values(
        IdleLine{"metrics sample:cube --level-rule sharp", "--level-rule is about lookups"},
        IdleLine{"metrics sample:cube --gutter 2", "--gutter 2 does nothing"},
        IdleLine{"metrics sample:cube --view 0,0,3", "--image"},
        IdleLine{"metrics sample:cube --fill black", "--fill is about lookups"},
        IdleLine{"metrics sample:cube --texture recipe", "--texture is about lookups"},
        IdleLine{"metrics sample:cube --set solid.scale=3", "looks up no texture of the recipe"},
        IdleLine{"metrics sample:cube --levels --set solid.scale=3", "--texture recipe"},
        IdleLine{"metrics sample:cube -r wood", "--recipe wood does nothing: metrics looks up no"},
        IdleLine{"metrics sample:cube -r forming-marble --time 1", "--time does nothing"},
        IdleLine{"diff a.png b.png --scale 0.5", "--output"},
        IdleLine{"eval marble --points p.csv --set atlas.size=4", "eval works without an atlas"},
        IdleLine{"eval marble --points p.csv --time 1", "--time: the recipe marble has no keys"},
        IdleLine{"eval marble --points p.csv --octaves 3", "--octaves is of --noise"},
        IdleLine{"eval --noise perlin --points p.csv --time 1", "--set and --time are of recipes"},
        IdleLine{"eval --noise perlin --points p.csv --fade linear", "--fade is of value noise"},
        IdleLine{"eval --noise value --points p.csv --gain 0.4", "--gain is of several octaves"},
        IdleLine{"bench noise --thorough", "bench noise: --thorough does nothing"},
        IdleLine{"bench noise --case coordinates/1", "bench noise: --case does nothing"},
        IdleLine{"figures --commands -o f", "--output"}));

TEST(IdleRecipeNumbers, MayStandInTheRecipesFile) {
    const Scratch scratch;
    const std::string recipe = scratch.write("r.json", R"({"atlas": {"gutter": 2, "tries": 2},
        "filter": {"samples": 4}, "precision": {"fraction_bits": 4}, "pose": {"weight": 0.5}})");
    for (const char* kind : {"patch", "quad", "area"})
        EXPECT_EQ(run_burl(scratch, fmt::format("bake sample:cube -o '{}' -s 64 -r '{}' -a {}",
                                                scratch / "a.png", recipe, kind))
                      .exit_code,
                  0)
            << kind;
    EXPECT_EQ(run_burl(scratch, fmt::format("metrics sample:cube --size 64 --atlas all --gutter 2 "
                                            "--tries 2 -r '{}'",
                                            recipe))
                  .exit_code,
              0);
}

TEST(IdleRecipeNumbers, HaveASayWhereTheyAreUsed) {
    Recipe recipe;
    EXPECT_NE(idle_reason(recipe, "atlas.gutter"), "");
    EXPECT_NE(idle_reason(recipe, "atlas.tries"), "");
    recipe.atlas.kind = AtlasKind::patch;
    EXPECT_EQ(idle_reason(recipe, "atlas.tries"), "");
    recipe.atlas.kind = AtlasKind::quad;
    for (const char* path : {"atlas.gutter", "atlas.diagonals", "atlas.weight", "atlas.partition"})
        EXPECT_EQ(idle_reason(recipe, path), "") << path;
    EXPECT_NE(idle_reason(recipe, "atlas.tries"), "");
    recipe.atlas.overscan = Overscan::nearest;
    EXPECT_NE(idle_reason(recipe, "atlas.gutter"), "");
    EXPECT_EQ(idle_reason(recipe, "atlas.weight"), "");
    recipe.filter.kind = FilterKind::supersample;
    recipe.precision.kind = PrecisionKind::fixed;
    for (const char* path : {"filter.samples", "precision.integer_bits", "texture.wrap"})
        EXPECT_EQ(idle_reason(recipe, path), "") << path;
}

}  // namespace
}  // namespace burl::test
