// Scenes from glTF: the primitives of the default scene, with their metallic-roughness materials
// (specification 3.9.2).
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <string_view>

#include "app/scene/gltf_material.h"
#include "app/scene/gltf_textures.h"
#include "app/scene/scene.h"
#include "atlas/base/error.h"
#include "atlas/file/text_scanner.h"
#include "atlas/gltf/accessor.h"
#include "atlas/gltf/container.h"
#include "atlas/gltf/document.h"
#include "atlas/gltf/motion.h"
#include "atlas/gltf/pose.h"
#include "atlas/gltf/primitive.h"
#include "atlas/gltf/scene.h"

namespace burl {

namespace {

class GltfSceneLoader {
  public:
    /// `pose` may be null: as the file stores nodes and weights.
    GltfSceneLoader(const tinygltf::Model& model, const FileBuffer& file, const GltfPose* pose,
                    std::uint64_t most_triangles)
        : model_(model),
          path_(file.path),
          pose_(pose),
          most_triangles_(most_triangles),
          to_scene_(scene_transforms(model, pose ? pose->nodes.local : nodes_at_rest(model).local)),
          textures_(model, file.path, file.named, scene_.textures) {}

    Scene load() {
        for (const GltfPlacement& placement : scene_placements(model_, to_scene_)) {
            const auto& primitives = model_.meshes[std::size_t(placement.mesh)].primitives;
            for (std::size_t p = 0; p < primitives.size(); ++p) {
                add_surface(primitives[p], placement,
                            fmt::format("meshes[{}].primitives[{}]", placement.mesh, p));
            }
        }
        return std::move(scene_);
    }

  private:
    void add_surface(const tinygltf::Primitive& primitive, const GltfPlacement& placement,
                     const std::string& where) {
        PolygonSoup soup;
        PrimitiveReader reader(model_, path_, shape(placement), soup);
        reader.append(primitive, where);
        fill_attributes(soup);
        if (soup.corners.empty()) return;
        count_triangles(soup.corners.size() / 3 * placement.to_scene.size());
        Surface surface;
        surface.placements = placement.to_scene;
        surface.positions = std::move(soup.points);
        surface.normals = std::move(soup.normals.values);
        surface.uvs = std::move(soup.uvs.values);
        surface.colors = std::move(soup.colors.values);
        for (std::size_t i = 0; i < soup.corners.size(); i += 3) {
            surface.triangles.push_back(
                {soup.corners[i], soup.corners[i + 1], soup.corners[i + 2]});
        }
        // The rectangles that Burl writes for quad atlases; tangents that are missing are computed
        // where a normal map needs them.
        surface.blocks = read_vec4(primitive, "_BURL_BLOCK", surface.positions.size());
        if (!pose_) {
            surface.tangents = read_vec4(primitive, "TANGENT", surface.positions.size());
            set_target(surface, primitive, weights_of(placement), where);
        }
        // What glTF says of a primitive without a material.
        surface.material.metallic = surface.material.roughness = 1.0f;
        if (primitive.material >= 0) set_material(surface, primitive, where);
        if (surface.normals.empty()) make_flat(surface);
        if (surface.material.normals >= 0 && surface.tangents.empty()) add_tangents(surface);
        scene_.surfaces.push_back(std::move(surface));
    }

    /// Throws Error(unsupported) where the scene has too many triangles with these.
    void count_triangles(std::uint64_t more) {
        triangles_ += more;
        if (triangles_ > most_triangles_)
            throw Error(ExitCode::unsupported,
                        fmt::format("{}: more than {} triangles to draw (--max-triangles), "
                                    "instances included; split the scene, or allow more",
                                    path_, most_triangles_));
    }

    /// The shape of the mesh, in its own space, or where its skin takes it.
    MeshPlace shape(const GltfPlacement& placement) const {
        MeshPlace place;
        if (!pose_) return place;
        place.target_weights =
            pose_->target_weights(model_, placement.mesh, placement.nodes.front());
        if (placement.skin >= 0 && pose_->skinned)
            place.joints = joint_matrices(model_, placement.skin, to_scene_, path_);
        return place;
    }

    /// An attribute of four components per vertex; empty where there is none of that name, or one
    /// of another form.
    std::vector<Vec4f> read_vec4(const tinygltf::Primitive& primitive, const char* name,
                                 std::size_t vertices) const {
        const auto found = primitive.attributes.find(name);
        if (found == primitive.attributes.end()) return {};
        const AccessorValues values = read_accessor(model_, found->second);
        if (values.components != 4 || values.count() != vertices) return {};
        std::vector<Vec4f> result;
        for (std::size_t i = 0; i < values.count(); ++i) {
            const double* v = values[i];
            result.emplace_back(float(v[0]), float(v[1]), float(v[2]), float(v[3]));
        }
        return result;
    }

