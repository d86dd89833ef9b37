// glTF and GLB: every mesh the default scene draws, with its nodes' transforms baked in. The mesh's
// first place gives the space of its points; further places become instances, or copies on request.
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "atlas/error.h"
#include "atlas/gltf_accessor.h"
#include "atlas/gltf_document.h"
#include "atlas/gltf_primitive.h"
#include "atlas/gltf_scene.h"
#include "atlas/gltf_targets.h"
#include "atlas/mesh_readers.h"
#include "atlas/text_scanner.h"

namespace burl {
namespace {

bool invertible(const Mat4d& matrix) {
    const Mat4d inverse = glm::inverse(matrix);
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            if (!std::isfinite(inverse[c][r])) return false;
    return glm::determinant(Mat3d(matrix)) != 0.0;
}

std::string name_of(const tinygltf::Model& model, int mesh) {
    const std::string& name = model.meshes[static_cast<std::size_t>(mesh)].name;
    return name.empty() ? fmt::format("mesh {}", mesh) : name;
}

class SceneReader {
  public:
    /// `target`: the morph target that is applied; empty: none.
    SceneReader(const tinygltf::Model& model, const std::string& path, const ReadOptions& options,
                std::string target = {})
        : model_(model), path_(path), options_(options), target_(std::move(target)) {}

    PolygonSoup read() {
        const std::vector<GltfPlacement> placements = scene_placements(model_);
        for (const GltfPlacement& placement : placements) read_placement(placement);
        fill_attributes(soup_);
        say_what_is_missing(placements);
        return std::move(soup_);
    }

  private:
    void read_placement(const GltfPlacement& placement) {
        const Mat4d& first = placement.to_scene.front();
        const bool share = !options_.unshare_instances && invertible(first);
        const std::size_t copies = share ? 1 : placement.to_scene.size();
        const std::uint32_t first_number = next_face_number_;
        for (std::size_t i = 0; i < copies; ++i) {
            next_face_number_ = first_number;
            read_copy(placement, placement.to_scene[i]);
        }
        if (!share || soup_.parts.empty()) return;
        const Mat4d from_first = glm::inverse(first);
        for (std::size_t i = 1; i < placement.to_scene.size(); ++i)
            soup_.parts.back().instances.push_back(placement.to_scene[i] * from_first);
    }

    /// Appends one Part: the mesh, moved to the scene.
    void read_copy(const GltfPlacement& placement, const Mat4d& to_scene) {
        const tinygltf::Mesh& mesh = model_.meshes[static_cast<std::size_t>(placement.mesh)];
        const std::size_t first = soup_.face_count();
        PrimitiveReader reader(
            model_, path_, to_scene, soup_,
            target_.empty() ? std::optional<std::size_t>() : find_target(mesh, target_));
        for (std::size_t p = 0; p < mesh.primitives.size(); ++p)
            reader.append(mesh.primitives[p],
                          fmt::format("meshes[{}].primitives[{}]", placement.mesh, p));
        stitches_ += reader.stitches();
        const std::size_t count = soup_.face_count() - first;
        for (std::size_t i = 0; i < count; ++i) soup_.source_faces.push_back(next_face_number_++);
        soup_.parts.push_back({name_of(model_, placement.mesh), first, count, {Mat4d(1.0)}});
    }

    void say_what_is_missing(const std::vector<GltfPlacement>& placements) {
        std::vector<bool> drawn(model_.meshes.size(), false);
        for (const GltfPlacement& placement : placements)
            drawn[static_cast<std::size_t>(placement.mesh)] = true;
        const auto unused = std::count(drawn.begin(), drawn.end(), false);
        auto& say = soup_.notes.sentences;
        if (unused > 0)
            say.push_back(fmt::format("{} meshes are not in the default scene; left out", unused));
        if (stitches_ > 0)
            say.push_back(fmt::format(
                "{} triangles that only stitch strips together (repeated index) left out",
                stitches_));
        for (const tinygltf::Node& node : model_.nodes)
            if (node.extensions.contains("EXT_mesh_gpu_instancing")) {
                say.push_back(
                    "EXT_mesh_gpu_instancing is not supported; one instance per node is read");
                break;
            }
    }

    const tinygltf::Model& model_;
    const std::string& path_;
    const ReadOptions& options_;
    std::string target_;
    PolygonSoup soup_;
    std::uint32_t next_face_number_ = 0;
    std::uint64_t stitches_ = 0;
};

}  // namespace

PolygonSoup parse_gltf(const FileBuffer& file, const ReadOptions& options) {
    const tinygltf::Model model = load_gltf(file);
    return SceneReader(model, file.path, options).read();
}

PolygonSoup parse_gltf_target(const FileBuffer& file, const std::string& target,
                              const ReadOptions& options) {
    const tinygltf::Model model = load_gltf(file);
    const std::vector<std::string> names = target_names(model);
    if (std::ranges::find(names, target) == names.end())
        throw Error(ExitCode::usage,
                    names.empty()
                        ? fmt::format("{}: there is no morph target \"{}\", nor any other one",
                                      file.path, target)
                        : fmt::format("{}: there is no morph target \"{}\"; those of the file are "
                                      "{}",
                                      file.path, target, fmt::join(names, ", ")));
    return SceneReader(model, file.path, options, target).read();
}

}  // namespace burl
