// Reads glTF and GLB: every mesh the default scene draws, with its nodes' transforms baked in. The
// mesh's first place gives the space of its points; further places become instances, or copies on
// request.
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "atlas/base/error.h"
#include "atlas/file/text_scanner.h"
#include "atlas/gltf/choice.h"
#include "atlas/gltf/document.h"
#include "atlas/gltf/pose.h"
#include "atlas/gltf/primitive.h"
#include "atlas/gltf/scene.h"
#include "atlas/read/gltf_origins.h"
#include "atlas/read/readers.h"

namespace burl {
namespace {

bool invertible(const Mat4d& matrix) {
    const Mat4d inverse = glm::inverse(matrix);
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            if (!std::isfinite(inverse[c][r])) return false;
    return glm::determinant(Mat3d(matrix)) != 0.0;
}

/// Bounding box of the part's points; the zero box for a part without faces.
Box3 box_of_part(const PolygonSoup& soup, const SoupPart& part) {
    if (part.face_count == 0) return {};
    const auto corners = std::span(soup.corners).subspan(3 * part.first_face, 3 * part.face_count);
    Box3 box{soup.points[corners.front()], soup.points[corners.front()]};
    for (const std::uint32_t corner : corners) {
        box.low = glm::min(box.low, soup.points[corner]);
        box.high = glm::max(box.high, soup.points[corner]);
    }
    return box;
}

/// Whether every corner of the box moved by `placement` is within largest_coordinate.
bool lies_in_range(const Box3& box, const Mat4d& placement) {
    for (const double x : {box.low.x, box.high.x})
        for (const double y : {box.low.y, box.high.y})
            for (const double z : {box.low.z, box.high.z}) {
                const Vec3d p(placement * Vec4d(x, y, z, 1.0));
                for (int k = 0; k < 3; ++k)
                    if (!(std::abs(p[k]) <= largest_coordinate)) return false;
            }
    return true;
}

/// Reads the meshes that a scene draws, at rest or in a pose.
class SceneReader {
  public:
    /// `pose` says where the scene's vertices are; null: at rest. Parts and instances are those at
    /// rest. `origins`, unless null, gets the places of all triangles in the file.
    SceneReader(const tinygltf::Model& model, const std::string& path, const ReadOptions& options,
                const GltfPose* pose = nullptr, GltfOrigins* origins = nullptr)
        : model_(model),
          path_(path),
          options_(options),
          pose_(pose),
          origins_(origins),
          chosen_(model, options.choice, path) {
        if (pose_) posed_to_scene_ = scene_transforms(model_, pose_->nodes.local);
    }

    PolygonSoup read() {
        const std::vector<GltfPlacement> placements = chosen_.of(scene_placements(model_));
        for (const GltfPlacement& placement : placements) read_placement(placement);
        fill_attributes(soup_);
        count_what_is_not_chosen(placements);
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
            read_copy(placement, i);
        }
        if (!share || soup_.parts.empty()) return;
        const Mat4d from_first = glm::inverse(first);
        for (std::size_t i = 1; i < placement.to_scene.size(); ++i)
            soup_.parts.back().instances.push_back(placement.to_scene[i] * from_first);
        if (placement.to_scene.size() > 1) check_instances(placement);
    }

    /// Throws Error(invalid_file) where an instance of the last part leaves largest_coordinate.
    void check_instances(const GltfPlacement& placement) const {
        const SoupPart& part = soup_.parts.back();
        const Box3 box = box_of_part(soup_, part);
        for (std::size_t i = 1; i < part.instances.size(); ++i)
            if (!lies_in_range(box, part.instances[i]))
                throw invalid_file(path_, 0,
                                   fmt::format("nodes[{}]: the positions of its mesh are not "
                                               "finite, or beyond 1e100, in the scene",
                                               placement.nodes[i]));
    }

    MeshPlace place(const GltfPlacement& placement, std::size_t number) const {
        const Mat4d& to_scene = placement.to_scene[number];
        MeshPlace result{to_scene, glm::determinant(Mat3d(to_scene)) < 0.0};
        result.uv_set = options_.uv_set;
        if (!pose_) return result;
        const int node = placement.nodes[number];
        result.target_weights = pose_->target_weights(model_, placement.mesh, node);
        if (placement.skin < 0)
            result.to_scene = posed_to_scene_[static_cast<std::size_t>(node)];
        else if (pose_->skinned)
            result.joints = joint_matrices(model_, placement.skin, posed_to_scene_, path_);
        return result;
    }

    /// Appends the mesh, moved to the scene by node `number` of its placement, as one part.
    void read_copy(const GltfPlacement& placement, std::size_t number) {
        const tinygltf::Mesh& mesh = model_.meshes[static_cast<std::size_t>(placement.mesh)];
        const std::size_t first = soup_.face_count();
        PrimitiveReader reader(model_, path_, place(placement, number), soup_);
        for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
            if (!chosen_.has(placement.mesh, p)) continue;
            const std::size_t start = soup_.corners.size();
            reader.append(mesh.primitives[p],
                          fmt::format("meshes[{}].primitives[{}]", placement.mesh, p));
            if (origins_) note_origins(int(p), start, reader.first_point());
        }
        if (origins_) note_origins(placement, number);
        stitches_ += reader.stitches();
        if (soup_.face_count() > options_.most_triangles)
            throw Error(ExitCode::unsupported,
                        fmt::format("{}: more than {} triangles (--max-triangles), instances "
                                    "included; split the scene, or allow more",
                                    path_, options_.most_triangles));
        const std::size_t count = soup_.face_count() - first;
        for (std::size_t i = 0; i < count; ++i) soup_.source_faces.push_back(next_face_number_++);
        soup_.parts.push_back({gltf_mesh_name(model_, placement.mesh), first, count, {Mat4d(1.0)}});
    }

