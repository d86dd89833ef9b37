// Scenes from Wavefront OBJ: the mesh of read_mesh() with Kd, map_Kd and norm of its material
// library where the file uses one material, as `burl bake` writes it.
#include <filesystem>
#include <optional>
#include <set>
#include <string_view>
#include <tuple>

#include "app/image/image_io.h"
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

/// Calls visit(keyword, rest of the line) for every line.
template <class Visit>
void for_each_line(std::string_view text, Visit visit) {
    while (!text.empty()) {
        const std::string_view line = trimmed(text.substr(0, text.find('\n')));
        const std::size_t space = std::min(line.find_first_of(" \t"), line.size());
        visit(line.substr(0, space), trimmed(line.substr(space)));
        text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    }
}

struct MaterialUse {
    std::string library;          ///< the file name of the last mtllib; empty: none
    std::set<std::string> names;  ///< the names of all usemtl
};

MaterialUse find_materials(const std::string& path) {
    const FileBuffer file = read_file(path);
    MaterialUse use;
    for_each_line(file.text(), [&](std::string_view keyword, std::string_view rest) {
        if (keyword == "mtllib") use.library = rest;
        if (keyword == "usemtl") use.names.emplace(rest);
    });
    return use;
}

struct ObjMaterial {
    Vec4f color{1.0f};
    std::string map;      ///< map_Kd as written; empty: none
    std::string normals;  ///< norm as written; empty: none
    std::string alpha;    ///< map_d as written; empty: none
};

Vec4f parse_color(const FileBuffer& file, std::string_view rest) {
    const FileBuffer line = buffer_from(rest, file.path);
    TextScanner scanner(line);
    Vec4f color(1.0f);
    for (int k = 0; k < 3; ++k) color[k] = float(scanner.number("a colour of Kd"));
    return color;
}

std::optional<ObjMaterial> parse_material(const FileBuffer& file, const std::string& name) {
    std::optional<ObjMaterial> material;
    bool inside = false;
    for_each_line(file.text(), [&](std::string_view keyword, std::string_view rest) {
        if (keyword == "newmtl") {
            inside = rest == name && !material;
            if (inside) material.emplace();
        } else if (inside && keyword == "Kd") {
            material->color = parse_color(file, rest);
        } else if (inside && keyword == "map_Kd") {
            material->map = rest;
        } else if (inside && keyword == "norm") {
            material->normals = rest;
        } else if (inside && keyword == "map_d") {
            material->alpha = rest;
        }
    });
    return material;
}

bool file_exists(const std::filesystem::path& path) {
    std::error_code ignored;
    return std::filesystem::exists(path, ignored);
}

/// The material that the whole file uses; no value, with a note for stderr, where there is no such
/// single one.
std::optional<ObjMaterial> whole_material(const std::string& path, const MaterialUse& use,
                                          std::vector<std::string>& notes) {
    if (use.library.empty() || use.names.empty()) return std::nullopt;
    if (use.names.size() > 1) {
        notes.push_back(
            fmt::format("{}: {} materials, of which only one could be drawn; drawn "
                        "without",
                        path, use.names.size()));
        return std::nullopt;
    }
    const auto library = std::filesystem::path(path).parent_path() / use.library;
    if (!file_exists(library)) {
        notes.push_back(fmt::format("{}: its material file {} is missing; drawn without", path,
                                    printable(use.library)));
        return std::nullopt;
    }
    auto material = parse_material(read_file(library.string()), *use.names.begin());
    if (!material) {
        notes.push_back(fmt::format("{}: no material {} in {}; drawn without", path,
                                    printable(*use.names.begin()), printable(use.library)));
    }
    return material;
}

bool is_png(const std::filesystem::path& file) {
    return file.extension() == ".png" || file.extension() == ".PNG";
}

/// The colours of a map, and their alpha.
PngColors read_map(const std::string& obj_path, const char* keyword, const std::string& map) {
    if (map.starts_with('-')) {
        throw Error(ExitCode::unsupported,
                    fmt::format("{}: options of {} ({}) are not supported; leave only the file "
                                "name",
                                obj_path, keyword, printable(map)));
    }
    const std::filesystem::path file(map);
    if (!is_png(file)) {
        throw Error(ExitCode::unsupported, fmt::format("{}: the texture {} is not a PNG; convert "
                                                       "it to PNG",
                                                       obj_path, printable(map)));
    }
    const std::string png = (std::filesystem::path(obj_path).parent_path() / file).string();
    return decode_png_with_alpha(read_png_bytes(png), png);
}

/// Whether alpha is that of the colours' map; a note is made of any other, which is not drawn.
bool has_own_alpha(const std::string& path, const ObjMaterial& material,
                   std::vector<std::string>& notes) {
    if (material.alpha.empty()) return false;
    if (material.alpha == material.map || material.alpha == "-imfchan m " + material.map)
        return true;
    notes.push_back(fmt::format("{}: map_d {} is another file than map_Kd; drawn opaque", path,
                                printable(material.alpha)));
    return false;
}

}  // namespace

Scene load_obj_scene(const std::string& path) {
    const Mesh mesh = read_mesh(path);
    std::vector<std::string> notes;
    const MaterialUse use = find_materials(path);
    const auto material = whole_material(path, use, notes);
    const bool colored = !mesh.corners.colors.empty();
    const bool mapped = material && !mesh.corners.uvs.empty();
    const auto folder = std::filesystem::path(path).parent_path();

    SceneMaterial look;
    if (!material) look.factor = colored ? Vec4f(1.0f) : default_grey;
    if (material) look.factor = material->color;
    std::vector<SceneTexture> textures;
    std::vector<std::string> files;
    const auto add_texture = [&](const char* keyword, const std::string& map, bool is_color) {
        SceneTexture& texture = textures.emplace_back();
        std::tie(texture.image, texture.alpha) = colors_and_alpha(read_map(path, keyword, map));
        texture.is_color = is_color;
        files.push_back((folder / map).string());
        return int(textures.size()) - 1;
    };
    if (material) files.push_back((folder / use.library).string());
    if (mapped && !material->map.empty()) look.texture = add_texture("map_Kd", material->map, true);
    if (look.texture >= 0 && has_own_alpha(path, *material, notes)) look.alpha = SceneAlpha::blend;
    if (mapped && !material->normals.empty()) {
        if (is_png(material->normals) && file_exists(folder / material->normals))
            look.normals = add_texture("norm", material->normals, false);
        else
            notes.push_back(
                fmt::format("{}: the normal map {} is not a PNG that is there; drawn "
                            "without",
                            path, printable(material->normals)));
    }
    Scene scene = scene_from_mesh(mesh, look);
    scene.textures = std::move(textures);
    scene.files = std::move(files);
    scene.notes = std::move(notes);
    return scene;
}

}  // namespace burl
