// `--precision` and the recipe's key: what it changes, and what it refuses.
#include <gtest/gtest.h>

#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/recipe.h"
#include "atlas/base/error.h"
#include "tests/app/programs/run_program.h"

namespace burl::test {
namespace {

constexpr const char* precision_mesh =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

TEST(Precision, IsPartOfTheRecipeAndComesBackFromItsJson) {
    const Recipe plain = load_recipe("wood");
    EXPECT_FALSE(plain.precision.kind.has_value());
    for (const auto& [settings, expected] :
         {std::pair<std::vector<std::string>, Precision>{{"precision.kind=float32"},
                                                         {PrecisionKind::float32, {}}},
          {{"precision.kind=float64"}, {PrecisionKind::float64, {}}},
          {{"precision.kind=fixed", "precision.integer_bits=4", "precision.fraction_bits=12"},
           {PrecisionKind::fixed, {4, 12}}}}) {
        const Recipe recipe = load_recipe("wood", settings);
        EXPECT_EQ(recipe.precision, expected);
        EXPECT_NE(recipe, plain);
        EXPECT_EQ(parse_recipe(to_json(recipe), "again"), recipe);
    }
}

/// The bytes that a bake with the options writes.
std::string precision_baked(const Scratch& scratch, const std::string& mesh,
                            const std::string& options) {
    const std::string out = scratch / "out.png";
    const Outcome outcome =
        run_burl(scratch, fmt::format("bake '{}' -o '{}' -s 64 -a area -q {}", mesh, out, options));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return slurp(out);
}

TEST(Precision, DecidesWhatABakeWrites) {
    const Scratch scratch;
    const std::string mesh = scratch.write("t.obj", precision_mesh);
    const auto bake = [&](const std::string& options) {
        return precision_baked(scratch, mesh, options);
    };
    const std::string usual = bake("");
    EXPECT_EQ(bake("--precision float32"), usual);
    EXPECT_NE(bake("--depth 16 --precision float64"), bake("--depth 16"));
    EXPECT_NE(bake("--precision fixed:8.4"), usual);
    EXPECT_NE(bake("--precision fixed:8.4"), bake("--precision fixed:8.6"));
    EXPECT_EQ(bake("--precision fixed:8.4"),
              bake("--set precision.kind=fixed --set precision.fraction_bits=4"));
    EXPECT_EQ(bake("--precision fixed:8.4 -j 1"), bake("--precision fixed:8.4 -j 3"));
    const std::string point = bake("--precision fixed:8.12");
    for (const char* filter : {"table-mip", "table-sat", "table-sat3", "exact", "trapezoid",
                               "trapezoid2", "supersample:4"}) {
        const std::string filtered = fmt::format("--precision fixed:8.12 --filter {}", filter);
        EXPECT_NE(bake(filtered), point) << filter;
        EXPECT_EQ(bake(filtered + " -j 1"), bake(filtered + " -j 3")) << filter;
    }
    // Graphs have noise in float32, and all else in float64 as it is.
    EXPECT_EQ(bake("-r wrinkled --precision float32"), bake("-r wrinkled"));
    EXPECT_NE(bake("-r wrinkled --depth 16 --precision float64"), bake("-r wrinkled --depth 16"));
    EXPECT_EQ(bake("-r dots --precision float64"), bake("-r dots"));
}

TEST(Precision, DecidesWhatAPictureOfTheExactTextureShows) {
    const Scratch scratch;
    const std::string mesh = scratch.write("t.obj", precision_mesh);
    const auto render = [&](const std::string& options) {
        const std::string out = scratch / "out.png";
        const Outcome outcome = run_burl(
            scratch,
            fmt::format("render --direct '{}' -o '{}' --size 64x64 {}", mesh, out, options));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return slurp(out);
    };
    const std::string usual = render("");
    EXPECT_EQ(render("--precision float64"), usual);
    EXPECT_NE(render("--precision fixed:8.4"), usual);
    EXPECT_FALSE(render("--precision float32").empty());
    EXPECT_NE(render("--precision fixed:8.12 --filter table-sat"),
              render("--precision fixed:8.12"));
    EXPECT_NE(render("--precision fixed:8.4 --filter table-mip"),
              render("--precision fixed:8.12 --filter table-mip"));
    EXPECT_EQ(render("-r dots --precision float32"), render("-r dots"));
    EXPECT_FALSE(render("-r wrinkled --precision float32").empty());
}

struct Refusal {
    const char* options;
    const char* says;
};

TEST(Precision, RefusesInOneSentenceWhatFixedPointDoesNotHave) {
    const Scratch scratch;
    const std::string mesh = scratch.write("t.obj", precision_mesh);
    for (const auto& [options, says] :
         {Refusal{"--precision double", "must be float32, float64, or fixed:I.F"},
          {"--precision fixed", "as fixed:8.8"},
          {"--precision fixed:8", "as fixed:8.8"},
          {"--precision fixed:8.", "as fixed:8.8"},
          {"--precision fixed:.8", "as fixed:8.8"},
          {"--precision fixed:8.8.8", "as fixed:8.8"},
          {"--precision fixed:-8.8", "as fixed:8.8"},
          {"--precision fixed:17.8", "1 to 16 bits"},
          {"--precision fixed:8.1", "2 to 16 after"},
          {"--precision fixed:99999999999.8", "1 to 16 bits"},
          {"--precision float64:8.8", "must be float32"},
          {"--set precision.kind=half", "precision.kind"},
          {"--set precision.fraction_bits=17", "2 to 16"},
          {"--precision fixed:8.8 --recipe checks", "other nodes than a color_map over a field"},
          {"--precision fixed:8.8 --set texture.input.noise.0.kind=worley",
           "texture.input.noise.0 is worley noise; fixed point has value and perlin noise"},
          {"--precision fixed:8.8 --set texture.input.noise.0.time=1", "noise in time"},
          {"--precision fixed:8.8 --set texture.input.noise.0.period.0=4", "noise with a period"},
          {"--precision fixed:8.8 --set filter.octaves=fade", "keeps all octaves"}}) {
        const Outcome outcome = run_burl(
            scratch, fmt::format("bake '{}' -o '{}' {}", mesh, scratch / "o.png", options));
        EXPECT_EQ(outcome.exit_code, 1) << options << "\n" << outcome.err;
        expect_one_sentence(outcome.err);
        EXPECT_NE(outcome.err.find(says), std::string::npos) << outcome.err;
    }
    // In a file it is the file that is wrong.
    const std::string file = scratch.write(
        "r.json", R"({"precision": {"kind": "fixed"}, "filter": {"octaves": "fade"}})");
    const Outcome outcome =
        run_burl(scratch, fmt::format("bake '{}' -o '{}' -r '{}'", mesh, scratch / "o.png", file));
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_NE(
        outcome.err.find("r.json: precision.kind is \"fixed\", but filter.octaves is \"fade\""),
        std::string::npos)
        << outcome.err;
}

}  // namespace
}  // namespace burl::test
