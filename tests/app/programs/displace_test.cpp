// `burl bake --displace` from outside.
#include <cmath>
#include <sstream>

#include "tests/app/programs/run_program.h"

namespace burl::test {
namespace {

/// The lengths of an OBJ file's points.
std::vector<double> radii_of(const std::string& obj) {
    std::vector<double> radii;
    std::istringstream lines(obj);
    for (std::string line; std::getline(lines, line);) {
        double x = 0, y = 0, z = 0;
        if (std::sscanf(line.c_str(), "v %lf %lf %lf", &x, &y, &z) == 3)
            radii.push_back(std::sqrt(x * x + y * y + z * z));
    }
    return radii;
}

TEST(Displace, MovesThePointsOfTheExportedMesh) {
    const Scratch scratch;
    const std::string recipe = scratch.write("r.json", R"({"solid": {"space": "object"},
        "atlas": {"size": 64}, "material": {"height": 1}, "bump": {"height": 0.25}})");
    const auto bake = [&](const std::string& out, const std::string& more) {
        const Outcome outcome =
            run_burl(scratch, fmt::format("bake sample:icosphere -o '{}' --recipe '{}' {}",
                                          scratch / out, recipe, more));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return slurp(scratch / out);
    };
    const std::vector<double> rest = radii_of(bake("rest.obj", "--normals none")),
                              moved = radii_of(bake("moved.obj", "--displace 0")),
                              fine = radii_of(bake("fine.obj", "--displace 1"));
    ASSERT_EQ(rest.size(), moved.size());
    ASSERT_GT(rest.size(), 10u);
    for (std::size_t i = 0; i < rest.size(); ++i) EXPECT_NEAR(moved[i], rest[i] + 0.25, 1e-3);
    EXPECT_GT(fine.size(), 3 * moved.size());
    // A glTF has the moved points themselves and no normal map.
    const std::string gltf = bake("a.gltf", "--displace 0");
    EXPECT_EQ(gltf.find("normalTexture"), std::string::npos);
    EXPECT_EQ(gltf.find("targets"), std::string::npos);
}

TEST(Displace, RefusesInOneSentence) {
    const Scratch scratch;
    struct Bad {
        const char *out, *options, *says;
    };
    for (const Bad& bad :
         {Bad{"a.png", "--recipe hammered --displace 1", "no points to move"},
          Bad{"a.obj", "--recipe marble --displace 1", "has no height"},
          Bad{"a.obj", "--recipe hammered --displace 1 --normals tangent", "leave --normals out"},
          Bad{"a.obj", "--recipe hammered --displace 9", "--displace"}}) {
        const Outcome outcome = run_burl(
            scratch, fmt::format("bake sample:cube -o '{}' {}", scratch / bad.out, bad.options));
        EXPECT_EQ(outcome.exit_code, 1) << bad.options;
        expect_one_sentence(outcome.err);
        EXPECT_NE(outcome.err.find(bad.says), std::string::npos) << outcome.err;
        EXPECT_EQ(scratch.files(), 0u);
    }
}

}  // namespace
}  // namespace burl::test
