// Scenes from glTF: the primitives of the default scene, with base colour factors and PNG textures
// of the metallic-roughness materials (specification 3.9.2).
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string_view>
#include <tuple>

#include "app/image/image_io.h"
#include "app/scene/scene.h"
#include "atlas/base/error.h"
#include "atlas/file/text_scanner.h"
#include "atlas/gltf/accessor.h"
#include "atlas/gltf/container.h"
#include "atlas/gltf/document.h"
#include "atlas/gltf/primitive.h"
#include "atlas/gltf/scene.h"

namespace burl {

namespace {

TextureFilter filter_of(const tinygltf::Sampler& sampler) {
    switch (sampler.minFilter) {
        case TINYGLTF_TEXTURE_FILTER_NEAREST:
            return TextureFilter::nearest;
        case TINYGLTF_TEXTURE_FILTER_LINEAR:
            return TextureFilter::linear;
        case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST:
        case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST:
        case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR:
        case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR:
            return TextureFilter::mip;
        default:
            break;
    }
    return sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST ? TextureFilter::nearest
                                                                : TextureFilter::linear;
}

TextureWrap wrap_of(int wrap) {
    if (wrap == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return TextureWrap::clamp;
    return wrap == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? TextureWrap::mirror
                                                         : TextureWrap::repeat;
}

/// The format of encoded image bytes, from their signature.
std::string_view image_type(const std::vector<unsigned char>& bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (text.starts_with("\x89PNG\r\n\x1a\n")) return "PNG";
    if (text.starts_with("\xff\xd8\xff")) return "JPEG";
    if (text.starts_with("RIFF") &&
        text.substr(std::min<std::size_t>(8, text.size())).starts_with("WEBP"))
        return "WebP";
    if (text.starts_with("\xabKTX ")) return "KTX";
    return "of unknown type";
}

class GltfSceneLoader {
  public:
    GltfSceneLoader(const tinygltf::Model& model, const std::string& path)
        : model_(model), path_(path) {}

    Scene load() {
        for (const GltfPlacement& placement : scene_placements(model_)) {
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
        PrimitiveReader reader(model_, path_, {}, soup);
        reader.append(primitive, where);
        fill_attributes(soup);
        if (soup.corners.empty()) return;
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
        surface.tangents = read_vec4(primitive, "TANGENT", surface.positions.size());
        set_target(surface, primitive, weights_of(placement), where);
        if (primitive.material >= 0) set_material(surface, primitive, where);
        if (surface.normals.empty()) make_flat(surface);
        if (surface.material.normals >= 0 && surface.tangents.empty()) add_tangents(surface);
        scene_.surfaces.push_back(std::move(surface));
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
    void set_normal_map(Surface& surface, const tinygltf::NormalTextureInfo& info,
                        const std::string& where) {
        const auto leave_out = [&](std::string_view why) {
            scene_.notes.push_back(
                fmt::format("{}: the normal map of {} {}; drawn without", path_, where, why));
        };
        if (info.extensions.contains("KHR_texture_transform"))
            return leave_out("uses KHR_texture_transform");
        if (info.texCoord != 0 || surface.uvs.size() != surface.positions.size())
            return leave_out("has other texture coordinates than TEXCOORD_0");
        const int source = model_.textures[std::size_t(info.index)].source;
        if (source < 0 || image_type(model_.images[std::size_t(source)].image) != "PNG")
            return leave_out("is not a PNG that is there");
        surface.material.normals = texture(info.index, false);
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
        if (material.normalTexture.index >= 0)
            set_normal_map(surface, material.normalTexture, where);
        const tinygltf::TextureInfo& info = material.pbrMetallicRoughness.baseColorTexture;
        if (info.index < 0) return;
        if (info.extensions.contains("KHR_texture_transform")) {
            throw Error(ExitCode::unsupported,
                        fmt::format("{}: {} uses KHR_texture_transform, which is not drawn; apply "
                                    "the transform to the UVs",
                                    path_, where));
        }
        surface.material.texture = texture(info.index, true);
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

    /// The index in the scene of a glTF texture, loaded at its first use as colour or as data.
    int texture(int number, bool is_color) {
        const auto [entry, is_new] =
            loaded_.try_emplace({number, is_color}, int(scene_.textures.size()));
        if (!is_new) return entry->second;
        const tinygltf::Texture& source = model_.textures[std::size_t(number)];
        SceneTexture texture;
        texture.is_color = is_color;
        std::tie(texture.image, texture.alpha) = colors_and_alpha(image(source.source));
        add_levels(texture, source);
        if (source.sampler >= 0) {
            const tinygltf::Sampler& sampler = model_.samplers[std::size_t(source.sampler)];
            texture.filter = filter_of(sampler);
            texture.wrap_u = wrap_of(sampler.wrapS);
            texture.wrap_v = wrap_of(sampler.wrapT);
        }
        scene_.textures.push_back(std::move(texture));
        return entry->second;
    }

    /// Adds the MIP levels that Burl wrote beside the texture, up to the first of a wrong size.
    void add_levels(SceneTexture& texture, const tinygltf::Texture& source) {
        if (!source.extras.IsObject() || !source.extras.Has("burl_levels")) return;
        const tinygltf::Value& numbers = source.extras.Get("burl_levels");
        std::size_t width = texture.image.width(), height = texture.image.height();
        for (std::size_t i = 0; numbers.IsArray() && i < numbers.ArrayLen(); ++i) {
            const tinygltf::Value& number = numbers.Get(int(i));
            if (!number.IsInt() || number.GetNumberAsInt() < 0 ||
                std::size_t(number.GetNumberAsInt()) >= model_.images.size())
                return;
            auto [level, alpha] = colors_and_alpha(image(number.GetNumberAsInt()));
            width = std::max<std::size_t>(1, width / 2);
            height = std::max<std::size_t>(1, height / 2);
            if (level.width() != width || level.height() != height) return;
            texture.levels.push_back(std::move(level));
            if (texture.alpha.width() > 0) texture.alpha_levels.push_back(std::move(alpha));
        }
    }

    PngColors image(int number) {
        const std::string where = fmt::format("images[{}]", number);
        if (number < 0) {
            throw Error(
                ExitCode::unsupported,
                fmt::format("{}: a texture has no PNG image; export it with PNG textures", path_));
        }
        const tinygltf::Image& image = model_.images[std::size_t(number)];
        if (image.image.empty()) {
            throw Error(ExitCode::io,
                        fmt::format("{}: the texture '{}' is not there; put it beside the file",
                                    path_, printable(image.uri)));
        }
        if (const std::string_view type = image_type(image.image); type != "PNG") {
            throw Error(ExitCode::unsupported,
                        fmt::format("{}: {} is {}; convert it to PNG", path_, where, type));
        }
        return decode_png_with_alpha(image.image, fmt::format("{}: {}", path_, where));
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
    Scene scene_;
    /// Scene textures by glTF texture and use as colour.
    std::map<std::pair<int, bool>, int> loaded_;
};

std::vector<std::string> files_beside(const tinygltf::Model& model, const std::string& path) {
    std::vector<std::string> files;
    const auto add = [&](const std::string& uri) {
        if (uri.empty() || is_data_uri(uri)) return;
        const auto folder = std::filesystem::path(path).parent_path();
        files.push_back((folder / confined_file_name(uri)).string());
    };
    for (const tinygltf::Buffer& buffer : model.buffers) add(buffer.uri);
    for (const tinygltf::Image& image : model.images) add(image.uri);
    return files;
}

}  // namespace

Scene load_gltf_scene(const FileBuffer& file) {
    const tinygltf::Model model = load_gltf(file);
    Scene scene = GltfSceneLoader(model, file.path).load();
    scene.files = files_beside(model, file.path);
    return scene;
}

}  // namespace burl
