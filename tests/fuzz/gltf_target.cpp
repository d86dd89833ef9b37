// glTF and GLB: the mesh, its poses, the scene that is drawn, and the document that is kept.
#include <algorithm>
#include <array>

#include "app/kept/document.h"
#include "app/scene/scene.h"
#include "app/surface/tangents.h"
#include "atlas/base/json.h"
#include "atlas/mesh/mesh_builder.h"
#include "atlas/read/gltf_origins.h"
#include "atlas/read/pose.h"
#include "atlas/read/readers.h"
#include "tests/app/support/kept_samples.h"
#include "tests/fuzz/sound_mesh.h"
#include "tests/fuzz/target.h"
#include "tests/paths.h"

namespace burl::fuzz {
namespace {

/// The bytes as a file that lies beside the pictures in tests/cases.
FileBuffer file_of(const std::string& bytes) {
    return buffer_from(bytes, test::case_file("a.glb"));
}

void read_poses(const std::string& bytes) {
    std::vector<std::string> names = pose_names(file_of(bytes));
    if (names.size() > 4) names.resize(4);
    names.push_back("nodes");
    for (const std::string& name : names)
        attempt([&] {
            const MeshPose pose = read_own_pose(file_of(bytes), name);
            const Mesh mesh = build_mesh(parse_gltf(file_of(bytes)), "a.glb");
            check_mesh(posed_mesh(mesh, pose, 0.5));
        });
    attempt([&] { read_pose(file_of(bytes), file_of(bytes)); });
}

/// Adds to a document as a bake does: vertices like its own, indices and floats.
void add_to(KeptDocument& document) {
    const Json accessors = document.json.value("accessors", Json::array());
    for (std::size_t i = 0; i < accessors.size(); ++i)
        document.add_vertices(document.elements(i), accessors[i]);
    document.add_indices({0, 1, 2}, 3);
    document.add_floats(std::array{0.0f, 1.0f}, 2);
    document.use_extension("KHR_texture_transform");
    document.forget_extension("EXT_meshopt_compression");
}

void read_document(const std::string& bytes) {
    KeptDocument document(file_of(bytes));
    const std::size_t count = document.json.value("accessors", Json::array()).size();
    for (std::size_t i = 0; i < count; ++i) document.elements(i);
    if (document.knows_references()) document.drop_unused();
    add_to(document);
    document.lay_out();
}

void read_mesh_of(const std::string& bytes, const ReadOptions& options) {
    check_mesh(build_mesh(parse_gltf(file_of(bytes), options), "a.glb", options));
    const GltfOrigins origins = read_gltf_origins(file_of(bytes), options);
    for (const GltfRun& run : origins.runs)
        require(run.part < origins.parts.size(), "runs belong to parts");
}

void read_gltf(const std::string& bytes) {
    attempt([&] { read_mesh_of(bytes, {}); });
    attempt([&] { read_mesh_of(bytes, {.unshare_instances = true, .uv_set = 1}); });
    GltfChoice nodes, materials;
    nodes.meshes = {"*"}, nodes.nodes = {"*"};
    materials.materials = {"*"};
    attempt([&] { read_mesh_of(bytes, {.choice = nodes}); });
    attempt([&] { read_mesh_of(bytes, {.choice = materials}); });
    attempt([&] { chosen_gltf_primitives(file_of(bytes), {.choice = materials}); });
    nodes.nodes = {"none"};
    attempt([&] { read_mesh_of(bytes, {.choice = nodes}); });
    attempt([&] { read_poses(bytes); });
    attempt([&] { load_gltf_scene(file_of(bytes)); });
    attempt([&] { with_types_of_gltf("a.glb", [&] { read_document(bytes); }); });
}

/// Files with what other programs put into them.
std::vector<std::string> made_files() {
    std::vector<std::string> files;
    for (const auto& [name, text] : kept_samples()) files.push_back(text);
    return files;
}

}  // namespace

std::vector<Target> gltf_targets() {
    return {{"gltf",
             read_gltf,
             Form::glb,
             {"tests/cases"},
             {"KHR_texture_transform",
              "KHR_materials_variants",
              "EXT_mesh_gpu_instancing",
              "KHR_mesh_quantization",
              "KHR_materials_clearcoat",
              "KHR_materials_ior",
              "EXT_texture_webp",
              "KHR_texture_basisu",
              "CUBICSPLINE",
              "STEP",
              "LINEAR",
              "weights",
              "translation",
              "rotation",
              "scale",
              "matrix",
              "sparse",
              "inverseBindMatrices",
              "JOINTS_0",
              "WEIGHTS_0",
              "TEXCOORD_1",
              "COLOR_0",
              "TANGENT",
              "targetNames",
              "MAT4",
              "SCALAR",
              "VEC4",
              "p64.png",
              "data:application/octet-stream;base64,AAAA"},
             32768,
             made_files}};
}

}  // namespace burl::fuzz
