// Documents before and after a bake, compared by their values: what is not carved is equal, and
// carved triangles have the values of the file's.
#include <tiny_gltf.h>

#include <array>
#include <cmath>
#include <fstream>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/bake/job.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "atlas/file/file_buffer.h"
#include "atlas/gltf/accessor.h"
#include "atlas/gltf/container.h"
#include "atlas/gltf/document.h"
#include "atlas/gltf/motion.h"
#include "atlas/read/pose.h"
#include "tests/app/support/kept_samples.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

Json document_of(const std::string& path) {
    return Json::parse(split_gltf(read_file(path)).json);
}

/// Values of a vertex, attribute after attribute.
using VertexValues = std::vector<double>;

/// Values of a primitive's vertices, and their triangles.
struct Triangles {
    std::vector<VertexValues> vertices;
    std::vector<std::array<std::size_t, 3>> corners;
};

/// Reads the attributes `names` and all targets of a primitive.
Triangles triangles_of(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                       const std::vector<std::string>& names) {
    Triangles result;
    const auto add = [&](int accessor) {
        const AccessorValues values = read_accessor(model, accessor);
        result.vertices.resize(values.count());
        for (std::size_t v = 0; v < values.count(); ++v)
            result.vertices[v].insert(result.vertices[v].end(), values[v],
                                      values[v] + values.components);
    };
    for (const std::string& name : names) add(primitive.attributes.at(name));
    for (const auto& target : primitive.targets)
        for (const auto& [name, accessor] : target)
            if (name != "TANGENT") add(accessor);
    std::vector<std::uint32_t> indices;
    if (primitive.indices >= 0) indices = read_indices(model, primitive.indices);
    for (std::uint32_t i = 0; primitive.indices < 0 && i < result.vertices.size(); ++i)
        indices.push_back(i);
    const bool list = primitive.mode < 0 || primitive.mode == TINYGLTF_MODE_TRIANGLES;
    for (std::size_t i = 0; i + 2 < indices.size(); i += list ? 3 : 1) {
        const bool fan = primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN;
        const std::size_t odd = list || fan ? 0 : i % 2;
        const std::array<std::size_t, 3> corners{indices[i + (fan ? 1 : 0)],
                                                 indices[i + 1 + (fan ? 1 : odd)],
                                                 fan ? indices[0] : indices[i + 2 - odd]};
        if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
            result.corners.push_back(corners);
    }
    return result;
}

VertexValues mean(const VertexValues& a, const VertexValues& b) {
    VertexValues result;
    for (std::size_t i = 0; i < a.size(); ++i) result.push_back(0.5 * a[i] + 0.5 * b[i]);
    return result;
}

