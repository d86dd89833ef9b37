#include "app/recipe/parameters.h"
#include "app/recipe/edit/recipe_json.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/base/embedded.h"
#include "app/base/json_text.h"
#include "app/recipe/recipe.h"
#include "atlas/base/json.h"
#include "atlas/solid/atlas.h"
#include "procedural/noise/names.h"
#include "tests/paths.h"

namespace burl {
namespace {

std::string documentation() {
    std::ifstream file(test::source_folder() + "/docs/reference/recipes.md");
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

/// A row of the reference: | `path` | type | default | range | ...
struct Row {
    std::string path, type, default_value, range;
    bool operator<(const Row& other) const { return path < other.path; }
};

/// Cell `column` (from 1) of a table's line, without the spaces around it.
std::string cell(const std::string& line, int column) {
    std::size_t begin = 0;
    for (; column > 0; --column) begin = line.find('|', begin) + 1;
    const std::size_t end = line.find('|', begin);
    return line.substr(begin + 1, end - begin - 2);
}

std::set<Row> documented_rows() {
    const std::string all = documentation();
    const std::size_t begin = all.find("## Keys"), end = all.find("\n## ", begin);
    std::istringstream lines(all.substr(begin, end - begin));
    std::set<Row> rows;
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("| `")) continue;
        const std::string path = cell(line, 1);
        rows.insert({path.substr(1, path.size() - 2), cell(line, 2), cell(line, 3), cell(line, 4)});
    }
    return rows;
}

/// The path with index 0 for every "*".
std::string first_path(const Parameter& parameter) {
    std::string path(parameter.path);
    std::replace(path.begin(), path.end(), '*', '0');
    return path;
}

/// The line that documentation() should have.
std::string line_of(const Parameter& p) {
    std::string range = "any";
    if (p.low < p.high) range = fmt::format("{} to {}", p.low, p.high);
    if (!p.choices.empty())
        range = fmt::format("`{}`", fmt::join(split_choices(p.choices), "`, `"));
    if (p.type == ParameterType::color) range = p.alpha ? "`#rrggbb`, `#rrggbbaa`" : "`#rrggbb`";
    return fmt::format("| `{}` | {} | {} | {} | {}{} |", p.path, to_string(p.type),
                       p.default_value.empty() ? "-" : fmt::format("`{}`", p.default_value), range,
                       p.tip, p.unit.empty() ? "" : fmt::format(" ({})", p.unit));
}

TEST(Parameters, AreAllDocumentedAndNothingElse) {
    std::set<std::string> documented, known;
    for (const Row& row : documented_rows()) documented.insert(row.path);
    for (const Parameter& parameter : parameters()) known.insert(std::string(parameter.path));
    EXPECT_EQ(documented, known);
}

TEST(Parameters, AreDocumentedWithTypeDefaultAndRange) {
    const std::set<Row> rows = documented_rows();
    for (const Parameter& parameter : parameters()) {
        const auto row = rows.find({std::string(parameter.path), "", "", ""});
        ASSERT_NE(row, rows.end()) << "docs/reference/recipes.md lacks\n" << line_of(parameter);
        EXPECT_EQ(row->type, to_string(parameter.type)) << parameter.path;
        const std::string quoted = fmt::format("`{}`", parameter.default_value);
        EXPECT_EQ(row->default_value, parameter.default_value.empty() ? "-" : quoted)
            << parameter.path;
        for (const std::string_view word : split_choices(parameter.choices))
            EXPECT_NE(row->range.find(fmt::format("`{}`", word)), std::string::npos)
                << parameter.path << " " << word;
        if (parameter.low < parameter.high) {
            EXPECT_EQ(row->range, fmt::format("{} to {}", parameter.low, parameter.high))
                << parameter.path;
        }
    }
}

/// A recipe in which every parameter has a place at index 0 of its arrays.
const std::string base =
    R"({"texture": {"stops": [[0, "#000000"]], "input": {"noise": [{}]}}, "bump": {"input": 0}, "paint": [{}],
        "animation": {"tracks": [{"path": "texture.input.quadric.A", "keys": [[0, 1]]}]},
        "controls": [{"name": "a", "range": [-1e9, 1e9], "sets": ["texture.input.quadric.C"]}]})";

TEST(Parameters, AgreeWithTheRecipeTheyDescribe) {
    // Setting a parameter to its own default changes nothing.
    const Recipe plain = parse_recipe(base, "base");
    for (const Parameter& parameter : parameters()) {
        if (parameter.default_value.empty()) continue;
        const std::string path = first_path(parameter);
        EXPECT_EQ(parse_recipe(base, "base", {path + "=" + std::string(parameter.default_value)}),
                  plain)
            << path;
        EXPECT_FALSE(parameter.tip.empty()) << path;
    }
}

TEST(Parameters, AcceptTheirLimitsAndNothingBeyond) {
    for (const Parameter& parameter : parameters()) {
        if (parameter.low >= parameter.high || parameter.type == ParameterType::numbers) continue;
        const std::string path = first_path(parameter);
        const auto set = [&](double value) {
            return parse_recipe(base, "base", {fmt::format("{}={}", path, value)});
        };
        EXPECT_NO_THROW(set(parameter.low)) << path;
        EXPECT_NO_THROW(set(parameter.high)) << path;
        EXPECT_ANY_THROW(set(parameter.low - 1.0)) << path;
        EXPECT_ANY_THROW(set(parameter.high + 1.0)) << path;
    }
}

