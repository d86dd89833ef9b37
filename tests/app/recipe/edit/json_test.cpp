#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/base/embedded.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/recipe.h"
#include "atlas/base/error.h"
#include "tests/paths.h"

namespace burl {
namespace {

using testing::HasSubstr;

/// The message of the Error that `call` throws, after checking its code.
template <class Call>
std::string message_of(ExitCode code, Call&& call) {
    try {
        call();
    } catch (const Error& error) {
        EXPECT_EQ(int(error.code()), int(code)) << error.what();
        return error.what();
    }
    ADD_FAILURE() << "nothing was thrown";
    return {};
}

std::string invalid(const std::string& json) {
    return message_of(ExitCode::invalid_file, [&] { parse_recipe(json, "r.json"); });
}

std::string recipe_json_wrong_setting(const std::string& setting, const std::string& json = "{}") {
    return message_of(ExitCode::usage, [&] { parse_recipe(json, "r.json", {setting}); });
}

Recipe with(const std::vector<std::string>& settings, const std::string& json = "{}") {
    return parse_recipe(json, "r.json", settings);
}

TEST(Recipe, EverythingIsOptional) {
    const Recipe recipe = parse_recipe("{}", "r.json");
    Recipe expected;
    plain_texture(expected.texture)->colors.stops = {{0.0, {0, 0, 0}}, {1.0, {255, 255, 255}}};
    EXPECT_EQ(recipe, expected);
    EXPECT_EQ(plain_texture(parse_recipe(R"({"texture": {"input": {"noise": [{}]}}})", "r").texture)
                  ->noise,
              std::vector<NoiseTerm>(1));
}

TEST(Recipe, ReadsEveryKey) {
    const Recipe recipe = parse_recipe(R"({"burl": 1, "name": "n",
        "atlas": {"kind": "length", "size": 333, "overscan": "nearest",
                  "weight": "area", "partition": "graph", "gutter": 3, "diagonals": "overscan"},
        "solid": {"space": "object", "scale": 0.25},
        "texture": {"node": "color_map", "wrap": "clamp", "stops": [[0.25, "#102030"], [1, "#FFfe00"]],
          "input": {"node": "field",
            "quadric": {"A": 1, "B": 2, "C": 3, "D": 4, "E": 5, "F": 6, "G": 7, "H": 8, "I": 9, "J": 10},
            "noise": [{"kind": "perlin", "fade": "quintic", "range": "signed", "amplitude": 0.5,
                       "frequency": [1, 2, 3], "phase": [4, 5, 6], "seed": 4294967295,
                       "octaves": 24, "lacunarity": 1.5, "gain": 0.75},
                      {"matrix": [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12], "range": "unit"}]}},
        "filter": {"kind": "supersample", "samples": 9, "octaves": "fade"}})",
                                       "r.json");
    Recipe expected;
    expected.name = "n";
    expected.atlas = {AtlasKind::length,  Overscan::nearest,     333,
                      AtlasWeight::area,  AtlasPartition::graph, 3,
                      Diagonals::overscan};
    expected.solid = {SolidSpace::object, 0.25};
    Texture& texture = *plain_texture(expected.texture);
    texture.colors = {Wrap::clamp, {{0.25, {16, 32, 48}}, {1.0, {255, 254, 0}}}};
    texture.quadric = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
    NoiseTerm first;
    first.kind = NoiseKind::perlin, first.fade = Fade::quintic;
    first.range = NoiseRange::bipolar, first.amplitude = 0.5;
    first.frequency = {1, 2, 3}, first.phase = {4, 5, 6}, first.seed = 4294967295u;
    first.octaves = 24, first.lacunarity = 1.5, first.gain = 0.75;
    NoiseTerm second;
    second.matrix = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
    second.range = NoiseRange::unit;
    texture.noise = {first, second};
    expected.filter = {FilterKind::supersample, 9, true};
    EXPECT_EQ(recipe, expected);
}

