// `burl eval` from outside: what it prints against the library, closed forms and published values.

#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/recipe.h"
#include "atlas/base/json.h"
#include "procedural/fixed/noise.h"
#include "procedural/model/octaves.h"
#include "procedural/noise/noise.h"
#include "tests/app/programs/run_program.h"
#include "tests/procedural/noise/reference_values.h"

namespace burl::test {
namespace {

using Json = nlohmann::json;

Json eval_json(const Scratch& scratch, const std::string& points, const std::string& options) {
    const std::string path = scratch.write("points.csv", points);
    const Outcome outcome =
        run_burl(scratch, fmt::format("eval {} --points '{}' --json", options, path));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return Json::parse(outcome.out);
}

TEST(Eval, PrintsPublishedValues) {
    const Scratch scratch;
    const Json perlin = eval_json(scratch, "3.14,42,7\n", "--noise perlin2002");
    EXPECT_NEAR(perlin["points"][0]["float64"]["value"].get<double>(), 0.13691995878400012, 1e-15);
    EXPECT_NEAR(perlin["points"][0]["float32"]["value"].get<double>(), 0.13691995878400012, 5e-7);

    // Other columns than coordinates are ignored, so tables of references can be fed as they are.
    std::string table = "noise, x,y,z\r\n\n# a remark\n";
    for (const auto& [x, y, z, noise] : simplex_values)
        table += fmt::format("{},{:.17g},{:.17g},{:.17g}\n", noise, x, y, z);
    const Json simplex = eval_json(scratch, table, "--noise simplex");
    ASSERT_EQ(simplex["points"].size(), std::size(simplex_values));
    for (std::size_t i = 0; i < std::size(simplex_values); ++i)
        EXPECT_NEAR(simplex["points"][i]["float64"]["value"].get<double>(), simplex_values[i].noise,
                    1e-12);
    EXPECT_LT(simplex["largest_difference"]["value"].get<double>(), 5e-7);
    EXPECT_GT(simplex["largest_difference"]["value"].get<double>(), 0.0);
}

TEST(Eval, GivesARecipesFieldGradientAndColor) {
    const Scratch scratch;
    const double h = 1e-6;
    const Json all =
        eval_json(scratch, fmt::format("0.1,0.2,0.3\n{},0.2,0.3\n{},0.2,0.3\n", 0.1 + h, 0.1 - h),
                  "marble --set solid.scale=3");
    const auto value = [&](int i) {
        return all["points"][std::size_t(i)]["float64"]["value"].get<double>();
    };
    const Recipe recipe = load_recipe("marble", {"solid.scale=3"});
    EXPECT_NEAR(value(0),
                evaluate_field(*plain_texture(recipe.texture), 3.0 * Vec3d(0.1, 0.2, 0.3)), 1e-14);
    const Json& first = all["points"][0]["float64"];
    EXPECT_NEAR(first["gradient"][0].get<double>(), (value(1) - value(2)) / (2 * h), 1e-6);
    const Vec3d color = evaluate_color(plain_texture(recipe.texture)->colors, value(0));
    for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(first["color"][std::size_t(channel)].get<double>(), color[channel], 1e-14);
    EXPECT_EQ(first["srgb"].get<std::string>().size(), 7u);
    EXPECT_NEAR(all["points"][0]["float32"]["value"].get<double>(), value(0), 1e-6);
}

TEST(Eval, TakesAsManyDimensionsAsThePointsHave) {
    const Scratch scratch;
    const Json line = eval_json(scratch, "0.5\n", "--noise perlin1985");
    const NoiseSpec classic{.kind = NoiseKind::perlin1985};
    EXPECT_EQ(line["points"][0]["float64"]["value"].get<double>(),
              sample_noise<double>(classic, Point<1>{0.5}).value);
    const Json four = eval_json(scratch, "x,y,z,w\n0.25,1.5,-2.75,9.125\n",
                                "--noise perlin --seed 7 --period 4,5,6,7");
    const auto expected =
        sample_noise<double>({.kind = NoiseKind::perlin, .seed = 7, .period = {4, 5, 6, 7}},
                             Point<4>{0.25, 1.5, -2.75, 9.125});
    EXPECT_EQ(four["points"][0]["float64"]["value"].get<double>(), expected.value);
    for (std::size_t axis = 0; axis < 4; ++axis)
        EXPECT_EQ(four["points"][0]["float64"]["gradient"][axis].get<double>(),
                  expected.gradient[axis]);
}

TEST(Eval, SumsOctavesAndWarps) {
    const Scratch scratch;
    const Json sum = eval_json(scratch, "0.3,0.7,-1.2\n",
                               "--noise perlin --octaves 2 --sum turbulence --gain 0.25 "
                               "--lacunarity 3 --normalized");
    const auto octave = [](std::uint32_t seed, const Point<3>& p) {
        return std::abs(sample_noise<double>({.kind = NoiseKind::perlin, .seed = seed}, p).value);
    };
    EXPECT_NEAR(sum["points"][0]["float64"]["value"].get<double>(),
                (octave(0, {0.3, 0.7, -1.2}) + 0.25 * octave(1, {0.9, 2.1, -3.6})) / 1.25, 1e-13);
    const auto value = [&](const std::string& options) {
        return eval_json(scratch, "0.3,0.7,-1.2\n",
                         "--noise value " + options)["points"][0]["float64"]["value"]
            .get<double>();
    };
    EXPECT_EQ(value("--warp 0"), value(""));
    EXPECT_NE(value("--warp 0.5"), value(""));
}

TEST(Eval, PrintsATableWhoseNumbersAreExact) {
    const Scratch scratch;
    const std::string path = scratch.write("p.csv", "0.1,0.2,0.3\n");
    const Outcome noise = run_burl(scratch, fmt::format("eval --noise value --points '{}'", path));
    EXPECT_EQ(noise.exit_code, 0) << noise.err;
    EXPECT_TRUE(noise.out.starts_with("x,y,z,value,dx,dy,dz,value32,dx32,dy32,dz32\n0.1"))
        << noise.out;
    const double exact =
        sample_noise<double>({.kind = NoiseKind::value}, Point<3>{0.1, 0.2, 0.3}).value;
    EXPECT_NE(noise.out.find(fmt::format(",{:.17g},", exact)), std::string::npos) << noise.out;
    const Outcome recipe = run_burl(scratch, fmt::format("eval wood --points '{}'", path));
    EXPECT_NE(recipe.out.find(",red,green,blue,srgb,value32,"), std::string::npos) << recipe.out;
    EXPECT_EQ(std::count(recipe.out.begin(), recipe.out.end(), '\n'), 2);
}

TEST(Eval, AddsFixedPointWhereAsked) {
    const Scratch scratch;
    const std::string points = "0.3,0.7,-1.2\n";
    const FixedFormat format{8, 6};
    const NoiseSpec noise{.kind = NoiseKind::value, .seed = 3};
    const Json one = eval_json(scratch, points, "--noise value --seed 3 --precision fixed:8.6");
    EXPECT_EQ(one["points"][0]["fixed"]["value"].get<double>(),
              fixed_noise(noise, format, {0.3, 0.7, -1.2}));
    const Json wood = eval_json(scratch, "0.3,0.7,1.2\n", "wood --precision fixed:8.12");
    const double difference = wood["largest_difference"]["value"].get<double>();
    EXPECT_LT(difference, 20.0 / 4096);
    EXPECT_GT(difference, 0.0);
    EXPECT_EQ(wood["points"][0]["fixed"]["srgb"].get<std::string>().size(), 7u);
    const std::string path = scratch.write("p.csv", points);
    const Outcome table = run_burl(
        scratch, fmt::format("eval --noise value --precision fixed:8.8 --points '{}'", path));
    EXPECT_NE(table.out.find(",dz,value_fixed\n"), std::string::npos) << table.out;
    const Json exact = eval_json(scratch, points, "wood --precision float64");
    EXPECT_EQ(exact["points"][0].size(), 2u);  // the point and float64
    const Json sum =
        eval_json(scratch, points, "--noise perlin --octaves 3 --precision fixed:8.14");
    EXPECT_LT(sum["largest_difference"]["value"].get<double>(), 100.0 * 0x1p-14);
    EXPECT_GT(sum["largest_difference"]["value"].get<double>(), 0.0);
}

TEST(Eval, GivesTheChannelsOfAMaterial) {
    const Scratch scratch;
    const std::string recipe = scratch.write("m.json", R"({
        "define": {"ramp": {"node": "coordinate", "direction": [2, 0, 0], "offset": 0.1}},
        "material": {"base_color": {"node": "scale", "a": "#ffffff80", "b": "ramp"},
            "opacity": {"node": "multiply", "a": "ramp", "b": 0.5}, "ior": 1.25,
            "roughness": {"node": "subtract", "a": 1, "b": "ramp"}, "emissive": "#ff0000",
            "height": {"node": "multiply", "a": "ramp", "b": "ramp"}}})");
    const double ramp = 2 * 0.2 + 0.1;
    const auto channel = [&](const std::string& name) {
        return eval_json(scratch, "0.2,7,-3\n",
                         fmt::format("'{}' --channel {}", recipe, name))["points"][0]["float64"];
    };
    const auto expect = [&](const std::string& name, double value, double slope) {
        EXPECT_NEAR(channel(name)["value"].get<double>(), value, 1e-15) << name;
        EXPECT_NEAR(channel(name)["gradient"][0].get<double>(), slope, 1e-15) << name;
    };
    expect("roughness", 1 - ramp, -2);
    expect("height", ramp * ramp, 4 * ramp);
    expect("opacity", 0.5 * ramp, 1);
    expect("metallic", 0, 0);
    expect("ior", 1.25, 0);
    const double alpha = 128.0 / 255;
    expect("base_color", alpha * ramp, 2 * alpha);
    // A number is an opaque grey, so it scales red, green and blue alone.
    expect("alpha", alpha * 0.5 * ramp, alpha);
    EXPECT_EQ(channel("emissive")["srgb"].get<std::string>(), "#ff0000");
}

struct BadEval {
    const char* content;
    const char* options;
    int exit_code;
    const char* says;
};

TEST(Eval, RefusesWhatItCannotDoInOneSentence) {
    const Scratch scratch;
    for (const BadEval& bad :
         {BadEval{"", "marble", 3, "p.csv: has no points"},
          {"x,y,z\n", "marble", 3, "has no points"},
          {"1,2,3\n1,2\n", "marble", 3, "p.csv:2: the line has 2 columns"},
          {"1,2,3\n1,two,3\n", "marble", 3, "p.csv:2: 'two' is no number"},
          {"1,2,3\n\n1,nan,3\n", "marble", 3, "p.csv:3: 'nan' is not finite"},
          {"1,2,3\n1,1e999,3\n", "marble", 3, "p.csv:2:"},
          {"1,2,3,4,5\n", "marble", 3, "p.csv:1: 5 columns"},
          {"a,b,c\n1,2,3\n", "marble", 3, "no column is named x"},
          {"1,2\n", "marble", 1, "a recipe needs points x,y,z"},
          {"1,2,3,4\n", "--noise perlin1985", 1, "1 to 3 dimensions"},
          {"1,2\n", "--noise perlin", 1, "3 to 4 dimensions"},
          {"1,2,3\n", "--noise simplex --period 4", 1, "multiples of 3"},
          {"1,2,3\n", "--noise value --period 4,4", 1, "--period has 2 numbers"},
          {"1,2,3\n", "--noise value --period 4 --octaves 2 --lacunarity 1.5", 1, "whole"},
          {"1,2,3\n", "--noise value --period 1000000 --octaves 24", 1, "fewer octaves"},
          {"1,2,3\n", "--noise valu", 1, "valu"},
          {"1,2,3\n", "--noise value --octaves 25", 1, "octaves"},
          {"1,2,3\n", "--noise value --set name=a", 1, "--set"},
          {"1,2,3\n", "--noise value --precision fixed:8", 1, "as fixed:8.8"},
          {"1,2,3\n", "--noise value --precision fixed:8.17", 1, "as fixed:8.8"},
          {"1,2,3\n", "--noise worley --precision fixed:8.8", 1, "value and perlin"},
          {"1,2\n", "--noise value --precision fixed:8.8", 1, "3 dimensions"},
          {"1,2,3\n", "marble --set texture.input.noise.0.kind=cell --precision fixed:8.8", 1,
           "perlin"},
          {"1,2,3\n1e14,0,0\n", "--noise value", 5, "point 2: the noise reaches 1e+14"},
          {"1e8,0,0\n", "--noise perlin --octaves 24", 5, "point 1: the noise reaches 8.4e+14"},
          {"1,2,3\n", "marble --channel rougness", 1, "rougness"},
          {"1,2,3\n", "marble --channel height", 1, "the recipe has no height"},
          {"1,2,3\n", "marble --channel alpha --precision fixed:8.8", 1, "--channel"},
          {"1,2,3\n", "--noise value --channel alpha", 1, "--channel is of recipes"},
          {"1,2,3\n", "marble --noise value", 1, "either"},
          {"1,2,3\n", "", 1, "either"},
          {"1,2,3\n", "no_such_recipe", 1, "no_such_recipe"}}) {
        const std::string path = scratch.write("p.csv", bad.content);
        const Outcome outcome =
            run_burl(scratch, fmt::format("eval {} --points '{}'", bad.options, path));
        EXPECT_EQ(outcome.exit_code, bad.exit_code) << bad.options << "\n" << outcome.err;
        EXPECT_EQ(outcome.out, "");
        expect_one_sentence(outcome.err);
        EXPECT_NE(outcome.err.find(bad.says), std::string::npos) << outcome.err;
    }
    const Outcome missing = run_burl(scratch, "eval marble --points /does/not/exist.csv");
    EXPECT_EQ(missing.exit_code, 2);
    expect_one_sentence(missing.err);
}

}  // namespace
}  // namespace burl::test
