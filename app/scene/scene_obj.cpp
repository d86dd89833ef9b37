// Scenes from Wavefront OBJ: the mesh of read_mesh() with the material of its library where the
// file uses one, with the extension of MTL for physically based rendering, as `burl bake` writes
// it.
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

#include "app/base/file_bytes.h"
#include "app/image/picture_read.h"
#include "app/scene/obj_material.h"
#include "app/scene/scene.h"
#include "atlas/base/error.h"
#include "atlas/file/file_buffer.h"
#include "atlas/file/text_scanner.h"
#include "atlas/read/obj_libraries.h"
#include "atlas/read/read_mesh.h"

namespace burl {

namespace {

/// The materials of a file's faces.
struct MaterialUse {
    std::vector<std::string> libraries;  ///< the names of all mtllib
    std::vector<std::string> names;      ///< the names of usemtl, by first use
    std::vector<std::uint32_t> of_face;  ///< an index into names for each face, or no_index
};

MaterialUse find_materials(const std::string& path) {
    const FileBuffer file = read_file(path);
    MaterialUse use;
    std::map<std::string, std::uint32_t> numbers;
    std::uint32_t current = no_index;
    // as the mesh is read, so that faces are the same ones
    TextScanner in(file, true, text_begin(file));
    do {
        const std::string_view keyword = in.word();
        if (keyword == "f" || keyword == "fo") use.of_face.push_back(current);
        if (keyword != "usemtl") continue;
        const std::string name = in.rest_of_line();
        const auto [found, is_new] = numbers.try_emplace(name, std::uint32_t(use.names.size()));
        current = found->second;
        if (is_new) use.names.push_back(name);
    } while (in.next_line());
    use.libraries = libraries_of(file);
    return use;
}

std::filesystem::path beside(const std::string& file, const std::string& name) {
    return std::filesystem::path(file).parent_path() / name;
}

bool file_exists(const std::filesystem::path& path) {
    std::error_code ignored;
    return std::filesystem::exists(path, ignored);
}

/// Whether the file is there and has a picture's signature that is read.
bool is_picture(const std::filesystem::path& file) {
    return file_exists(file) && is_read(picture_type(read_file_head(file.string(), 16)));
}

/// Throws Error(unsupported) for options before the file name of a map.
void check_map(const std::string& obj_path, const char* keyword, const std::string& map) {
    if (map.starts_with('-')) {
        throw Error(ExitCode::unsupported,
                    fmt::format("{}: options of {} ({}) are not supported; leave only the file "
                                "name",
                                obj_path, keyword, printable(map)));
    }
}

/// Whether alpha is that of the colours' map; a note is made of any other, which is not drawn.
bool has_own_alpha(const std::string& path, const ObjMaterial& material,
                   std::vector<std::string>& notes) {
    const std::string map = material.map("map_Kd"), alpha = material.map("map_d");
    if (alpha.empty()) return false;
    if (alpha == map || alpha == "-imfchan m " + map) return true;
    notes.push_back(fmt::format("{}: map_d {} is another file than map_Kd; drawn opaque", path,
                                printable(alpha)));
    return false;
}

/// Red of one picture as green, red of another as blue, where glTF has roughness and metallic; an
/// empty picture is white. Empty where their sizes differ.
Image<Rgb8> roughness_and_metallic(const Image<Rgb8>& roughness, const Image<Rgb8>& metallic) {
    const Image<Rgb8>& any = roughness.width() > 0 ? roughness : metallic;
    for (const Image<Rgb8>* one : {&roughness, &metallic})
        if (one->width() > 0 && (one->width() != any.width() || one->height() != any.height()))
            return {};
    Image<Rgb8> both(any.width(), any.height(), {255, 255, 255});
    for (std::size_t y = 0; y < both.height(); ++y)
        for (std::size_t x = 0; x < both.width(); ++x) {
            if (roughness.width() > 0) both(x, y).g = roughness(x, y).r;
            if (metallic.width() > 0) both(x, y).b = metallic(x, y).r;
        }
    return both;
}

/// Occlusion, roughness and metallic, as glTF packs them, from Unity's mask map: metallic,
/// occlusion, none, smoothness.
Image<Rgb8> from_mask_map(const Image<Rgb8>& mask, const Image<Grey8>& smoothness) {
    Image<Rgb8> orm(mask.width(), mask.height());
    for (std::size_t y = 0; y < orm.height(); ++y)
        for (std::size_t x = 0; x < orm.width(); ++x) {
            const std::uint8_t smooth = smoothness.width() > 0 ? smoothness(x, y) : 255;
            orm(x, y) = {mask(x, y).g, std::uint8_t(255 - smooth), mask(x, y).r};
        }
    return orm;
}

/// Loads the pictures of a material into a scene.
class ObjPictures {
  public:
    ObjPictures(const std::string& path, const ObjMaterial& material, NamedFiles named,
                Scene& scene)
        : path_(path), material_(material), named_(named), scene_(scene) {}