Recipe random_recipe(std::mt19937& random) {
    std::uniform_real_distribution<double> number(-100.0, 100.0), unit(0.0, 1.0);
    const auto vector = [&] { return Vec3d{number(random), number(random), number(random)}; };
    Recipe recipe;
    recipe.name = random() % 2 ? "a \"quoted\" name\n\xc3\xa9" : "";
    recipe.atlas = {AtlasKind(random() % 4), Overscan(random() % 2),
                    1 + std::uint32_t(random() % 16384), AtlasWeight(random() % 4)};
    recipe.solid = {SolidSpace(random() % 2), 1e-3 + unit(random)};
    recipe.filter = {FilterKind(random() % 8), 1 + int(random() % 1024), random() % 2 == 0};
    Texture& texture = *plain_texture(recipe.texture);
    if (random() % 2) texture.quadric.f = number(random);
    if (random() % 2) texture.quadric.j = number(random);
    texture.colors.wrap = Wrap(random() % 2);
    double position = 0.0;
    do {
        texture.colors.stops.push_back(
            {position, {std::uint8_t(random()), std::uint8_t(random()), std::uint8_t(random())}});
        position = std::min(1.0, position + 0.3 * unit(random));
    } while (random() % 4);
    for (auto count = random() % 4; count > 0; --count) {
        NoiseTerm& term = texture.noise.emplace_back();
        term.kind = NoiseKind(random() % 8), term.fade = Fade(random() % 3);
        term.feature = WorleyFeature(random() % 3), term.shape = OctaveShape(random() % 3);
        term.radius2 = random() % 2 ? 0.6 : 0.5, term.normalized = random() % 2;
        if (random() % 2) term.range = NoiseRange(random() % 2);
        term.amplitude = number(random), term.seed = std::uint32_t(random());
        if (random() % 2) term.frequency = vector();
        if (random() % 2) term.phase = vector();
        if (random() % 3 == 0) {
            term.matrix.emplace();
            for (double& m : *term.matrix) m = number(random);
        }
        term.octaves = 1 + std::uint32_t(random() % 24);
        term.lacunarity = 0.5 + unit(random), term.gain = 2.0 * unit(random);
        if (random() % 3 == 0) {
            term.period = {3u * std::uint32_t(random() % 9), 0, 6};
            term.lacunarity = 2.0;
        }
    }
    return recipe;
}

TEST(Recipe, SurvivesJsonThereAndBack) {
    std::mt19937 random(1);
    for (int i = 0; i < 300; ++i) {
        const Recipe recipe = random_recipe(random);
        const std::string json = to_json(recipe);
        ASSERT_EQ(parse_recipe(json, "r.json"), recipe) << json;
    }
    for (const EmbeddedFile& file : embedded_recipes()) {
        const Recipe recipe = parse_recipe(std::string(file.content), std::string(file.name));
        EXPECT_EQ(parse_recipe(to_json(recipe), "again"), recipe) << file.name;
    }
}