double difference(const VertexValues& a, const VertexValues& b) {
    double most = a.size() == b.size() ? 0.0 : 1e9;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

/// Where a vertex lies in a triangle of the file: exactly at a corner, or nearly half-way on an
/// edge; nothing where it is neither.
std::optional<Vec3d> barycentric(const VertexValues& vertex,
                                 const std::array<VertexValues, 3>& corners, double tolerance) {
    for (int k = 0; k < 3; ++k)
        if (vertex == corners[std::size_t(k)]) {
            Vec3d at(0.0);
            at[k] = 1.0;
            return at;
        }
    for (int k = 0; k < 3; ++k) {
        const VertexValues middle =
            mean(corners[std::size_t(k)], corners[std::size_t((k + 1) % 3)]);
        if (difference(vertex, middle) > tolerance) continue;
        Vec3d at(0.5);
        at[(k + 2) % 3] = 0.0;
        return at;
    }
    return std::nullopt;
}

/// Expects that the triangles of `made`, one or several for each of `file` in their order, cover
/// these.
void expect_same_surface(const Triangles& file, const Triangles& made, double tolerance) {
    std::size_t next = 0;
    for (const auto& triangle : file.corners) {
        const std::array<VertexValues, 3> corners{
            file.vertices[triangle[0]], file.vertices[triangle[1]], file.vertices[triangle[2]]};
        double area = 0.0;
        while (area < 0.999) {
            ASSERT_LT(next, made.corners.size());
            Mat3d places(0.0);
            for (int k = 0; k < 3; ++k) {
                const auto at = barycentric(made.vertices[made.corners[next][std::size_t(k)]],
                                            corners, tolerance);
                ASSERT_TRUE(at) << "triangle " << next;
                places[k] = *at;
            }
            const double share = glm::determinant(places);
            ASSERT_GT(share, 0.0) << "turned over";
            area += share;
            ++next;
        }
        ASSERT_NEAR(area, 1.0, 1e-9);
    }
    EXPECT_EQ(next, made.corners.size());
}

/// The accessor's values as JSON.
Json values_json(const tinygltf::Model& model, const Json& accessor) {
    return read_accessor(model, accessor.get<int>()).values;
}

/// The document without what a carving changes, with values in place of accessors.
Json rest_of(const std::string& path) {
    Json json = document_of(path);
    const tinygltf::Model model = load_gltf(path);
    for (const char* key : {"accessors", "bufferViews", "buffers", "textures", "images", "samplers",
                            "materials", "extensionsUsed"})
        json.erase(key);
    if (json["asset"].contains("extras")) {
        json["asset"]["extras"].erase("burl");
        if (json["asset"]["extras"].empty()) json["asset"].erase("extras");
    }
    for (Json& mesh : json["meshes"])
        for (Json& primitive : mesh["primitives"])
            for (const char* key : {"attributes", "indices", "mode", "material", "targets"})
                primitive.erase(key);
    if (json.contains("skins"))
        for (Json& skin : json["skins"])
            skin["inverseBindMatrices"] = values_json(model, skin["inverseBindMatrices"]);
    if (json.contains("animations"))
        for (Json& animation : json["animations"])
            for (Json& sampler : animation["samplers"])
                for (const char* key : {"input", "output"})
                    sampler[key] = values_json(model, sampler[key]);
    for (Json& node : json["nodes"]) {
        const auto copies = Json::json_pointer("/extensions/EXT_mesh_gpu_instancing/attributes");
        if (node.contains(copies))
            for (Json& accessor : node[copies]) accessor = values_json(model, accessor);
    }
    return json;
}

/// Bakes by the program's own way, with further options.
Json bake(const std::string& mesh, const std::string& out,
          const std::function<void(BakeCommand&)>& change = {}) {
    BakeCommand command;
    command.mesh = mesh;
    command.out = out;
    command.recipe.recipe = "hammered";
    command.recipe.settings = {"atlas.size=64"};
    if (change) change(command);
    const BakeJob job(command, Json::object());
    Pipeline pipeline(job.command().load_mesh());
    return job.run(pipeline, nullptr, 0.0, LaterBake::none);
}

class KeptSampleTest : public testing::TestWithParam<std::string> {
  protected:
    KeptSampleTest() {
        source = folder / (GetParam() + ".gltf");
        std::ofstream(source) << kept_samples().at(GetParam());
    }
    ScratchFolder folder;
    std::string source;
};

void expect_meshes_equal(const std::string& source, const std::string& made, double tolerance) {
    const tinygltf::Model before = load_gltf(source), after = load_gltf(made);
    ASSERT_EQ(before.meshes.size(), after.meshes.size());
    for (std::size_t m = 0; m < before.meshes.size(); ++m) {
        ASSERT_EQ(before.meshes[m].primitives.size(), after.meshes[m].primitives.size());
        for (std::size_t p = 0; p < before.meshes[m].primitives.size(); ++p) {
            const tinygltf::Primitive& old = before.meshes[m].primitives[p];
            if (old.mode >= 0 && old.mode < TINYGLTF_MODE_TRIANGLES) continue;
            std::vector<std::string> names;
            for (const auto& [name, accessor] : old.attributes) names.push_back(name);
            SCOPED_TRACE("mesh " + std::to_string(m) + " primitive " + std::to_string(p));
            expect_same_surface(triangles_of(before, old, names),
                                triangles_of(after, after.meshes[m].primitives[p], names),
                                tolerance);
        }
    }
}

TEST_P(KeptSampleTest, KeepsAllButTheCarving) {
    for (const char* atlas : {"quad", "patch"}) {
        SCOPED_TRACE(atlas);
        const std::string out = folder / (std::string(atlas) + ".glb");
        bake(source, out, [&](BakeCommand& command) {
            command.recipe.settings.push_back(std::string("atlas.kind=") + atlas);
        });
        EXPECT_EQ(rest_of(source), rest_of(out));
        // Middles are normalised and rounded: half a unit of the coarsest encoding, a byte.
        expect_meshes_equal(source, out, 0.06);
    }
}

TEST_P(KeptSampleTest, MovesAsBefore) {
    const std::string out = folder / "quad.glb";
    bake(source, out,
         [](BakeCommand& command) { command.recipe.settings.emplace_back("atlas.kind=quad"); });
    const FileBuffer before = read_file(source), after = read_file(out);
    ASSERT_EQ(pose_names(before), pose_names(after));
    const tinygltf::Model model = load_gltf(before);
    for (std::size_t a = 0; a < model.animations.size(); ++a)
        for (int moment = 0; moment < 10; ++moment) {
            const std::string name = model.animations[a].name + "@" + std::to_string(0.15 * moment);
            const MeshPose old = read_own_pose(before, name), now = read_own_pose(after, name);
            ASSERT_EQ(old.positions.size(), now.positions.size());
            for (std::size_t c = 0; c < old.positions.size(); ++c)
                ASSERT_LE(glm::distance(old.positions[c], now.positions[c]), 1e-6);
        }
}

std::vector<std::string> names_of_samples() {
    std::vector<std::string> names;
    for (const auto& [name, text] : kept_samples()) names.push_back(name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Samples, KeptSampleTest, testing::ValuesIn(names_of_samples()),
                         [](const auto& one) { return one.param; });

class KeptTest : public testing::Test {
  protected:
    std::string sample(const std::string& name) {
        const std::string path = folder / (name + ".gltf");
        std::ofstream(path) << kept_samples().at(name);
        return path;
    }
    ScratchFolder folder;
};

TEST_F(KeptTest, AssignGivesEachMaterialItsRecipeAndLeavesOthersAlone) {
    const std::string source = sample("two_materials"), out = folder / "a.glb";
    bake(source, out, [](BakeCommand& command) { command.assigned = {"Met*=gold"}; });
    const Json before = document_of(source), after = document_of(out);
    EXPECT_EQ(before["materials"][0], after["materials"][0]);
    EXPECT_EQ(after["materials"][1]["name"], "Metal");
    EXPECT_EQ(after["materials"][1]["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"], 1);
    EXPECT_FALSE(after["meshes"][0]["primitives"][0]["attributes"].contains("TEXCOORD_1"));
    EXPECT_TRUE(after["meshes"][0]["primitives"][1]["attributes"].contains("TEXCOORD_1"));
}

TEST_F(KeptTest, SeveralAtlasesShareADocument) {
    const std::string source = sample("two_materials_skin"), out = folder / "a.gltf";
    const Json report = bake(source, out, [](BakeCommand& command) {
        command.assigned = {"Wood*=oak", "Metal=gold"};
        command.atlas_per = "recipe";
    });
    const Json after = document_of(out);
    const auto base = Json::json_pointer("/pbrMetallicRoughness/baseColorTexture/index");
    const Json &wood = after["materials"][0], &metal = after["materials"][1];
    const auto file = [&](const Json& material) {
        const std::size_t texture = material.at(base);
        const std::size_t image = after["textures"][texture]["source"];
        return after["images"][image]["uri"].get<std::string>();
    };
    EXPECT_EQ(file(wood), "a_oak.png");
    EXPECT_EQ(file(metal), "a_gold.png");
    for (const auto& output : report["outputs"])
        EXPECT_TRUE(std::filesystem::exists(output.get<std::string>())) << output;
    EXPECT_EQ(rest_of(source), rest_of(out));
    expect_meshes_equal(source, out, 1e-6);
}

TEST_F(KeptTest, RecipesShareTheAtlasOfAScene) {
    const std::string source = sample("two_materials_skin"), out = folder / "a.gltf";
    const Json report = bake(source, out, [](BakeCommand& command) {
        command.assigned = {"Wood*=oak", "Metal=gold"};
    });
    const Json after = document_of(out);
    const Json wood = after["materials"][0]["pbrMetallicRoughness"],
               metal = after["materials"][1]["pbrMetallicRoughness"];
    EXPECT_EQ(wood["baseColorTexture"]["index"], metal["baseColorTexture"]["index"]);
    EXPECT_EQ(after["images"][0]["uri"], "a.png");
    EXPECT_EQ(wood["metallicFactor"], 0.0);
    EXPECT_FALSE(metal.contains("metallicFactor") && metal["metallicFactor"] != 1.0);
    EXPECT_EQ(report["recipes"].size(), 2u);
    EXPECT_EQ(after["asset"]["extras"]["burl"]["recipes"].size(), 2u);
    for (const auto& output : report["outputs"])
        EXPECT_TRUE(std::filesystem::exists(output.get<std::string>())) << output;
    EXPECT_EQ(rest_of(source), rest_of(out));
    expect_meshes_equal(source, out, 1e-6);
}

TEST_F(KeptTest, NodesThatAreNotChosenKeepTheirMesh) {
    const std::string out = folder / "a.glb";
    bake(sample("instances"), out,
         [](BakeCommand& command) { command.meshes.read.choice.nodes = {"copy"}; });
    const Json after = document_of(out);
    EXPECT_EQ(after["nodes"][0]["mesh"], 0);
    EXPECT_EQ(after["nodes"][1]["mesh"], 1);
    EXPECT_EQ(after["nodes"][2]["mesh"], 1);
    EXPECT_FALSE(after["meshes"][0]["primitives"][0].contains("material"));
    EXPECT_TRUE(after["meshes"][1]["primitives"][0].contains("material"));
}

TEST_F(KeptTest, UvSetMovesTheOldSetsUp) {
    const std::string source = sample("attributes"), out = folder / "a.glb";
    bake(source, out, [](BakeCommand& command) { command.uv_set = 0; });
    const tinygltf::Model before = load_gltf(source), after = load_gltf(out);
    const auto& old = before.meshes[0].primitives[0];
    auto now = after.meshes[0].primitives[0];
    now.attributes["TEXCOORD_0"] = now.attributes["TEXCOORD_1"];
    now.attributes["TEXCOORD_1"] = now.attributes["TEXCOORD_2"];
    const std::vector<std::string> names{"POSITION", "TEXCOORD_0", "TEXCOORD_1"};
    expect_same_surface(triangles_of(before, old, names), triangles_of(after, now, names), 1e-6);
    const std::string gap = folder / "b.glb";
    EXPECT_THROW(bake(source, gap, [](BakeCommand& command) { command.uv_set = 3; }), Error);
    EXPECT_FALSE(std::filesystem::exists(gap));
}

TEST_F(KeptTest, StrictRefusesWhatAFormatCannotKeep) {
    const std::string out = folder / "a.obj";
    const auto strict = [](BakeCommand& command) { command.strict = true; };
    try {
        bake(sample("skin_animated"), out, strict);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::unsupported);
        EXPECT_THAT(error.what(), testing::HasSubstr("1 skins"));
        EXPECT_THAT(error.what(), testing::HasSubstr("1 animations"));
    }
    EXPECT_FALSE(std::filesystem::exists(out));
    bake(sample("plain"), folder / "b.glb", strict);
}

TEST_F(KeptTest, KeysOfThePoseAreAnAnimationOfTheSameWeights) {
    for (const std::string ease : {"linear", "smooth"}) {
        const std::string recipe = folder / "keyed.json", out = folder / (ease + ".glb");
        std::ofstream(recipe)
            << R"({"burl": 1, "animation": {"seconds": 4, "tracks": [{"path": "pose.weight",)"
            << R"("ease": ")" << ease << R"(", "keys": [[0, 0], [3, 1], [4, 0.25]]}]}})";
        bake(sample("morph"), out, [&](BakeCommand& command) {
            command.pose = "fat";
            command.recipe.recipe = recipe;
        });
        const tinygltf::Model model = load_gltf(out);
        ASSERT_EQ(model.animations.size(), 1u);
        for (const double seconds : {0.0, 1.0, 2.25, 3.0, 3.5, 4.0}) {
            // Straight lines, or 3 x^2 - 2 x^3 between the keys.
            double x = seconds < 3.0 ? seconds / 3.0 : seconds - 3.0;
            if (ease == "smooth") x = x * x * (3.0 - 2.0 * x);
            const double weight = seconds < 3.0 ? x : 1.0 - 0.75 * x;
            const GltfMotion motion = motion_at(model, 0, seconds, out);
            EXPECT_NEAR(motion.target_weights[0].at(0), weight, 1e-6) << ease << ' ' << seconds;
        }
    }
}

TEST_F(KeptTest, WrongNamesAreToldWithThoseThatThereAre) {
    const auto wrong = [](BakeCommand& command) {
        command.meshes.read.choice.materials = {"Glas*"};
    };
    try {
        bake(sample("two_materials"), folder / "a.glb", wrong);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::usage);
        EXPECT_THAT(error.what(), testing::HasSubstr("Wood old, Metal"));
    }
}

}  // namespace
}  // namespace burl