    /// The weights of the mesh's morph targets: those of the first node placing it that has some,
    /// else the mesh's own; may be empty.
    const std::vector<double>& weights_of(const GltfPlacement& placement) const {
        for (const int node : placement.nodes)
            if (const auto& own = model_.nodes[std::size_t(node)].weights; !own.empty()) return own;
        return model_.meshes[std::size_t(placement.mesh)].weights;
    }

    /// Sets the surface's target: a single morph target keeps its weight as target_share, several
    /// are summed by their weights into one.
    void set_target(Surface& surface, const tinygltf::Primitive& primitive,
                    std::vector<double> weights, const std::string& where) const {
        weights.resize(primitive.targets.size());
        const bool one = weights.size() == 1;
        if (!one && std::ranges::all_of(weights, [](double w) { return w == 0.0; })) return;
        surface.target_share = one ? weights[0] : 1.0;
        for (std::size_t i = 0; i < weights.size(); ++i)
            add_target(surface, primitive.targets[i], one ? 1.0 : weights[i], where);
    }

    void add_target(Surface& surface, const std::map<std::string, int>& target, double weight,
                    const std::string& where) const {
        const auto add = [&](const char* name, auto& sums, bool wanted) {
            const auto found = target.find(name);
            if (!wanted || found == target.end()) return;
            const AccessorValues values = read_accessor(model_, found->second);
            if (values.components != 3 || values.count() != surface.positions.size())
                throw invalid_file(
                    path_, 0,
                    fmt::format("{}: {} of a morph target has a wrong type or count", where, name));
            using Value = std::decay_t<decltype(sums[0])>;
            sums.resize(values.count(), Value(0));
            for (std::size_t i = 0; i < values.count(); ++i)
                sums[i] += Value(weight * Vec3d(values[i][0], values[i][1], values[i][2]));
        };
        add("POSITION", surface.target.positions, true);
        add("NORMAL", surface.target.normals, !surface.normals.empty());
        add("TANGENT", surface.target.tangents, !surface.tangents.empty());
        for (const Vec3d& change : surface.target.positions)
            for (int k = 0; k < 3; ++k)
                if (!(std::abs(change[k]) <= largest_coordinate))
                    throw invalid_file(path_, 0,
                                       fmt::format("{}: a morph target moves a vertex by what is "
                                                   "not finite, or beyond 1e100",
                                                   where));
    }

    /// Sets the material's normal map. A map that cannot be drawn is left out with a note, since
    /// the surface still has its colour.
    void set_normal_map(Surface& surface, const tinygltf::NormalTextureInfo& info, int uv_set,
                        const std::string& where) {
        const auto leave_out = [&](std::string_view why) {
            scene_.notes.push_back(
                fmt::format("{}: the normal map of {} {}; drawn without", path_, where, why));
        };
        if (info.extensions.contains("KHR_texture_transform"))
            return leave_out("uses KHR_texture_transform");
        // Coordinates of another set are read with the colour.
        if (info.texCoord != uv_set ||
            (uv_set == 0 && surface.uvs.size() != surface.positions.size()))
            return leave_out("has other texture coordinates than the colour");
        if (!textures_.has_picture(info.index))
            return leave_out("is no PNG, JPEG or WebP that is there");
        surface.material.normals = textures_.load(info.index, false);
        surface.material.normal_scale = float(info.scale);
    }

    void set_material(Surface& surface, const tinygltf::Primitive& primitive,
                      const std::string& where) {
        const tinygltf::Material& material = model_.materials[std::size_t(primitive.material)];
        const auto& factor = material.pbrMetallicRoughness.baseColorFactor;
        for (std::size_t k = 0; k < 4 && factor.size() == 4; ++k) {
            surface.material.factor[int(k)] = float(factor[k]);
        }
        if (material.alphaMode == "MASK") surface.material.alpha = SceneAlpha::mask;
        if (material.alphaMode == "BLEND") surface.material.alpha = SceneAlpha::blend;
        surface.material.alpha_cutoff = float(material.alphaCutoff);
        const tinygltf::TextureInfo& info = material.pbrMetallicRoughness.baseColorTexture;
        if (material.normalTexture.index >= 0)
            set_normal_map(surface, material.normalTexture, info.texCoord, where);
        if (info.index >= 0) set_base_color(surface, primitive, info, where);
        const int uv_set = surface.uvs.size() == surface.positions.size() ? info.texCoord : -1;
        read_gltf_material(
            material,
            {textures_, uv_set, fmt::format("{}: materials[{}]", path_, primitive.material),
             scene_.notes},
            surface.material);
    }

