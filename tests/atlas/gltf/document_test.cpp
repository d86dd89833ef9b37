// load_gltf() against files that would make tinygltf read outside its buffers, loop, or open files
// elsewhere; and what it keeps of images.
#include "atlas/gltf/document.h"

#include <tiny_gltf.h>

#include "atlas/base/json.h"
#include "tests/atlas/support/gltf_files.h"
#include "tests/counted_memory.h"

namespace burl {
namespace {

using test::expect_error;
using test::GltfFile;
using Json = nlohmann::json;

GltfFile one_triangle() {
    GltfFile file;
    const int points = file.positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    file.mesh({{"attributes", {{"POSITION", points}}}, {"indices", file.shorts({0, 1, 2})}});
    file.node({{"mesh", 0}});
    file.root["scenes"] = {{{"nodes", {0}}}};
    return file;
}

void expect_refused(const GltfFile& file, const std::string& message,
                    ExitCode code = ExitCode::invalid_file) {
    const auto path = (test::test_folder() / "a.gltf").string();
    expect_error([&] { load_gltf(buffer_from(file.gltf(), path)); }, code, message);
}

/// Sets root[pointer] = value in a sound file and expects the message.
void expect_refused(const std::string& pointer, const Json& value, const std::string& message) {
    GltfFile file = one_triangle();
    file.root[Json::json_pointer(pointer)] = value;
    expect_refused(file, message);
}

TEST(GltfDocument, LoadsASoundFile) {
    const std::string path = test::write_file("a.gltf", one_triangle().gltf());
    EXPECT_EQ(load_gltf(path).meshes.size(), 1u);
}

TEST(GltfDocument, BoundsOfViewsAndAccessors) {
    expect_refused("/bufferViews/0/byteOffset", 900000000,
                   "bufferViews[0]: ends at byte 900000036");
    expect_refused("/bufferViews/0/byteLength", 4000000000u,
                   "bufferViews[0].byteLength: 4000000000");
    expect_refused("/bufferViews/0/byteLength", -1, "must be a whole number");
    expect_refused("/bufferViews/0/byteLength", "36", "must be a whole number");
    expect_refused("/bufferViews/0/buffer", 1, "bufferViews[0].buffer: index 1, but there are 1");
    expect_refused("/bufferViews/0/byteStride", 4, "longer than the view's 'byteStride'");
    expect_refused("/bufferViews/0/byteStride", 16, "accessors[0]: 3 elements end at byte 44");
    expect_refused("/accessors/0/count", 4, "accessors[0]: 4 elements end at byte 48, but");
    expect_refused("/accessors/0/count", 2000000000, "accessors[0]: 2000000000 elements");
    expect_refused("/accessors/0/count", 0, "'count' must be at least 1");
    expect_refused("/accessors/0/byteOffset", 2147483647, "accessors[0]: 3 elements end");
    expect_refused("/accessors/0/bufferView", 9, "accessors[0].bufferView: index 9");
    expect_refused("/accessors/0/type", "VEC9", "unknown 'type'");
    expect_refused("/accessors/0/componentType", 5124, "unknown 'componentType'");
    expect_refused("/accessors/0/componentType", 1, "unknown 'componentType'");
    expect_refused("/buffers", Json::array({{{"byteLength", 42}}}), "buffers[0]: 'uri' is missing");
}

/// A mesh of so many vertices that are all zeros without data.
GltfFile zeros(std::size_t vertices) {
    GltfFile file;
    file.mesh({{"attributes", {{"POSITION", file.accessor(-1, 5126, "VEC3", vertices)}}}});
    file.node({{"mesh", 0}});
    return file;
}

TEST(GltfDocument, AccessorsWithoutDataStaySmallInAll) {
    constexpr std::size_t most = 1u << 20;
    EXPECT_EQ(zeros(most).read().triangles.size(), most / 3);
    expect_refused(zeros(most + 1), "POSITION: with it 1048577 elements have no bufferView");
    expect_refused(zeros(2000000000), "with it 2000000000 elements");
    GltfFile twice = zeros(most / 2 + 1);  // a use of the one costs as much as of another
    twice.mesh(twice.root["meshes"][0]["primitives"][0]);
    expect_refused(twice, "meshes[1].primitives[0].attributes.POSITION: with it 1048578 elements");
    GltfFile indexed = one_triangle();
    indexed.root["meshes"][0]["primitives"][0]["indices"] =
        indexed.accessor(-1, 5125, "SCALAR", most + 1);
    expect_refused(indexed, "primitives[0].indices: with it 1048577 elements");
    GltfFile skinned = one_triangle();
    skinned.root["skins"] = {
        {{"joints", {0}}, {"inverseBindMatrices", skinned.accessor(-1, 5126, "MAT4", 2 * most)}}};
    expect_refused(skinned, "skins[0].inverseBindMatrices: with it 2097152 elements");
}

TEST(GltfDocument, MorphTargetsThatMoveNothingNeedNoData) {
    GltfFile file;
    const std::vector<float> points(3 * 3000, 1.0f);
    file.mesh({{"attributes", {{"POSITION", file.positions(points)}}}});
    const int still = file.accessor(-1, 5126, "VEC3", 3000);
    for (int i = 0; i < 400; ++i)  // 1.2 million elements, as of many expressions of a face
        file.root["meshes"][0]["primitives"][0]["targets"].push_back({{"POSITION", still}});
    file.node({{"mesh", 0}});
    EXPECT_EQ(file.read().triangles.size(), 1000u);
}

TEST(GltfDocument, MemoryBombsAreRefusedInLittleMemory) {
    for (const char* name : {"mb1.gltf", "mb2.gltf", "samplers.gltf"}) {
        begin_peak();
        expect_error([&] { load_gltf(test::case_file(name)); }, ExitCode::invalid_file,
                     "elements have no bufferView");
        if (!counts_bytes()) continue;
        EXPECT_LT(peak_bytes(), 1u << 20) << name;
    }
}

TEST(GltfDocument, SparseBounds) {
    const auto with_sparse = [](int count, int last_index, int index_view) {
        GltfFile file = one_triangle();
        const int which =
            file.view(GltfFile::packed<std::uint8_t>({0, static_cast<std::uint8_t>(last_index)}));
        const int values = file.view(GltfFile::packed<float>({4, 0, 0, 0, 5, 6}));
        file.root["accessors"][0]["sparse"] = {
            {"count", count},
            {"indices",
             {{"bufferView", index_view < 0 ? which : index_view}, {"componentType", 5121}}},
            {"values", {{"bufferView", values}}}};
        return file;
    };
    expect_refused(with_sparse(2, 3, -1), "accessors[0].sparse: an index is out of range");
    expect_refused(with_sparse(3, 1, -1), "sparse.indices: 3 elements end at byte 3");
    expect_refused(with_sparse(9, 1, -1), "sparse: 'count' is out of range");
    expect_refused(with_sparse(2, 1, 77), "sparse.indices.bufferView: index 77");
}

TEST(GltfDocument, References) {
    expect_refused("/meshes/0/primitives/0/attributes/POSITION", 7, "POSITION: index 7");
    expect_refused("/meshes/0/primitives/0/attributes/NORMAL", -3, "NORMAL: must be a whole");
    expect_refused("/meshes/0/primitives/0/indices", 7, "primitives[0].indices: index 7");
    expect_refused("/meshes/0/primitives/0/indices", 0, "must be unsigned bytes");
    expect_refused("/meshes/0/primitives/0/material", 0, "material: index 0, but there are 0");
    expect_refused("/meshes/0/primitives/0/mode", 9, "unknown 'mode'");
    expect_refused("/meshes/0/primitives", Json::array({5}), "must be an object");
    expect_refused("/meshes/0", "x", "meshes[0]: must be an object");
    expect_refused("/nodes", Json::object(), "nodes: must be an array");
    expect_refused("/nodes/0/mesh", 3, "nodes[0].mesh: index 3");
    expect_refused("/nodes/0/matrix", {1, 2, 3}, "nodes[0].matrix: must hold 16 numbers");
    expect_refused("/scenes/0/nodes/0", 3, "scenes[0].nodes[0]: index 3");
    expect_refused("/textures", {{{"source", 0}}}, "textures[0].source: index 0");
    expect_refused("/materials",
                   {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 2}}}}}}},
                   "baseColorTexture.index: index 2");
    expect_refused("/skins", {{{"joints", {4}}}}, "skins[0].joints[0]: index 4");
    expect_refused("/skins", {{{"joints", {0}}, {"skeleton", 4}}}, "skins[0].skeleton: index 4");
    expect_refused("/skins", {{{"joints", {0}}, {"inverseBindMatrices", 9}}},
                   "inverseBindMatrices: index 9");
    expect_refused("/nodes/0/skin", 0, "nodes[0].skin: index 0");
    expect_refused("/nodes/0/camera", 0, "nodes[0].camera: index 0");
    expect_refused("/nodes/0/children", {1}, "nodes[0].children[0]: index 1");
    expect_refused("/nodes/0/weights", {"1"}, "nodes[0].weights: must hold numbers only");
    expect_refused("/meshes/0/weights", 1, "meshes[0].weights: must be an array");
    expect_refused("/textures", {{{"sampler", 0}}}, "textures[0].sampler: index 0");
    for (const char* key : {"normalTexture", "occlusionTexture", "emissiveTexture"})
        expect_refused("/materials", {{{key, {{"index", 1}}}}}, std::string(key) + ".index");
    expect_refused("/scene", 1, "glTF.scene: index 1, but there are 1 scenes");
    expect_refused("/scene", -1, "glTF.scene: must be a whole number");
    GltfFile file = one_triangle();
    file.root["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = file.positions({0, 0, 1});
    expect_refused(file, "has 3 elements, other attributes 1");
}