    /// Sets the material's textures.
    void load(SceneMaterial& look) {
        if (const std::string map = material_.map("map_Kd"); !map.empty())
            look.texture = add(read("map_Kd", map), true);
        if (look.texture >= 0 && has_own_alpha(path_, material_, scene_.notes))
            look.alpha = SceneAlpha::blend;
        look.normals = add(read_if_there("norm", "normal map"), false);
        set(look, MaterialMap::emissive, add(read_if_there("map_Ke", "picture of map_Ke"), true));
        set(look, MaterialMap::sheen, add(read_if_there("map_Ps", "picture of map_Ps"), true));
        if (look.map(MaterialMap::sheen) >= 0) look.sheen = Vec3f(1.0f);
        if (material_.packed.empty())
            load_separate(look);
        else
            load_packed(look);
    }

  private:
    static void set(SceneMaterial& look, MaterialMap map, int texture) {
        look.maps[std::size_t(map)] = texture;
    }

    /// The file from whose folder the picture is looked for: the library, or the OBJ where it is
    /// there alone.
    const std::string& base_of(const std::string& map) const {
        const bool alone =
            !file_exists(beside(material_.library, map)) && file_exists(beside(path_, map));
        return alone ? path_ : material_.library;
    }

    PictureColors read(const char* keyword, const std::string& map) {
        const std::string& base = base_of(map);
        if (!may_name(named_, base, map))
            throw invalid_file(path_, 0,
                               fmt::format("{} {} {}", keyword, printable(map), outside_rule));
        check_map(path_, keyword, map);
        scene_.files.push_back(beside(base, map).string());
        return read_picture(scene_.files.back());
    }
    /// The picture of a keyword; empty where there is none, or with a note none that can be drawn.
    PictureColors read_if_there(const char* keyword, std::string_view what) {
        const std::string map = material_.map(keyword);
        if (map.empty()) return {};
        const std::string& base = base_of(map);
        if (!may_name(named_, base, map) || is_picture(beside(base, map)))
            return read(keyword, map);
        scene_.notes.push_back(fmt::format("{}: the {} {} is no {} that is there; drawn without",
                                           path_, what, printable(map), pictures_read));
        return {};
    }

    /// Adds a texture; -1 for an empty image.
    int add(PictureColors image, bool is_color) {
        SceneTexture texture;
        std::tie(texture.image, texture.alpha) = colors_and_alpha(std::move(image));
        if (texture.image.width() == 0) return -1;
        texture.is_color = is_color;
        scene_.textures.push_back(std::move(texture));
        return int(scene_.textures.size()) - 1;
    }

    void load_separate(SceneMaterial& look) {
        const auto roughness = colors_and_alpha(read_if_there("map_Pr", "picture of map_Pr")).first,
                   metallic = colors_and_alpha(read_if_there("map_Pm", "picture of map_Pm")).first;
        if (roughness.width() == 0 && metallic.width() == 0) return;
        Image<Rgb8> both = roughness_and_metallic(roughness, metallic);
        if (both.width() == 0) {
            scene_.notes.push_back(
                fmt::format("{}: map_Pr and map_Pm differ in size; drawn without", path_));
            return;
        }
        if (roughness.width() > 0) look.roughness = 1.0f;
        if (metallic.width() > 0) look.metallic = 1.0f;
        set(look, MaterialMap::metallic_roughness, add(std::move(both), false));
    }

    /// Loads the picture that the exporter's comment names.
    void load_packed(SceneMaterial& look) {
        const std::string& name = material_.packed;
        const std::string& base = base_of(name);
        if (!may_name(named_, base, name) || !is_picture(beside(base, name))) return;
        auto [image, alpha] = colors_and_alpha(read("roughness and metallic", name));
        if (std::filesystem::path(name).stem().string().ends_with("_mask"))
            image = from_mask_map(image, alpha);
        const int texture = add(std::move(image), false);
        look.roughness = look.metallic = 1.0f;
        set(look, MaterialMap::metallic_roughness, texture);
        set(look, MaterialMap::occlusion, texture);
    }

    const std::string& path_;
    const ObjMaterial& material_;
    NamedFiles named_;
    Scene& scene_;
};

}  // namespace

Scene load_obj_scene(const std::string& path, NamedFiles named, std::uint64_t most_triangles) {
    const Mesh mesh = read_mesh(path, {.most_triangles = most_triangles});
    const MaterialUse use = find_materials(path);
    Scene pictures;
    ObjMaterials found = find_obj_materials(path, use.libraries, use.names, named, pictures.notes);
    const bool colored = !mesh.corners.colors.empty();
    SceneMaterial none;
    none.factor = colored ? Vec4f(1.0f) : default_grey;
    std::vector<SceneMaterial> looks;
    for (const std::optional<ObjMaterial>& one : found.looks) {
        looks.push_back(one ? one->look : none);
        if (one && !mesh.corners.uvs.empty())
            ObjPictures(path, *one, named, pictures).load(looks.back());
    }
    looks.push_back(none);
    std::ranges::move(found.files, std::back_inserter(pictures.files));
    std::vector<std::uint32_t> of_triangle;
    for (const std::uint32_t face : mesh.source_faces)
        of_triangle.push_back(std::min(use.of_face.at(face), std::uint32_t(use.names.size())));
    Scene scene = scene_from_mesh(mesh, looks, of_triangle);
    scene.textures = std::move(pictures.textures);
    scene.files = std::move(pictures.files);
    scene.notes = std::move(pictures.notes);
    return scene;
}

}  // namespace burl