    void set_base_color(Surface& surface, const tinygltf::Primitive& primitive,
                        const tinygltf::TextureInfo& info, const std::string& where) {
        if (info.extensions.contains("KHR_texture_transform")) {
            throw Error(ExitCode::unsupported,
                        fmt::format("{}: {} uses KHR_texture_transform, which is not drawn; apply "
                                    "the transform to the UVs",
                                    path_, where));
        }
        surface.material.texture = textures_.load(info.index, true);
        if (info.texCoord != 0) surface.uvs = texture_coordinates(primitive, info, where);
        if (surface.uvs.size() != surface.positions.size()) {
            throw invalid_file(path_, 0,
                               fmt::format("{}: its material has a texture, but the primitive has "
                                           "no TEXCOORD_{}",
                                           where, info.texCoord));
        }
    }

    std::vector<Vec2d> texture_coordinates(const tinygltf::Primitive& primitive,
                                           const tinygltf::TextureInfo& info,
                                           const std::string& where) {
        std::vector<Vec2d> uvs;
        const auto found = primitive.attributes.find(fmt::format("TEXCOORD_{}", info.texCoord));
        if (found == primitive.attributes.end()) return uvs;
        const AccessorValues values = read_accessor(model_, found->second);
        if (values.components != 2) {
            throw invalid_file(path_, 0,
                               fmt::format("{}: {} has a wrong type", where, found->first));
        }
        for (std::size_t i = 0; i < values.count(); ++i) {
            uvs.emplace_back(values[i][0], values[i][1]);
        }
        return uvs;
    }

    /// Gives every triangle vertices of its own with its face normal, as glTF requires where a
    /// primitive has no normals.
    static void make_flat(Surface& surface) {
        Surface flat;
        flat.material = surface.material;
        flat.placements = std::move(surface.placements);
        flat.target_share = surface.target_share;
        for (const Triangle& t : surface.triangles) {
            const Vec3d& a = surface.positions[t[0]];
            const Vec3d n = glm::cross(surface.positions[t[1]] - a, surface.positions[t[2]] - a);
            const double length = glm::length(n);
            const auto first = std::uint32_t(flat.positions.size());
            flat.triangles.push_back({first, first + 1, first + 2});
            for (const std::uint32_t i : t) {
                flat.positions.push_back(surface.positions[i]);
                flat.normals.push_back(length > 0.0 ? Vec3f(n / length) : Vec3f(0.0f));
                if (!surface.uvs.empty()) flat.uvs.push_back(surface.uvs[i]);
                if (!surface.colors.empty()) flat.colors.push_back(surface.colors[i]);
                if (!surface.blocks.empty()) flat.blocks.push_back(surface.blocks[i]);
                if (!surface.target.positions.empty())
                    flat.target.positions.push_back(surface.target.positions[i]);
            }
        }
        surface = std::move(flat);
    }

    const tinygltf::Model& model_;
    const std::string& path_;
    const GltfPose* pose_;
    std::uint64_t most_triangles_, triangles_ = 0;
    std::vector<Mat4d> to_scene_;  ///< transforms of all nodes to the scene
    Scene scene_;
    GltfTextures textures_;
};

std::vector<std::string> files_beside(const tinygltf::Model& model, const FileBuffer& file) {
    std::vector<std::string> files;
    const auto add = [&](const std::string& uri) {
        if (uri.empty() || is_data_uri(uri)) return;
        const auto folder = std::filesystem::path(file.path).parent_path();
        files.push_back((folder / confined_file_name(uri, file.named)).string());
    };
    for (const tinygltf::Buffer& buffer : model.buffers) add(buffer.uri);
    for (const tinygltf::Image& image : model.images) add(image.uri);
    return files;
}

}  // namespace

Scene load_gltf_scene(const FileBuffer& file, const std::string& pose,
                      std::uint64_t most_triangles) {
    const tinygltf::Model model = load_gltf(file);
    std::optional<GltfPose> found;
    if (!pose.empty()) found = find_pose(model, pose, file.path);
    Scene scene = GltfSceneLoader(model, file, found ? &*found : nullptr, most_triangles).load();
    scene.files = files_beside(model, file);
    return scene;
}

}  // namespace burl