TEST(GltfDocument, ReferencesOfAnimations) {
    const Json sampler{{"input", 0}, {"output", 0}};
    const auto expect_wrong = [&](const Json& s, const Json& channel, const std::string& message) {
        expect_refused("/animations", {{{"samplers", {s}}, {"channels", {channel}}}}, message);
    };
    const Json target{{"node", 0}, {"path", "scale"}};
    expect_wrong({{"input", 8}, {"output", 0}}, {{"sampler", 0}, {"target", target}},
                 "samplers[0].input: index 8");
    expect_wrong({{"input", 0}, {"output", 8}}, {{"sampler", 0}, {"target", target}},
                 "samplers[0].output: index 8");
    expect_wrong({{"input", 0}}, {{"sampler", 0}, {"target", target}}, "'output' is missing");
    expect_wrong(sampler, {{"sampler", 1}, {"target", target}}, "'sampler' is out of range");
    expect_wrong(sampler, {{"sampler", 0}, {"target", {{"node", 1}}}}, "target.node: index 1");
    expect_wrong(sampler, {{"sampler", 0}, {"target", {{"node", 0}, {"path", 3}}}},
                 "path: must be a string");
}

TEST(GltfDocument, TheSceneThatIsDrawnMustExist) {
    expect_error([] { read_mesh(test::case_file("scene-out-of-range.gltf")); },
                 ExitCode::invalid_file, "glTF.scene: index 5000, but there are 1 scenes");
}

