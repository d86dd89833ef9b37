// Recipes whose texture is a graph: reading, writing, --set, and every way of getting it wrong.
#include <fstream>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/base/embedded.h"
#include "app/image/image_io.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/parameters.h"
#include "app/recipe/recipe.h"
#include "atlas/base/error.h"
#include "procedural/graph/json.h"
#include "procedural/graph/table.h"
#include "tests/app/support/scratch_folder.h"
#include "tests/paths.h"
#include "tests/procedural/graph/cases.h"

namespace burl {
namespace {

using testing::HasSubstr;

/// Name of a recipe in a folder that has the image the cases name.
const std::string& origin() {
    static const ScratchFolder folder;
    static const std::string path = [] {
        write_png(folder / "image.png", case_image(""));
        return folder / "r";
    }();
    return path;
}

Recipe with_texture(const std::string& texture, const std::vector<std::string>& settings = {}) {
    return parse_recipe("{\"texture\": " + texture + "}", origin(), settings);
}

std::string wrong_graph(const std::string& texture) {
    try {
        with_texture(texture);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::invalid_file);
        return error.what();
    }
    ADD_FAILURE() << "accepted: " << texture.substr(0, 200);
    return {};
}

std::string wrong_setting(const std::string& texture, const std::string& setting) {
    try {
        with_texture(texture, {setting});
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::usage);
        return error.what();
    }
    ADD_FAILURE() << "accepted: " << setting;
    return {};
}

TEST(GraphRecipe, EveryNodeIsReadAndWrittenBack) {
    for (const GraphCase& graph : graph_cases) {
        const Recipe recipe = with_texture(std::string(graph.json));
        ASSERT_FALSE(plain_texture(recipe.texture)) << graph.node;
        EXPECT_EQ(recipe.texture, graph_of(graph.json)) << graph.node;
        EXPECT_EQ(parse_recipe(to_json(recipe), origin()), recipe) << to_json(recipe);
    }
}

TEST(GraphRecipe, DefaultsAreTheTables) {
    for (const NodeType& type : graph_table()) {
        std::string plain = fmt::format("{{\"node\": \"{}\"", type.name), full = plain;
        for (const NodeInput& input : type.inputs()) {
            const std::string value(input.fallback.empty() ? "0.25" : input.fallback);
            if (input.fallback.empty()) plain += fmt::format(", \"{}\": {}", input.key, value);
            full += fmt::format(", \"{}\": {}", input.key, value);
        }
        if (type.name == "image") plain += ", \"file\": \"image.png\"";
        for (const Parameter& parameter : type.parameters())
            full += fmt::format(
                ", \"{}\": {}", parameter.path,
                parameter.default_value.empty() ? "\"image.png\"" : parameter.default_value);
        if (type.name == "constant") plain += ", \"value\": 3", full += ", \"value\": 3";
        const Recipe recipe = with_texture(plain + "}");
        EXPECT_EQ(recipe, with_texture(full + "}")) << type.name;
    }
}

TEST(GraphRecipe, TimeIsReadWrittenAndLeftOut) {
    const Recipe timed =
        with_texture(R"({"node": "windy", "time": 2.5, "time_period": 8, "kind": "value"})");
    EXPECT_EQ(parse_recipe(to_json(timed), origin()), timed);
    EXPECT_THAT(to_json(timed), HasSubstr("\"time\": 2.5"));
    const Recipe still = with_texture(R"({"node": "windy", "kind": "value"})");
    EXPECT_THAT(to_json(still), Not(HasSubstr("\"time\":")));
    EXPECT_EQ(parse_recipe(to_json(still), origin()), still);
    EXPECT_EQ(with_texture(R"({"node": "windy", "kind": "value", "time": null})"), still);
    EXPECT_EQ(with_texture(R"({"node": "windy", "kind": "value"})",
                           {"texture.time=2.5", "texture.time_period=8"}),
              timed);
}

TEST(GraphRecipe, TheModelOf1999KeepsItsOwnForm) {
    EXPECT_TRUE(plain_texture(with_texture("{}").texture));
    EXPECT_TRUE(plain_texture(
        with_texture(R"({"node": "color_map", "input": {"node": "field"}})").texture));
    EXPECT_TRUE(plain_texture(with_texture(R"({"input": {"noise": [{}]}})").texture));
    EXPECT_FALSE(plain_texture(with_texture(R"({"input": {"node": "fbm"}})").texture));
    EXPECT_FALSE(plain_texture(with_texture(R"({"input": 0.5})").texture));
    EXPECT_FALSE(plain_texture(with_texture(R"({"node": "field"})").texture));
    for (const EmbeddedFile& file : embedded_recipes()) {
        const Recipe recipe = parse_recipe(std::string(file.content), std::string(file.name));
        EXPECT_EQ(parse_recipe(to_json(recipe), "again"), recipe) << file.name;
    }
}