/// JSON of a value one step from the default, or from the number in its range that is nearest to 0;
/// null for a parameter with a single value.
Json other_value(const Parameter& p) {
    const Json otherwise = p.default_value.empty() ? Json() : Json::parse(p.default_value);
    const auto stepped = [&p](const Json& from) {
        const double x = from.is_number() ? from.get<double>() : std::clamp(0.0, p.low, p.high);
        return x + (x + p.step <= p.high ? p.step : -p.step);
    };
    switch (p.type) {
        case ParameterType::number:
        case ParameterType::integer:
            return p.low == p.high ? Json() : Json(stepped(otherwise));
        case ParameterType::numbers: {
            Json all = Json::array();
            for (std::size_t i = 0; i < p.count; ++i)
                all.push_back(stepped(otherwise.is_null() ? Json() : otherwise[i]));
            return all;
        }
        case ParameterType::text:
            return "texture.input.quadric.B";
        case ParameterType::color:
            return "#123456";
        case ParameterType::choice:
            break;
    }
    for (const std::string_view word : split_choices(p.choices))
        if (word != otherwise) return word;
    return {};
}

TEST(Parameters, AreFoundBackInTheRecipeAndInItsJson) {
    const Recipe plain = parse_recipe(base, "base");
    for (const Parameter& parameter : parameters()) {
        const Json value = other_value(parameter);
        const std::string path = first_path(parameter);
        // A control has no value that its other keys leave free; controls_test.cpp has its own.
        if (value.is_null() || path.starts_with("controls")) continue;
        const std::string setting = fmt::format("{}={}", path, value.dump());
        const Recipe set = parse_recipe(base, "base", {setting});
        EXPECT_NE(set, plain) << setting;
        EXPECT_EQ(parse_recipe(to_json(set), "set"), set) << setting;
        std::string pointer = "/" + path;
        std::ranges::replace(pointer, '.', '/');
        EXPECT_EQ(Json::parse(to_json(set)).at(Json::json_pointer(pointer)), value) << setting;
        if (path.starts_with("paint") || path.starts_with("animation")) continue;
        EXPECT_EQ(with_numbers(plain, {setting}), set) << setting;
    }
}

TEST(Parameters, AllowTheAtlasSizesTheLayoutDoes) {
    for (const Parameter& parameter : parameters()) {
        if (parameter.path != "atlas.size") continue;
        EXPECT_EQ(parameter.low, 1.0);
        EXPECT_EQ(parameter.high, max_atlas_size);
    }
}

/// Whoever copies it should see no lines between triangles, whatever viewer opens the file.
TEST(DocumentedRecipes, BeginWithAnAtlasForAnyViewer) {
    const std::string all = documentation(), fence = "```";
    const std::size_t begin = all.find('\n', all.find(fence + "json")) + 1;
    const std::string first = all.substr(begin, all.find(fence, begin) - begin);
    const Recipe recipe = parse_recipe(first, "docs/reference/recipes.md");
    EXPECT_EQ(recipe.name, "my marble");
    EXPECT_EQ(recipe.atlas, AtlasOptions{});
}

TEST(DocumentedRecipes, TheMaterialAndItsControlsAreOneRecipe) {
    const std::string all = documentation();
    const auto example = [&](const char* front) {
        const std::size_t begin = all.find(front);
        return all.substr(begin, all.find("```", begin) - begin);
    };
    const std::string material = example("\"define\": {"), controls = example("\"controls\": [");
    const Recipe recipe = parse_recipe("{" + material + "," + controls + "}", "recipes.md",
                                       {"ring spacing=0.2", "light wood=#ffeecc", "size=2"});
    EXPECT_EQ(recipe.controls.size(), 3u);
    EXPECT_EQ(recipe.solid.scale, 2.0);
    EXPECT_EQ(recipe.bump.height, 0.0003);
    EXPECT_EQ(recipe.texture.channels.size(), 1u);
}

TEST(Presets, AreAllDocumented) {
    const std::string all = documentation();
    const std::string text = all.substr(all.find("## Presets"));
    const std::filesystem::directory_iterator files(test::source_folder() +
                                                    "/assets/recipes/papers");
    EXPECT_EQ(std::distance(begin(files), end(files)), std::ssize(embedded_recipes()));
    for (const EmbeddedFile& file : embedded_recipes()) {
        const std::string_view name = file.name.substr(0, file.name.find('.'));
        EXPECT_NE(text.find(fmt::format("\n| `{}` |", name)), std::string::npos) << name;
    }
}

template <class Enum>
void expect_words_lead_back() {
    for (std::size_t k = 0; k < enum_names<Enum>.size(); ++k) {
        EXPECT_EQ(enum_named<Enum>(to_string(Enum(k))), Enum(k)) << to_string(Enum(k));
        EXPECT_FALSE(to_string(Enum(k)).empty());
    }
    EXPECT_EQ(enum_named<Enum>(""), std::nullopt);
}

TEST(EnumNames, LeadBackToTheirEnumerators) {
    expect_words_lead_back<AtlasKind>();
    expect_words_lead_back<FilterKind>();
    expect_words_lead_back<NoiseKind>();
    expect_words_lead_back<WorleyFeature>();
    expect_words_lead_back<OctaveShape>();
    EXPECT_EQ(to_string(FilterKind::table_sat3), "table-sat3");
    EXPECT_EQ(to_string(FilterKind::supersample), "supersample");
    EXPECT_EQ(to_string(NoiseKind::white), "white");
    EXPECT_EQ(to_string(WorleyFeature::f2_f1), "f2-f1");
    EXPECT_EQ(to_string(OctaveShape::absolute), "turbulence");
    EXPECT_EQ(to_string(AtlasKind::patch), "patch");
    EXPECT_EQ(to_string(PrecisionKind::fixed), "fixed");
}

}  // namespace
}  // namespace burl
