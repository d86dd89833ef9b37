// Scenes from Wavefront OBJ: the mesh of read_mesh() with the material of its library where the
// file uses one, with the extension of MTL for physically based rendering, as `burl bake` writes
// it.
#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <tuple>
#include <utility>

#include "app/base/file_bytes.h"
#include "app/image/picture_read.h"
#include "app/scene/scene.h"
#include "atlas/base/error.h"
#include "atlas/file/file_buffer.h"
#include "atlas/file/text_scanner.h"
#include "atlas/read/read_mesh.h"

namespace burl {

namespace {

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

/// Calls visit(keyword, rest of the line) for every line, comments included.
template <class Visit>
void for_each_line(std::string_view text, Visit visit) {
    while (!text.empty()) {
        const std::string_view line = trimmed(text.substr(0, text.find('\n')));
        const std::size_t space = std::min(line.find_first_of(" \t"), line.size());
        visit(line.substr(0, space), trimmed(line.substr(space)));
        text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    }
}

/// The materials of a file's faces.
struct MaterialUse {
    std::string library;                 ///< the file name of the last mtllib; empty: none
    std::vector<std::string> names;      ///< the names of usemtl, by first use
    std::vector<std::uint32_t> of_face;  ///< an index into names for each face, or no_index
};

MaterialUse find_materials(const std::string& path) {
    const FileBuffer file = read_file(path);
    MaterialUse use;
    std::map<std::string, std::uint32_t> numbers;
    std::uint32_t current = no_index;
    TextScanner in(file, true);  // as the mesh is read, so that faces are the same ones
    do {
        const std::string_view keyword = in.word(), rest = in.rest_of_line();
        if (keyword == "mtllib") use.library = rest;
        if (keyword == "f" || keyword == "fo") use.of_face.push_back(current);
        if (keyword != "usemtl") continue;
        const auto [found, is_new] =
            numbers.try_emplace(std::string(rest), std::uint32_t(use.names.size()));
        current = found->second;
        if (is_new) use.names.emplace_back(rest);
    } while (in.next_line());
    return use;
}

struct ObjMaterial {
    SceneMaterial look{};
    /// Files of pictures by their keyword (map_Kd, norm, map_Pr ...), as written.
    std::map<std::string, std::string, std::less<>> maps{};
    /// The file that holds roughness and metallic together (app/export/obj.cpp); empty: none.
    std::string packed{};