TEST(GltfDocument, VertexIndicesInRange) {
    GltfFile file = one_triangle();
    file.root["meshes"][0]["primitives"][0]["indices"] = file.shorts({0, 1, 3});
    expect_refused(file, "meshes[0]: vertex index 3, but its primitive has 3 vertices");
}

TEST(GltfDocument, NodesMustFormTrees) {
    GltfFile cycle = one_triangle();
    cycle.node({{"children", {2}}});
    cycle.node({{"children", {1}}});
    expect_refused(cycle, "their own ancestors");
    GltfFile self = one_triangle();
    self.root["nodes"][0]["children"] = {0};
    expect_refused(self, "its own child");
    GltfFile shared = one_triangle();
    shared.node({{"children", {0}}});
    shared.node({{"children", {0}}});
    expect_refused(shared, "more than one parent");
}

TEST(GltfDocument, DeepNestingIsNoDanger) {
    GltfFile file = one_triangle();
    for (int i = 1; i <= 20000; ++i) file.node({{"children", {i - 1}}});
    file.root["scenes"][0]["nodes"] = {20000};
    EXPECT_EQ(file.read().triangles.size(), 1u);
    for (const std::string key : {"extras", "extensions", "whatever"}) {
        std::string text = one_triangle().gltf();
        const std::string deep = std::string(200000, '[') + std::string(200000, ']');
        text.insert(text.find('{') + 1, "\"" + key + "\": " + deep + ",");
        const std::string path = test::write_file("deep.gltf", text);
        expect_error([&] { load_gltf(path); }, ExitCode::invalid_file, "nested more than");
    }
}

TEST(GltfDocument, StaysInItsFolder) {
    const std::string outside = (test::test_folder().parent_path() / "outside.bin").string();
    std::ofstream(outside) << std::string(100, 'x');
    for (const std::string uri : {"../outside.bin", "a/../../outside.bin", "%2e%2e/outside.bin",
                                  "..%2Foutside.bin", "/etc/passwd", "file:///etc/passwd",
                                  "http://example.org/a.bin", "..\\outside.bin", "", "C:/x.bin"}) {
        GltfFile file = one_triangle();
        file.root["buffers"] = {{{"byteLength", 42}, {"uri", uri}}};
        expect_refused(file, "may lead out of the file's folder");
    }
    GltfFile file = one_triangle();
    file.root["buffers"] = {{{"byteLength", 42}, {"uri", "missing.bin"}}};
    expect_refused(file, "missing.bin: No such file", ExitCode::io);
    test::write_file("short.bin", "1234");
    file.root["buffers"] = {{{"byteLength", 42}, {"uri", "short.bin"}}};
    expect_refused(file, "'byteLength' is 42, but only 4 bytes are there");
    file.root["buffers"] = {
        {{"byteLength", 42}, {"uri", "data:application/octet-stream;base64,AAAA"}}};
    expect_refused(file, "'byteLength' is 42, but the data uri holds 3");
    std::filesystem::remove(outside);
}