TEST(GraphRecipe, WrongNodesGetOneSentenceWithTheirPath) {
    EXPECT_THAT(
        wrong_graph(R"({"node": "fbmm"})"),
        HasSubstr("texture.node is \"fbmm\", must be a node's name; did you mean \"fbm\"?"));
    EXPECT_THAT(wrong_graph(R"({"node": 3})"), HasSubstr("texture.node is 3"));
    EXPECT_THAT(wrong_graph(R"({"node": "abs", "input": {}})"),
                HasSubstr("texture.input has no key \"node\""));
    EXPECT_THAT(wrong_graph(R"({"node": "abs"})"), HasSubstr("texture.input is missing"));
    EXPECT_THAT(wrong_graph(R"({"node": "abs", "input": null})"),
                HasSubstr("texture.input is null"));
    EXPECT_THAT(wrong_graph(R"({"node": "abs", "input": [1]})"), HasSubstr("texture.input is [1]"));
    EXPECT_THAT(wrong_graph(R"({"node": "abs", "input": 1e300})"),
                HasSubstr("texture.input is 1e+300"));
    EXPECT_THAT(wrong_graph(R"({"node": "abs", "input": "red"})"),
                HasSubstr("texture.input is \"red\""));
    EXPECT_THAT(wrong_graph(R"({"node": "abs", "input": "#ff0000"})"),
                HasSubstr("texture.input gives a colour, must be a number"));
    EXPECT_THAT(wrong_graph(R"({"node": "abs", "input": {"node": "uv"}})"),
                HasSubstr("texture.input gives a colour"));
    EXPECT_THAT(
        wrong_graph(R"({"node": "abs", "input": {"node": "map_uv", "input": {"node": "mix", "a":
        "#ff0000"}}})"),
        HasSubstr("texture.input.input.a gives a colour"));
    EXPECT_THAT(wrong_graph(R"({"node": "mix", "a": {"node": "abs", "input": {"node": "sin"}}})"),
                HasSubstr("texture.a.input.input is missing"));
    EXPECT_THAT(wrong_graph(R"({"node": "fbm", "octave": 3})"),
                HasSubstr("unknown key \"octave\" in texture; did you mean \"octaves\"?"));
    EXPECT_THAT(wrong_graph(R"({"node": "fbm", "octaves": 1e9})"),
                HasSubstr("texture.octaves is 1000000000.0, must be a whole number from 1 to 24"));
    EXPECT_THAT(wrong_graph(R"({"node": "fbm", "octaves": 2.5})"),
                HasSubstr("texture.octaves is 2.5"));
    EXPECT_THAT(wrong_graph(R"({"node": "fbm", "kind": "perlim"})"), HasSubstr("\"perlin\"?"));
    EXPECT_THAT(wrong_graph(R"({"node": "fbm", "gain": NaN})"), HasSubstr("not valid JSON"));
    EXPECT_THAT(wrong_graph(R"({"node": "fbm", "gain": 1e999})"), HasSubstr("not valid JSON"));
    EXPECT_THAT(wrong_graph(R"({"node": "fbm", "time": 1, "kind": "perlin1985"})"),
                HasSubstr("texture.time is 1, but perlin1985 noise has no fourth dimension"));
    EXPECT_THAT(wrong_graph(R"({"node": "fbm", "time": 1, "time_period": 3, "kind": "simplex"})"),
                HasSubstr("texture.time is 1, but simplex noise"));
    EXPECT_THAT(wrong_graph(R"({"node": "fbm", "time": "now"})"),
                HasSubstr("texture.time is \"now\""));
    EXPECT_THAT(wrong_graph(R"({"node": "fbm", "octaves": null})"),
                HasSubstr("texture.octaves is null"));
    EXPECT_THAT(wrong_graph(R"({"node": "constant"})"), HasSubstr("texture.value is missing"));
    EXPECT_THAT(wrong_graph(R"({"node": "constant", "value": "#12345"})"),
                HasSubstr("texture.value is"));
    EXPECT_THAT(wrong_graph(R"({"node": "constant", "value": {"node": "fbm"}})"),
                HasSubstr("texture.value is an object"));
    EXPECT_THAT(wrong_graph(R"({"node": "stripes", "direction": [1, 2]})"),
                HasSubstr("texture.direction is [1,2], must be an array of 3 numbers"));
    EXPECT_THAT(wrong_graph(R"({"node": "stripes", "direction": [1, 2, "x"]})"),
                HasSubstr("texture.direction.2 is \"x\""));
    EXPECT_THAT(wrong_graph(R"({"node": "stripes", "period": 0})"),
                HasSubstr("texture.period is 0"));
}