    /// Notes the triangles that a primitive has appended, from soup corner `start` on.
    void note_origins(int primitive, std::size_t start, std::uint32_t first_point) {
        const std::size_t end = soup_.corners.size();
        if (end == start) return;
        origins_->runs.push_back({origins_->parts.size(), primitive, start / 3, (end - start) / 3});
        for (std::size_t c = start; c < end; ++c)
            origins_->vertices.push_back(soup_.corners[c] - first_point);
    }

    /// Notes the part that read_copy() has appended.
    void note_origins(const GltfPlacement& placement, std::size_t number) {
        const Mat4d& to_scene = placement.to_scene[number];
        const bool shares = !options_.unshare_instances && invertible(placement.to_scene.front());
        origins_->parts.push_back(
            {placement.mesh, shares ? placement.nodes : std::vector<int>{placement.nodes[number]},
             to_scene, glm::determinant(Mat3d(to_scene)) < 0.0});
        origins_->drops_nodes = chosen_.drops_nodes();
    }

    /// Counts triangles of the scene's primitives that the choice leaves out, those of every node.
    void count_what_is_not_chosen(const std::vector<GltfPlacement>& placements) {
        if (!options_.choice.any()) return;
        std::uint64_t all = 0, chosen = 0;
        for (const GltfPlacement& placement : scene_placements(model_))
            all += placement.nodes.size() * triangles_of(placement.mesh, false);
        for (const GltfPlacement& placement : placements)
            chosen += placement.nodes.size() * triangles_of(placement.mesh, true);
        soup_.notes.unchosen_triangles = all - chosen;
    }

    /// The number of triangles of a mesh, or of its chosen primitives.
    std::uint64_t triangles_of(int mesh, bool chosen) const {
        std::uint64_t sum = 0;
        const auto& primitives = model_.meshes[std::size_t(mesh)].primitives;
        for (std::size_t p = 0; p < primitives.size(); ++p)
            if (!chosen || chosen_.has(mesh, p)) sum += gltf_triangles(model_, primitives[p]);
        return sum;
    }

    void say_what_is_missing(const std::vector<GltfPlacement>& placements) {
        std::vector<bool> drawn(model_.meshes.size(), false);
        for (const GltfPlacement& placement : placements)
            drawn[static_cast<std::size_t>(placement.mesh)] = true;
        const auto unused = std::count(drawn.begin(), drawn.end(), false);
        auto& say = soup_.notes.sentences;
        if (unused > 0 && !options_.choice.any())
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
    const GltfPose* pose_;
    GltfOrigins* origins_;
    ChosenGltf chosen_;
    std::vector<Mat4d> posed_to_scene_;  ///< transforms of the nodes to the scene, posed
    PolygonSoup soup_;
    std::uint32_t next_face_number_ = 0;
    std::uint64_t stitches_ = 0;
};

}  // namespace

PolygonSoup parse_gltf(const FileBuffer& file, const ReadOptions& options) {
    const tinygltf::Model model = load_gltf(file);
    return SceneReader(model, file.path, options).read();
}

PolygonSoup parse_gltf_pose(const FileBuffer& file, const std::string& pose,
                            const ReadOptions& options) {
    const tinygltf::Model model = load_gltf(file);
    const GltfPose found = find_pose(model, pose, file.path);
    return SceneReader(model, file.path, options, &found).read();
}

GltfOrigins read_gltf_origins(const FileBuffer& file, const ReadOptions& options) {
    const tinygltf::Model model = load_gltf(file);
    GltfOrigins origins;
    SceneReader(model, file.path, options, nullptr, &origins).read();
    return origins;
}

std::vector<GltfPrimitive> chosen_gltf_primitives(const FileBuffer& file,
                                                  const ReadOptions& options) {
    const tinygltf::Model model = load_gltf(file);
    const ChosenGltf chosen(model, options.choice, file.path);
    std::vector<GltfPrimitive> primitives;
    for (const GltfPlacement& placement : chosen.of(scene_placements(model))) {
        const auto& all = model.meshes[std::size_t(placement.mesh)].primitives;
        for (std::size_t p = 0; p < all.size(); ++p) {
            const bool triangles = all[p].mode < 0 || all[p].mode >= TINYGLTF_MODE_TRIANGLES;
            if (!triangles || !chosen.has(placement.mesh, p)) continue;
            primitives.push_back({placement.mesh, int(p), gltf_mesh_name(model, placement.mesh),
                                  gltf_material_name(model, all[p].material)});
        }
    }
    const auto id = [](const GltfPrimitive& one) { return std::pair(one.mesh, one.primitive); };
    std::ranges::sort(primitives, {}, id);
    const auto repeated = std::ranges::unique(primitives, {}, id);
    primitives.erase(repeated.begin(), repeated.end());
    return primitives;
}

}  // namespace burl