TEST(Recipe, PeriodsMustFitTheLattice) {
    const auto wrong = [](const std::string& term) -> std::string {
        try {
            parse_recipe(R"({"texture": {"input": {"noise": [)" + term + "]}}}", "r.json");
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::invalid_file);
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(wrong(R"({"period": [4, 0, 3], "octaves": 8})"), "");
    EXPECT_EQ(wrong(R"({"kind": "simplex", "period": [3, 0, 6]})"), "");
    EXPECT_THAT(wrong(R"({"period": [4, 0.5, 3]})"),
                HasSubstr("noise.0.period is [4,0.5,3], must be whole"));
    EXPECT_THAT(wrong(R"({"period": [4, 0, 3], "lacunarity": 1.9})"),
                HasSubstr("whole lacunarity"));
    EXPECT_THAT(wrong(R"({"kind": "simplex", "period": [4, 0, 3]})"), HasSubstr("multiples of 3"));
    EXPECT_THAT(wrong(R"({"period": [1000000, 0, 3], "octaves": 24})"), HasSubstr("fewer octaves"));
}

TEST(Recipe, SyntaxErrorsNameTheLine) {
    EXPECT_THAT(invalid("{\n  \"name\": \"x\",\n  \"atlas\": {]\n}"), HasSubstr("r.json:3: "));
    EXPECT_THAT(invalid("{\"solid\": {\n\"scale\": 1e999}}"), HasSubstr("r.json:2: "));
    EXPECT_THAT(invalid(""), HasSubstr("r.json:1: "));
    EXPECT_THAT(invalid("{\n\"name\": NaN}"), HasSubstr("r.json:2: "));
    EXPECT_THAT(invalid("{\"name\": \"a\", \"name\": \"b\"}"),
                HasSubstr("\"name\" is given twice"));
    EXPECT_THAT(invalid(std::string(900, '[')), HasSubstr("not valid JSON"));
}

TEST(Recipe, UnknownKeysAreNamedWithTheNearest) {
    const std::string typo = invalid(R"({"texture": {"input": {"noise": [{}, {"amplitud": 1}]}}})");
    EXPECT_THAT(typo, HasSubstr("unknown key \"amplitud\" in texture.input.noise.1"));
    EXPECT_THAT(typo, HasSubstr("\"amplitude\""));
    EXPECT_THAT(invalid(R"({"textures": {}})"), HasSubstr("did you mean \"texture\"?"));
    EXPECT_THAT(invalid(R"({"texture": {"input": {"quadric": {"K": 1}}}})"), HasSubstr("\"K\""));
    const std::string node = invalid(R"({"texture": {"node": "worley", "cells": 3}})");
    EXPECT_THAT(node, HasSubstr("texture.node is \"worley\""));
    EXPECT_THAT(node, HasSubstr("must be a node's name"));
}

TEST(Recipe, WrongTypesAndRangesSayPathValueAndRange) {
    const auto noise = [](const std::string& keys) {
        return invalid("{\"texture\": {\"input\": {\"noise\": [{" + keys + "}]}}}");
    };
    EXPECT_THAT(noise(R"("gain": 2.5)"),
                HasSubstr("texture.input.noise.0.gain is 2.5, must be a number from 0 to 2"));
    EXPECT_THAT(noise(R"("octaves": 0)"), HasSubstr("octaves is 0, must be a whole number from 1"));
    EXPECT_THAT(noise(R"("octaves": 2.5)"), HasSubstr("octaves is 2.5"));
    EXPECT_THAT(noise(R"("octaves": 25)"), HasSubstr("to 24"));
    EXPECT_THAT(noise(R"("seed": -1)"), HasSubstr("seed is -1"));
    EXPECT_THAT(noise(R"("seed": 4294967296)"), HasSubstr("to 4294967295"));
    EXPECT_THAT(noise(R"("gain": "0.5")"), HasSubstr("gain is \"0.5\", must be a number"));
    EXPECT_THAT(noise(R"("gain": null)"), HasSubstr("gain is null"));
    EXPECT_THAT(noise(R"("frequency": [1, 2])"), HasSubstr("an array of 3 numbers"));
    EXPECT_THAT(noise(R"("frequency": [1, 2, "x"])"), HasSubstr("frequency.2 is \"x\""));
    EXPECT_THAT(noise(R"("matrix": 3)"), HasSubstr("an array of 12 numbers"));
    EXPECT_THAT(noise(R"("fade": "smoth")"), HasSubstr("did you mean \"smooth\"?"));
    EXPECT_THAT(invalid(R"({"burl": 2})"), HasSubstr("burl is 2"));
    EXPECT_THAT(invalid(R"({"atlas": {"size": 0}})"), HasSubstr("atlas.size is 0"));
    EXPECT_THAT(invalid(R"({"atlas": {"size": 100000}})"), HasSubstr("to 16384"));
    EXPECT_THAT(invalid(R"({"solid": {"scale": 0}})"), HasSubstr("solid.scale is 0"));
    EXPECT_THAT(invalid(R"({"texture": []})"), HasSubstr("texture is [], must be an object"));
    EXPECT_THAT(invalid("[1]"), HasSubstr("the recipe is [1], must be an object"));
    EXPECT_THAT(invalid(std::string(999, '[') + std::string(999, ']')),
                HasSubstr("must be an object"));
    EXPECT_THAT(invalid(std::string(1000000, '[') + std::string(1000000, ']')),
                HasSubstr("nested more than 1000 levels deep"));
}

TEST(Recipe, ColourStopsAreChecked) {
    const auto stops = [](const std::string& json) {
        return invalid("{\"texture\": {\"stops\": " + json + "}}");
    };
    EXPECT_THAT(stops("[]"), HasSubstr("at least one stop"));
    EXPECT_THAT(stops("{}"), HasSubstr("texture.stops is an object, must be an array"));
    EXPECT_THAT(stops(R"([[0, "#000000", 1]])"), HasSubstr("texture.stops.0 is"));
    EXPECT_THAT(stops(R"([[0, "red"]])"), HasSubstr("texture.stops.0.1 is \"red\""));
    EXPECT_THAT(stops(R"([[0, "#00000g"]])"),
                HasSubstr("texture.stops.0.1 is \"#00000g\", must be an sRGB colour \"#rrggbb\" or "
                          "\"#rrggbbaa\""));
    EXPECT_THAT(stops(R"([[0, "#0000000"]])"), HasSubstr("texture.stops.0.1 is"));
    EXPECT_THAT(stops(R"([[1.5, "#000000"]])"), HasSubstr("texture.stops.0.0 is 1.5"));
    EXPECT_THAT(stops(R"([[0.5, "#000000"], [0.4, "#000000"]])"),
                HasSubstr("texture.stops.1.0 is 0.4, must not be below"));
}

TEST(Recipe, StopsMayBeTransparent) {
    const char* json = R"({"texture": {"stops": [[0, "#10203000"], [1, "#ffffff"]]}})";
    const Recipe recipe = parse_recipe(json, "test");
    EXPECT_EQ(plain_texture(recipe.texture), nullptr);
    EXPECT_EQ(recipe.texture.textures.at(0).colors.stops,
              (std::vector<ColorStop>{{0.0, {16, 32, 48}, 0}, {1.0, {255, 255, 255}, 255}}));
    EXPECT_EQ(parse_recipe(to_json(recipe), "again"), recipe);
    const Recipe set = with({"texture.stops.1.1=#ffffff80"}, json);
    EXPECT_EQ(set.texture.textures.at(0).colors.stops[1].alpha, 128);
    EXPECT_THAT(invalid(R"({"material": {"emissive": "#ffffff80"}})"),
                HasSubstr("must be an sRGB colour \"#rrggbb\""));
    EXPECT_THAT(invalid(R"({"precision": {"kind": "fixed"}, "texture": {"stops":
                        [[0, "#10203000"], [1, "#ffffff"]]}})"),
                HasSubstr("a stop of texture.stops is transparent"));
}

TEST(Settings, EditNumbersWordsAndWholeParts) {
    const Recipe recipe =
        with({"texture.input.noise.0.amplitude=0.7", "texture.wrap=clamp", "atlas.size=2048",
              "name=12", "texture.input.quadric={\"A\": 3}", "texture.stops=[[0, \"#010203\"]]"},
             R"({"texture": {"input": {"noise": [{"amplitude": 0.1}]}}})");
    const Texture& texture = *plain_texture(recipe.texture);
    EXPECT_EQ(texture.noise.at(0).amplitude, 0.7);
    EXPECT_EQ(texture.colors.wrap, Wrap::clamp);
    EXPECT_EQ(recipe.atlas.size, 2048u);
    EXPECT_EQ(recipe.name, "12");
    EXPECT_EQ(texture.quadric, Quadric{3});
    EXPECT_EQ(texture.colors.stops, (std::vector<ColorStop>{{0.0, {1, 2, 3}}}));
}

TEST(Settings, MakeWhatIsMissing) {
    const Recipe recipe =
        with({"texture.input.noise.0.gain=0.25", "texture.input.noise.1.kind=perlin",
              "texture.input.noise.1.frequency.2=5", "texture.stops.0=[0.5, \"#ffffff\"]",
              "texture.stops.0.1=#000010", "texture.input.quadric.J=-1"});
    const Texture& texture = *plain_texture(recipe.texture);
    ASSERT_EQ(texture.noise.size(), 2u);
    EXPECT_EQ(texture.noise[0].gain, 0.25);
    EXPECT_EQ(texture.noise[1].kind, NoiseKind::perlin);
    EXPECT_EQ(texture.noise[1].frequency, Vec3d(1, 1, 5));
    EXPECT_EQ(texture.colors.stops, (std::vector<ColorStop>{{0.5, {0, 0, 16}}}));
    EXPECT_EQ(texture.quadric.j, -1.0);
}

TEST(Settings, MayPassThroughAnInvalidRecipe) {
    const Recipe recipe = with({"texture.stops.0.0=0.8", "texture.stops.1.0=0.9"},
                               R"({"texture": {"stops": [[0.1, "#000000"], [0.2, "#ffffff"]]}})");
    EXPECT_EQ(plain_texture(recipe.texture)->colors.stops[0].position, 0.8);
}

TEST(Settings, WrongPathsAreUsageErrorsWithTheNearest) {
    EXPECT_THAT(recipe_json_wrong_setting("texture.input.noise.0.amplitud=1"),
                HasSubstr("did you mean \"texture.input.noise.0.amplitude\"?"));
    EXPECT_THAT(recipe_json_wrong_setting("gain=1"), HasSubstr("\"texture.input.noise.0.gain\""));
    EXPECT_THAT(recipe_json_wrong_setting("atlas.sise=1"), HasSubstr("\"atlas.size\""));
    EXPECT_THAT(recipe_json_wrong_setting("texture.input.noise.*.gain=1"),
                HasSubstr("no parameter"));
    EXPECT_THAT(recipe_json_wrong_setting("atlas.size.0=1"), HasSubstr("no parameter"));
    EXPECT_THAT(recipe_json_wrong_setting("=1"), HasSubstr("path=value"));
    EXPECT_THAT(recipe_json_wrong_setting("atlas.size"), HasSubstr("path=value"));
    EXPECT_THAT(recipe_json_wrong_setting("texture.input.noise.1.gain=1"),
                HasSubstr("the next index is 0"));
    EXPECT_THAT(recipe_json_wrong_setting("texture.input.noise.0.frequency.3=1"),
                HasSubstr("0 to 2"));
    EXPECT_THAT(recipe_json_wrong_setting("texture.input.noise.0.matrix.3=1"), HasSubstr("all 12"));
}

TEST(Settings, WrongValuesAreUsageErrorsThatNameTheSetting) {
    const std::string message = recipe_json_wrong_setting("texture.input.noise.0.gain=7");
    EXPECT_THAT(message, HasSubstr("--set texture.input.noise.0.gain=7: "));
    EXPECT_THAT(message, HasSubstr("from 0 to 2"));
    EXPECT_THAT(recipe_json_wrong_setting("atlas.size=big"), HasSubstr("atlas.size is \"big\""));
    EXPECT_THAT(recipe_json_wrong_setting("texture.wrap=mirror"),
                HasSubstr("\"repeat\", \"clamp\""));
    EXPECT_THAT(recipe_json_wrong_setting("name=\xff\xfe"), HasSubstr("UTF-8"));
}

TEST(Presets, AreFoundByName) {
    EXPECT_EQ(load_recipe("marble").name, "marble");
    EXPECT_EQ(load_recipe("marble", {"atlas.size=64"}).atlas.size, 64u);
    EXPECT_EQ(load_recipe(test::source_folder() + "/assets/recipes/papers/wood.json"),
              load_recipe("wood"));
    EXPECT_THAT(message_of(ExitCode::usage, [] { load_recipe("mrable"); }),
                HasSubstr("did you mean \"marble\"?"));
    EXPECT_THAT(message_of(ExitCode::io, [] { load_recipe("no/such/file.json"); }),
                HasSubstr("no/such/file.json"));
    EXPECT_THAT(message_of(ExitCode::io, [] { load_recipe(test::source_folder() + "/assets"); }),
                HasSubstr("assets"));
}

TEST(Presets, FollowThePapersEquations) {
    const auto noise = [](std::uint32_t seed, const Vec3d& p) {
        Texture one;
        one.noise.emplace_back().seed = seed;
        return evaluate_field(one, p);
    };
    const auto sum = [&](const Vec3d& p) {
        double total = 0.0;
        for (std::uint32_t i = 1; i <= 4; ++i)
            total += std::pow(0.5, i) * noise(i - 1, std::pow(2.0, i) * p);
        return total;
    };
    const Vec3d p(0.37, -1.21, 2.9);
    const double s = p.x, t = p.y, r = p.z;
    const auto preset = [&p](const char* name) {
        return evaluate_field(*plain_texture(load_recipe(name).texture), p);
    };
    EXPECT_NEAR(preset("wood"), s * s + t * t + noise(0, {4 * s, 4 * t, r}), 1e-14);
    EXPECT_NEAR(preset("clouds"), sum(p), 1e-14);
    EXPECT_NEAR(preset("marble"), r + sum(p), 1e-14);
    EXPECT_NEAR(preset("fire"), r + sum({s, 0, r}), 1e-14);
    // "Bresenham Noise", (23), and (24) with amplitudes 2^-i: linear fades.
    const auto linear = [&](std::uint32_t seed, const Vec3d& at) {
        Texture one;
        one.noise.emplace_back().seed = seed;
        one.noise[0].fade = Fade::linear;
        return evaluate_field(one, at);
    };
    EXPECT_NEAR(preset("bresenham-wood"), 10 * s * s + 10 * r * r + linear(0, {5 * s, 5 * t, r}),
                1e-13);
    double marble = r;
    for (std::uint32_t i = 0; i < 4; ++i)
        marble += std::pow(0.5, i) * linear(i, std::pow(2.0, i) * p);
    EXPECT_NEAR(preset("bresenham-marble"), marble, 1e-14);
    EXPECT_NEAR(preset("zoneplate"), 50 * s * s + 50 * t * t, 1e-12);
    EXPECT_EQ(plain_texture(load_recipe("planet").texture)->colors.wrap, Wrap::clamp);
}

TEST(Recipe, MapsTheMeshToTextureCoordinates) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    Recipe recipe;
    recipe.solid.scale = 4.0;
    EXPECT_EQ(texture_from_mesh(recipe, mesh)({2, 0.5, 0}), Vec3d(2, 0, 0));
    recipe.solid.space = SolidSpace::object;
    EXPECT_EQ(texture_from_mesh(recipe, mesh)({2, 0.5, 0}), Vec3d(8, 2, 0));
}

TEST(Recipe, PaintComesBackFromItsJson) {
    const Recipe recipe = parse_recipe(R"({"paint": [
        {"color": "#c02010", "radius": 0.25, "hardness": 0.75, "opacity": 0.5,
         "points": [[0.1, 2, -3], [1e-7, 5, 6]]},
        {"mode": "erase"}]})",
                                       "r.json");
    ASSERT_EQ(recipe.paint.size(), 2u);
    PaintStroke expected;
    expected.points = {{0.1, 2, -3}, {1e-7, 5, 6}};
    expected.radius = 0.25, expected.hardness = 0.75, expected.opacity = 0.5;
    expected.color = {0xc0, 0x20, 0x10};
    EXPECT_EQ(recipe.paint[0], expected);
    expected = {};
    expected.mode = PaintMode::erase;
    EXPECT_EQ(recipe.paint[1], expected);
    EXPECT_EQ(parse_recipe(to_json(recipe), "r.json"), recipe);
    EXPECT_EQ(to_json(Recipe{}).find("paint"), std::string::npos);
    EXPECT_EQ(with({"paint.0.points=[[1,2,3]]", "paint.0.points.1=[4,5,6]"}).paint[0].points,
              (std::vector<Vec3d>{{1, 2, 3}, {4, 5, 6}}));
}

TEST(Recipe, SaysWhatIsWrongWithPaint) {
    EXPECT_THAT(invalid(R"({"paint": {"radius": 1}})"), HasSubstr("paint is an object"));
    EXPECT_THAT(invalid(R"({"paint": [{"raduis": 1}]})"), HasSubstr("did you mean \"radius\"?"));
    EXPECT_THAT(invalid(R"({"paint": [{"points": [[1, 2]]}]})"),
                HasSubstr("paint.0.points.0 is [1,2], must be an array of 3 numbers"));
    EXPECT_THAT(invalid(R"({"paint": [{"radius": 0}]})"), HasSubstr("paint.0.radius is 0"));
}

}  // namespace
}  // namespace burl