TEST(GltfDocument, ImagesStayEncoded) {
    GltfFile file = one_triangle();
    const std::string png = "\x89PNG pretended";
    test::write_file("beside.png", png);
    test::write_file("in a folder.png", png);
    std::ofstream(test::test_folder().parent_path() / "outside.png") << png;
    file.root["images"] = {{{"bufferView", file.view(png)}, {"mimeType", "image/png"}},
                           {{"uri", "data:image/png;base64," + GltfFile::base64(png)}},
                           {{"uri", "beside.png"}},
                           {{"uri", "in%20a%20folder.png"}},
                           {{"uri", "none.png"}},
                           {{"uri", "../outside.png"}}};
    const auto model = load_gltf(test::write_file("a.gltf", file.gltf()));
    ASSERT_EQ(model.images.size(), 6u);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(std::string(model.images[i].image.begin(), model.images[i].image.end()), png)
            << i;
        EXPECT_TRUE(model.images[i].as_is);
    }
    EXPECT_TRUE(model.images[4].image.empty());
    EXPECT_TRUE(model.images[5].image.empty());
    expect_refused("/images", {{{"bufferView", 55}, {"mimeType", "image/png"}}},
                   "images[0].bufferView");
}

TEST(GltfDocument, ExtensionsAndVersions) {
    for (const std::string name :
         {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "FUTURE_thing"}) {
        GltfFile file = one_triangle();
        file.root["extensionsRequired"] = {name};
        expect_refused(file, name, ExitCode::unsupported);
    }
    GltfFile looks = one_triangle();
    looks.root["extensionsRequired"] = {"KHR_materials_unlit", "KHR_texture_transform",
                                        "EXT_mesh_gpu_instancing"};
    EXPECT_EQ(looks.read().triangles.size(), 1u);
    GltfFile draco = one_triangle();  // not required, but the only form the mesh has
    draco.root["accessors"][0].erase("bufferView");
    draco.root["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", 0}, {"attributes", {{"POSITION", 0}}}};
    expect_error([&] { draco.read(); }, ExitCode::unsupported, "KHR_draco_mesh_compression");
    expect_refused("/extensionsUsed", "VEC3", "extensionsUsed");
    expect_refused("/extensionsUsed", Json::array({Json::object()}), "strings only");
    expect_refused("/asset/version", "1.0", "glTF version '1.0'");
    expect_refused("/asset", Json::object(), "'version' is missing");
}

TEST(GltfDocument, BadJsonNamesTheLine) {
    test::expect_invalid("a.gltf", "{\n \"asset\": {\"version\": \"2.0\"},\n \"nodes\": [}\n",
                         "a.gltf:3: this is not valid JSON");
    test::expect_invalid("a.gltf", "[]", "not an object");
    test::expect_invalid("a.gltf", "", "the file is empty");
    test::expect_invalid("a.gltf", "{\"asset\": 1e999}", "out of range");
}

TEST(GltfDocument, TruncatedGlb) {
    const std::string glb = one_triangle().glb();
    EXPECT_EQ(test::read_text("a.glb", glb).triangles.size(), 1u);
    for (std::size_t size = 0; size < glb.size(); size += size < 40 ? 1 : 7)
        test::expect_invalid("a.glb", glb.substr(0, size), "a.glb:");
    std::string wrong = glb;
    wrong.replace(4, 4, test::bytes_of(1u));
    test::expect_invalid("a.glb", wrong, "GLB version 1");
    wrong = glb;
    wrong.replace(12, 4, test::bytes_of(0xfffffff0u));
    test::expect_invalid("a.glb", wrong, "JSON chunk is longer");
}

TEST(GltfDocument, PositionsMustBeFinite) {
    GltfFile file;
    const int points =
        file.positions({0, 0, 0, 1, std::numeric_limits<float>::infinity(), 0, 0, 1, 0});
    file.mesh({{"attributes", {{"POSITION", points}}}});
    file.node({{"mesh", 0}});
    expect_error([&] { file.read(); }, ExitCode::invalid_file,
                 "meshes[0].primitives[0]: the position of vertex 1 is not finite");
    GltfFile flat;
    flat.mesh({{"attributes", {{"POSITION", flat.floats({0, 0, 1, 0, 0, 1}, "VEC2", 2)}}}});
    flat.node({{"mesh", 0}});
    expect_error([&] { flat.read(); }, ExitCode::invalid_file, "POSITION must be VEC3");
    GltfFile empty = one_triangle();
    empty.root["scenes"][0]["nodes"] = Json::array();
    expect_error([&] { empty.read(); }, ExitCode::invalid_file, "holds no face");
}

}  // namespace
}  // namespace burl