TEST(GraphRecipe, ImagesAreReadBesideTheRecipe) {
    EXPECT_THAT(wrong_graph(R"({"node": "image"})"), HasSubstr("texture.file is missing"));
    EXPECT_THAT(wrong_graph(R"({"node": "image", "file": 3})"), HasSubstr("texture.file is 3"));
    const ScratchFolder folder;
    const auto broken = [&](const std::string& file) -> std::string {
        try {
            parse_recipe(R"({"texture": {"node": "image", "file": ")" + file + "\"}}",
                         folder / "r");
        } catch (const Error& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_THAT(broken("none.png"), HasSubstr("none.png"));
    std::ofstream(folder / "text.png") << "no image";
    EXPECT_THAT(broken("text.png"), HasSubstr("text.png"));
    write_png(folder / "long.png", Image<Rgb8>(8193, 1));
    EXPECT_THAT(broken("long.png"), HasSubstr("at most 8192"));
}

TEST(GraphRecipe, TheModelsNodesAreCheckedInside) {
    const auto map = [](const std::string& keys) {
        return wrong_graph(R"({"node": "mix", "b": {"node": "color_map", "input": 0.5, )" + keys +
                           "}}");
    };
    EXPECT_THAT(map(R"("stops": [])"), HasSubstr("texture.b.stops is empty"));
    EXPECT_THAT(map(R"("stops": [[0.5, "#000000"], [0.4, "#000000"]])"),
                HasSubstr("texture.b.stops.1.0 is 0.4"));
    EXPECT_THAT(map(R"("stops": [[0.5, "red"]])"), HasSubstr("texture.b.stops.0.1 is \"red\""));
    EXPECT_THAT(map(R"("wrap": "mirror")"), HasSubstr("texture.b.wrap is \"mirror\""));
    EXPECT_THAT(map(R"("quadric": {})"), HasSubstr("unknown key \"quadric\" in texture.b"));
    const auto field = [](const std::string& keys) {
        return wrong_graph(R"({"node": "abs", "input": {"node": "field", )" + keys + "}}");
    };
    EXPECT_THAT(field(R"("quadric": {"K": 1})"), HasSubstr("texture.input.quadric"));
    EXPECT_THAT(field(R"("noise": [{}, {"octaves": 1e9}])"),
                HasSubstr("texture.input.noise.1.octaves"));
    EXPECT_THAT(field(R"("noise": [{"kind": "simplex", "period": [4, 0, 0]}])"),
                HasSubstr("texture.input.noise.0.period"));
}

std::string nested(std::size_t depth) {
    std::string json;
    for (std::size_t i = 0; i < depth; ++i) json += R"({"node": "abs", "input": )";
    return json + "1" + std::string(depth, '}');
}

TEST(GraphRecipe, DepthAndNumberOfNodesAreLimited) {
    EXPECT_NO_THROW(with_texture(nested(max_graph_depth - 1)));
    EXPECT_THAT(wrong_graph(nested(max_graph_depth)), HasSubstr("more than 64 deep"));
    EXPECT_THAT(wrong_graph(nested(500)),
                HasSubstr("texture.input.input.input.input.inpu...ut.input.input.input: nodes are "
                          "nested more than 64 deep"));
    EXPECT_LT(wrong_graph(nested(500)).size(), 400u);
    EXPECT_THAT(wrong_graph(nested(1000000)), HasSubstr("nested more than 1000 levels deep"));
    std::string broad = "1";
    for (int i = 0; i < 10; ++i)
        broad = R"({"node": "add", "a": )" + broad + ", \"b\": " + broad + "}";
    EXPECT_THAT(wrong_graph(broad), HasSubstr("more than 1000 nodes"));
}

TEST(GraphRecipe, SettingsReachIntoTheTree) {
    const std::string base = R"({"node": "mix", "a": {"node": "fbm"}, "b": {"node": "color_map",
        "stops": [[0, "#000000"], [1, "#ffffff"]], "input": 0.5}, "amount": 0.1})";
    const auto set = [&](const std::vector<std::string>& settings) {
        return with_texture(base, settings).texture;
    };
    const auto expected = [](std::string json, const std::string& from, const std::string& to) {
        return with_texture(json.replace(json.find(from), from.size(), to)).texture;
    };
    EXPECT_EQ(set({"texture.a.octaves=3"}), expected(base, "\"fbm\"", "\"fbm\", \"octaves\": 3"));
    EXPECT_EQ(set({"texture.a.kind=value"}),
              expected(base, "\"fbm\"", "\"fbm\", \"kind\": \"value\""));
    EXPECT_EQ(set({"texture.amount=0.7"}), expected(base, "0.1", "0.7"));
    EXPECT_EQ(set({"texture.b.stops.1.1=#ff0000"}), expected(base, "#ffffff", "#ff0000"));
    EXPECT_EQ(set({R"(texture.a={"node":"windy"})"}), expected(base, "fbm", "windy"));
    EXPECT_EQ(set({"texture.b.stops.2=[1,\"#0000ff\"]"}),
              expected(base, "\"#ffffff\"]", "\"#ffffff\"], [1, \"#0000ff\"]"));
    EXPECT_THAT(wrong_setting(base, "texture.a.octavs=3"), HasSubstr("did you mean \"octaves\"?"));
    EXPECT_THAT(wrong_setting(base, "texture.a.octaves=99"),
                HasSubstr("--set texture.a.octaves=99: texture.a.octaves is 99"));
    EXPECT_THAT(wrong_setting(base, "texture.a.b.c=1"), HasSubstr("unknown key \"b\""));
    EXPECT_THAT(wrong_setting(base, "texture.b.stops.7=1"), HasSubstr("the next index is 2"));
    // A model of 1999 becomes a graph when a node takes the place of its input.
    EXPECT_FALSE(plain_texture(with_texture("{}", {R"(texture.input={"node":"windy"})"}).texture));
}

