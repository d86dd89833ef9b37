// A glTF of two materials, "Wood old" and "Metal", of which each has a recipe of its own, or one is
// left out.
#include <gmock/gmock.h>

#include "tests/app/programs/run_program.h"
#include "tests/app/support/kept_samples.h"

namespace burl::test {
namespace {

using testing::HasSubstr;

struct TwoMaterials : testing::Test {
    TwoMaterials() { scratch.write("two.gltf", kept_samples().at("two_materials")); }
    Outcome bake(const std::string& out, const std::string& options) const {
        return run_burl(scratch, fmt::format("bake two.gltf -o {} -q {}", out, options),
                        fmt::format("cd '{}' &&", scratch.path().string()));
    }
    const Scratch scratch;
};

TEST_F(TwoMaterials, WhatOnlyTheRecipeHeedsIsRefusedWhereNoMaterialHasIt) {
    const std::string set = "--assign '*=marble' --set solid.scale=3";
    const Outcome idle = bake("a.glb", set);
    EXPECT_EQ(idle.exit_code, 1);
    EXPECT_THAT(idle.err, HasSubstr("--set solid.scale=3 changes the recipe of --recipe alone"));
    EXPECT_EQ(bake("a.glb", "--assign 'Wood*=marble' --set bogus.key=3").exit_code, 1);
    const Outcome unused = bake("a.glb", "--assign '*=marble' -r oak");
    EXPECT_EQ(unused.exit_code, 1);
    EXPECT_THAT(unused.err, HasSubstr("--recipe oak does nothing"));
    EXPECT_EQ(scratch.files(), 1u);
    EXPECT_EQ(bake("b.glb", "--assign 'Wood*=marble' -r wood --set solid.scale=3").exit_code, 0);
    EXPECT_EQ(bake("c.glb", "--assign 'Wood*=marble' -r wood").exit_code, 0);
    EXPECT_NE(slurp(scratch / "b.glb"), slurp(scratch / "c.glb"));
    EXPECT_EQ(bake("d.glb", "--assign '*=marble' --set atlas.size=64").exit_code, 0);
    EXPECT_EQ(bake("e.glb", "--assign '*=marble' --size 64").exit_code, 0);
    EXPECT_EQ(slurp(scratch / "d.glb"), slurp(scratch / "e.glb"));
}

TEST_F(TwoMaterials, AnAssignmentThatComesTooLateIsRefused) {
    for (const char* late : {"--assign '*=oak' --assign 'Metal=gold'",
                             "--assign 'Metal=gold' --assign 'Met*=marble'"}) {
        const Outcome bad = bake("a.glb", late);
        EXPECT_EQ(bad.exit_code, 1) << late;
        EXPECT_THAT(bad.err, HasSubstr("does nothing: all materials of such a name")) << late;
    }
    EXPECT_EQ(bake("a.glb", "--assign Metal=gold --assign '*=oak'").exit_code, 0);
}

TEST_F(TwoMaterials, TrianglesThatAreNotChosenAreALossOutsideOfTheirDocument) {
    for (const char* out : {"a.obj", "a.ply", "a.stl", "a.glb --vertex-colors"}) {
        const Outcome strict = bake(out, "--material Metal --strict");
        EXPECT_EQ(strict.exit_code, 5) << out;
        EXPECT_THAT(strict.err, HasSubstr("not kept: 80 triangles that are not chosen; ")) << out;
    }
    EXPECT_EQ(scratch.files(), 1u);
    EXPECT_EQ(bake("b.glb", "--material Metal --strict").exit_code, 0);
}

TEST_F(TwoMaterials, ShareTheirPointsOfWhichNoneIsLeftOut) {
    const Outcome outcome = bake("a.glb", "--material Metal");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err.find("no face uses"), std::string::npos) << outcome.err;
}

TEST_F(TwoMaterials, NoneThatIsNotThereIsOffered) {
    const Outcome outcome = bake("a.glb", "--material 'Wod*'");
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("there are: Wood old, Metal\n"));
}

TEST(ChosenNodes, ThatHoldNoMeshAreRefused) {
    const Scratch scratch;
    scratch.write("seen.gltf", kept_samples().at("cameras"));
    const Outcome outcome = run_burl(scratch, "bake seen.gltf -o a.glb --node top",
                                     fmt::format("cd '{}' &&", scratch.path().string()));
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("nothing in the scene is all that --mesh, --node and"));
}

}  // namespace
}  // namespace burl::test
