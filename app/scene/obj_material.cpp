#include "app/scene/obj_material.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "atlas/base/real_path.h"
#include "atlas/file/file_buffer.h"
#include "atlas/file/text_scanner.h"
#include "atlas/read/obj_libraries.h"

namespace burl {

namespace {

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

using MaterialsByName = std::map<std::string, ObjMaterial, std::less<>>;

/// Adds the library's materials of the wanted names that are not known yet.
void add_materials(const FileBuffer& file, const std::set<std::string_view>& wanted,
                   MaterialsByName& materials) {
    ObjMaterial* current = nullptr;
    for_each_library_line(file.text(), [&](std::string_view keyword, std::string_view rest) {
        if (keyword == "newmtl") {
            current = nullptr;
            if (!wanted.contains(rest)) return;
            const auto [made, is_new] =
                materials.try_emplace(std::string(rest), ObjMaterial{.library = file.path});
            if (is_new) current = &made->second;
        } else if (current) {
            parse_line(file, keyword, rest, *current);
        }
    });
}

/// The first of the names, and how many others there are.
std::string first_of(std::span<const std::string> names) {
    std::string text = printable(names[0]);
    if (names.size() == 2) text += " (and 1 other)";
    if (names.size() > 2) text += fmt::format(" (and {} others)", names.size() - 1);
    return text;
}

/// The paths of the libraries that are there and may be read, each once.
std::vector<std::string> libraries_to_read(const std::string& path,
                                           std::span<const std::string> libraries, NamedFiles named,
                                           std::vector<std::string>& notes) {
    std::vector<std::string> paths, outside, missing;
    std::set<std::string> known;
    for (const std::string& name : libraries) {
        const auto library = std::filesystem::path(path).parent_path() / name;
        std::error_code ignored;
        const bool there = std::filesystem::exists(library, ignored);
        // a name that seems to lead nowhere else is looked at no further, since there may be many
        const bool plain = !name.starts_with('/') && name.find("..") == std::string::npos;
        if ((there || !plain) && !may_name(named, path, name))
            outside.push_back(name);
        else if (!there)
            missing.push_back(name);
        else if (known.insert(real_path(library.string())).second)
            paths.push_back(library.string());
    }
    if (!outside.empty())
        notes.push_back(fmt::format("{}: its material file {} {}; drawn without", path,
                                    first_of(outside), outside_rule));
    if (!missing.empty())
        notes.push_back(fmt::format("{}: its material file {} is missing; drawn without", path,
                                    first_of(missing)));
    return paths;
}

}  // namespace

ObjMaterials find_obj_materials(const std::string& path, std::span<const std::string> libraries,
                                std::span<const std::string> names, NamedFiles named,
                                std::vector<std::string>& notes) {
    ObjMaterials found;
    found.looks.resize(names.size());
    if (names.empty()) return found;
    found.files = libraries_to_read(path, libraries, named, notes);
    if (found.files.empty()) return found;
    const std::set<std::string_view> wanted(names.begin(), names.end());
    MaterialsByName materials;
    for (const std::string& file : found.files) add_materials(read_file(file), wanted, materials);
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (const auto known = materials.find(names[i]); known != materials.end())
            found.looks[i] = known->second;
        else
            notes.push_back(fmt::format("{}: no material {} in {}; drawn without", path,
                                        printable(names[i]), first_of(libraries)));
    }
    return found;
}

}  // namespace burl