/// Rows of a section's table as sets of cells.
std::set<std::vector<std::string>> table_rows(const std::string& heading) {
    std::ifstream file(test::source_folder() + "/docs/reference/nodes.md");
    std::stringstream text;
    text << file.rdbuf();
    const std::string all = text.str();
    const std::size_t begin = all.find("## " + heading + "\n");
    std::istringstream lines(all.substr(begin, all.find("\n## ", begin + 1) - begin));
    std::set<std::vector<std::string>> rows;
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("| `")) continue;
        std::vector<std::string> cells;
        for (std::size_t at = 1; at < line.size();) {
            std::size_t end = line.find(" |", at);
            cells.push_back(line.substr(at + 1, end - at - 1));
            at = end + 2;
        }
        rows.insert(cells);
    }
    return rows;
}

std::string quoted(std::string_view text) {
    return text.empty() ? "required" : fmt::format("`{}`", text);
}

TEST(NodePage, NamesEveryNodeAsTheTableDoes) {
    const char* gives[] = {"number", "colour", "as a and b", "as input"};
    std::set<std::vector<std::string>> expected;
    for (const NodeType& type : graph_table())
        expected.insert({quoted(type.name), gives[int(type.result)], std::string(type.text),
                         std::string(type.source)});
    EXPECT_EQ(table_rows("Nodes"), expected);
}

TEST(NodePage, NamesEveryInputAndParameterAsTheTableDoes) {
    std::set<std::vector<std::string>> expected;
    for (const NodeType& type : graph_table()) {
        for (const NodeInput& input : type.inputs())
            expected.insert({fmt::format("`{}.{}`", type.name, input.key),
                             input.wire == Wire::number ? "number node" : "node",
                             quoted(input.fallback), "", std::string(input.tip)});
        for (const Parameter& p : type.parameters()) {
            std::string range = fmt::format("{} to {}", p.low, p.high);
            if (p.type == ParameterType::text) range = "any";
            if (p.type == ParameterType::choice) {
                range.clear();
                for (const std::string_view word : split_choices(p.choices))
                    range += fmt::format("{}`{}`", range.empty() ? "" : ", ", word);
            }
            expected.insert({fmt::format("`{}.{}`", type.name, p.path),
                             std::string(to_string(p.type)), quoted(p.default_value), range,
                             std::string(p.tip)});
        }
    }
    EXPECT_EQ(table_rows("Inputs and parameters"), expected);
}

}  // namespace
}  // namespace burl
