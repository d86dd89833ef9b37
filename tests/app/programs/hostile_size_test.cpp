// Files of some hundred kilobytes that once took minutes, or more memory than there is.
#include <chrono>

#include "app/scene/scene.h"
#include "atlas/base/json.h"
#include "tests/app/programs/run_program.h"

namespace burl::test {
namespace {

using Json = nlohmann::json;

TEST(HostileSize, MaterialsOfAnObjTakeLinearTime) {
    const Scratch scratch;
    constexpr int count = 30000;
    std::string mesh = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n", library;
    for (int i = 0; i < count; ++i) {
        mesh += fmt::format("usemtl m{}\nf 1 2 3\n", i);
        library += fmt::format("newmtl m{}\nPr 0.{}\n", i, i % 10);
    }
    library += "newmtl m7\nPr 0\n";  // the first one counts
    scratch.write("a.mtl", library);
    const std::string path = scratch.write("a.obj", mesh);
    const auto begin = std::chrono::steady_clock::now();
    const Scene scene = load_scene(path);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
    ASSERT_EQ(scene.surfaces.size(), std::size_t(count));
    for (const std::size_t i : {0u, 7u, 29999u})
        EXPECT_FLOAT_EQ(scene.surfaces[i].material.roughness, 0.1f * float(i % 10));
}

TEST(HostileSize, TooManyBakesAreRefused) {
    const Scratch scratch;
    const Json list = std::vector<int>(100, 16), words = std::vector<std::string>(100, "quad");
    const Json bake{{"mesh", "sample:cube"},
                    {"size", list},
                    {"atlas", words},
                    {"crease", list},
                    {"output", "a.png"}};
    const std::string path = scratch.write("a.json", Json{{"bakes", Json::array({bake})}}.dump());
    const Outcome outcome = run_burl(scratch, fmt::format("batch '{}' --dry-run", path));
    EXPECT_EQ(outcome.exit_code, 5) << outcome.err;
    EXPECT_NE(outcome.err.find("1000000 bakes, and 100000 are the most"), std::string::npos)
        << outcome.err;
}

/// A triangle twice, with `more` members of no meaning, which move the document's others in memory
/// when one is added.
Json two_triangles(int more) {
    Json gltf{{"asset", {{"version", "2.0"}}}};
    for (int i = 0; i < more; ++i) gltf[fmt::format("more{}", i)] = i;
    const Json primitive{{"attributes", {{"POSITION", 0}}}};
    gltf["scenes"] = Json::array({{{"nodes", {0}}}});
    gltf["nodes"] = Json::array({{{"mesh", 0}}});
    gltf["meshes"] = Json::array({{{"primitives", {primitive, primitive}}}});
    gltf["accessors"] = Json::array({{{"bufferView", 0},
                                      {"componentType", 5126},
                                      {"count", 3},
                                      {"type", "VEC3"},
                                      {"min", {0, 0, 0}},
                                      {"max", {1, 1, 0}}}});
    gltf["bufferViews"] = Json::array({{{"buffer", 0}, {"byteLength", 36}}});
    gltf["buffers"] = Json::array({{{"byteLength", 36},
                                    {"uri",
                                     "data:application/octet-stream;base64,"
                                     "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}}});
    return gltf;
}

TEST(KeptDocuments, TakeNewListsWhereverTheirMembersLie) {
    const Scratch scratch;
    for (int more = 0; more < 9; ++more) {
        SCOPED_TRACE(more);
        const std::string path = scratch.write("a.gltf", two_triangles(more).dump());
        const Outcome outcome =
            run_burl(scratch, fmt::format("bake '{}' --size 16 --atlas quad --force -o '{}'", path,
                                          scratch / "b.gltf"));
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        const Json baked = Json::parse(slurp(scratch / "b.gltf"));
        EXPECT_EQ(baked.at("textures").size(), 1u);
        EXPECT_EQ(baked.at("samplers").size(), 1u);
        EXPECT_EQ(baked.at("materials").size(), 1u);
        EXPECT_EQ(baked.at("meshes")[0]["primitives"][0]["material"], 0);
        EXPECT_EQ(baked.size(), 11u + std::size_t(more));
    }
}

}  // namespace
}  // namespace burl::test
