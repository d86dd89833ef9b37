// A document whose members have types that glTF 2.0 does not give them: a reader of meshes has no
// use for a flag or a name, whatever its type; whoever keeps the document has.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <utility>

#include "atlas/base/json.h"
#include "tests/app/programs/run_program.h"
#include "tests/app/support/kept_samples.h"

namespace burl {
namespace {

TEST(KeptMemberTypes, AreToldWithTheFileAndNothingIsWritten) {
    const test::Scratch scratch;
    const std::pair<const char*, Json> wrong[] = {{"/accessors/0/normalized", 1},
                                                  {"/materials/0/name", 7},
                                                  {"/materials/1/doubleSided", "yes"}};
    for (const auto& [place, value] : wrong) {
        Json document = Json::parse(kept_samples().at("two_materials"));
        document[Json::json_pointer(place)] = value;
        std::ofstream(scratch / "wrong.gltf") << document;
        const test::Outcome outcome = test::run_burl(
            scratch,
            fmt::format("bake '{}' -o '{}' --size 16", scratch / "wrong.gltf", scratch / "a.glb"));
        EXPECT_EQ(outcome.exit_code, 3) << place << outcome.err;
        EXPECT_THAT(outcome.err, testing::HasSubstr("wrong.gltf: a member of the glTF")) << place;
        EXPECT_FALSE(std::filesystem::exists(scratch / "a.glb"));
    }
}

/// Extras may have any type, and Burl's are in an object.
TEST(KeptMemberTypes, ExtrasThatHoldNoOthersAreTold) {
    const test::Scratch scratch;
    Json document = Json::parse(kept_samples().at("plain"));
    document["asset"]["extras"] = "mine";
    std::ofstream(scratch / "text.gltf") << document;
    const auto bake = [&](const char* strict) {
        return test::run_burl(scratch,
                              fmt::format("bake '{}' -o '{}' --size 16 {}", scratch / "text.gltf",
                                          scratch / "a.glb", strict));
    };
    const auto is_told = testing::HasSubstr("not kept: asset.extras");
    const test::Outcome refused = bake("--strict"), baked = bake("");
    EXPECT_EQ(refused.exit_code, 5);
    EXPECT_THAT(refused.err, is_told);
    EXPECT_EQ(baked.exit_code, 0);
    EXPECT_THAT(baked.err, is_told);
}

}  // namespace
}  // namespace burl