    /// The file of this keyword; empty: none.
    std::string map(std::string_view keyword) const {
        const auto found = maps.find(keyword);
        return found == maps.end() ? std::string() : found->second;
    }
};

/// The comment by which Burl's materials name a picture that no keyword of MTL could.
constexpr std::string_view packed_comment = "roughness and metallic: ";

Vec3f parse_color(const FileBuffer& file, std::string_view keyword, std::string_view rest) {
    const FileBuffer line = buffer_from(rest, file.path);
    TextScanner scanner(line);
    Vec3f color(1.0f);
    const std::string what = fmt::format("a colour of {}", keyword);
    for (int k = 0; k < 3; ++k) color[k] = float(scanner.number(what.c_str()));
    return glm::max(color, Vec3f(0.0f));
}

double parse_number(const FileBuffer& file, std::string_view keyword, std::string_view rest) {
    const FileBuffer line = buffer_from(rest, file.path);
    return TextScanner(line).number(fmt::format("the number of {}", keyword).c_str());
}

/// The numbers of the extension of MTL for physically based rendering.
constexpr std::array<std::pair<std::string_view, float SceneMaterial::*>, 4> share_keywords{
    {{"Pr", &SceneMaterial::roughness},
     {"Pm", &SceneMaterial::metallic},
     {"Pc", &SceneMaterial::clearcoat},
     {"Pcr", &SceneMaterial::clearcoat_roughness}}};

constexpr std::array<std::string_view, 7> map_keywords{"map_Kd", "norm",   "map_d", "map_Pr",
                                                       "map_Pm", "map_Ke", "map_Ps"};

/// Takes a line of the material.
void parse_line(const FileBuffer& file, std::string_view keyword, std::string_view rest,
                ObjMaterial& material) {
    for (const auto& [name, member] : share_keywords)
        if (keyword == name)
            material.look.*member = float(std::clamp(parse_number(file, keyword, rest), 0.0, 1.0));
    if (std::ranges::find(map_keywords, keyword) != map_keywords.end())
        material.maps.insert_or_assign(std::string(keyword), std::string(rest));
    if (keyword == "Kd") material.look.factor = Vec4f(parse_color(file, keyword, rest), 1.0f);
    if (keyword == "Ke") material.look.emissive = parse_color(file, keyword, rest);
    if (keyword == "Ni")
        material.look.ior = float(std::clamp(parse_number(file, keyword, rest), 1.0, 100.0));
    if (keyword == "#" && rest.starts_with(packed_comment))
        material.packed = rest.substr(packed_comment.size());
}

/// The library's materials of these names; of several with one name the first.
std::map<std::string, ObjMaterial> parse_materials(const FileBuffer& file,
                                                   std::span<const std::string> names) {
    const std::set<std::string_view> wanted(names.begin(), names.end());
    std::map<std::string, ObjMaterial> materials;
    ObjMaterial* current = nullptr;
    for_each_line(file.text(), [&](std::string_view keyword, std::string_view rest) {
        if (keyword == "newmtl") {
            current = nullptr;
            if (!wanted.contains(rest)) return;
            const auto [made, is_new] = materials.try_emplace(std::string(rest));
            if (is_new) current = &made->second;
        } else if (current) {
            parse_line(file, keyword, rest, *current);
        }
    });
    return materials;
}

bool file_exists(const std::filesystem::path& path) {
    std::error_code ignored;
    return std::filesystem::exists(path, ignored);
}

/// The materials of these names, in their order; no value, with a note for stderr, where there is
/// none.
std::vector<std::optional<ObjMaterial>> find_looks(const std::string& path, const MaterialUse& use,
                                                   NamedFiles named,
                                                   std::vector<std::string>& notes) {
    std::vector<std::optional<ObjMaterial>> looks(use.names.size());
    if (use.library.empty() || use.names.empty()) return looks;
    const auto library = std::filesystem::path(path).parent_path() / use.library;
    if (!may_name(named, path, use.library)) {
        notes.push_back(fmt::format("{}: its material file {} {}; drawn without", path,
                                    printable(use.library), outside_rule));
        return looks;
    }
    if (!file_exists(library)) {
        notes.push_back(fmt::format("{}: its material file {} is missing; drawn without", path,
                                    printable(use.library)));
        return looks;
    }
    const FileBuffer file = read_file(library.string());
    const std::map<std::string, ObjMaterial> materials = parse_materials(file, use.names);
    for (std::size_t i = 0; i < looks.size(); ++i) {
        if (const auto found = materials.find(use.names[i]); found != materials.end())
            looks[i] = found->second;
        else
            notes.push_back(fmt::format("{}: no material {} in {}; drawn without", path,
                                        printable(use.names[i]), printable(use.library)));
    }
    return looks;
}

/// Whether the file is there and has a picture's signature that is read.
bool is_picture(const std::filesystem::path& file) {
    return file_exists(file) && is_read(picture_type(read_file_head(file.string(), 16)));
}

/// The colours of a map, and their alpha.
PictureColors read_map(const std::string& obj_path, const char* keyword, const std::string& map) {
    if (map.starts_with('-')) {
        throw Error(ExitCode::unsupported,
                    fmt::format("{}: options of {} ({}) are not supported; leave only the file "
                                "name",
                                obj_path, keyword, printable(map)));
    }
    const std::filesystem::path file(map);
    return read_picture((std::filesystem::path(obj_path).parent_path() / file).string());
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
        : path_(path),
          folder_(std::filesystem::path(path).parent_path()),
          material_(material),
          named_(named),
          scene_(scene) {}

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

    PictureColors read(const char* keyword, const std::string& map) {
        if (!may_name(named_, path_, map))
            throw invalid_file(path_, 0,
                               fmt::format("{} {} {}", keyword, printable(map), outside_rule));
        scene_.files.push_back((folder_ / map).string());
        return read_map(path_, keyword, map);
    }
    /// The picture of a keyword; empty where there is none, or with a note none that can be drawn.
    PictureColors read_if_there(const char* keyword, std::string_view what) {
        const std::string map = material_.map(keyword);
        if (map.empty()) return {};
        if (!may_name(named_, path_, map) || is_picture(folder_ / map)) return read(keyword, map);
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
        if (!may_name(named_, path_, name) || !is_picture(folder_ / name)) return;
        auto [image, alpha] = colors_and_alpha(read("roughness and metallic", name));
        if (std::filesystem::path(name).stem().string().ends_with("_mask"))
            image = from_mask_map(image, alpha);
        const int texture = add(std::move(image), false);
        look.roughness = look.metallic = 1.0f;
        set(look, MaterialMap::metallic_roughness, texture);
        set(look, MaterialMap::occlusion, texture);
    }

    const std::string& path_;
    std::filesystem::path folder_;
    const ObjMaterial& material_;
    NamedFiles named_;
    Scene& scene_;
};

}  // namespace

Scene load_obj_scene(const std::string& path, NamedFiles named, std::uint64_t most_triangles) {
    const Mesh mesh = read_mesh(path, {.most_triangles = most_triangles});
    const MaterialUse use = find_materials(path);
    Scene pictures;
    const std::vector<std::optional<ObjMaterial>> found =
        find_looks(path, use, named, pictures.notes);
    const bool colored = !mesh.corners.colors.empty();
    SceneMaterial none;
    none.factor = colored ? Vec4f(1.0f) : default_grey;
    std::vector<SceneMaterial> looks;
    for (const std::optional<ObjMaterial>& one : found) {
        looks.push_back(one ? one->look : none);
        if (one && !mesh.corners.uvs.empty())
            ObjPictures(path, *one, named, pictures).load(looks.back());
    }
    looks.push_back(none);
    if (std::ranges::any_of(found, [](const auto& one) { return one.has_value(); }))
        pictures.files.push_back(
            (std::filesystem::path(path).parent_path() / use.library).string());
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
