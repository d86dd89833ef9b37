// What a page can show: .glb files that hold all they need, in extensions that the viewer knows.
#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <set>
#include <string_view>

#include <fmt/format.h>
#include <tiny_gltf.h>

#include "app/page/page.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "atlas/gltf/container.h"
#include "atlas/gltf/document.h"

namespace burl {

namespace {

/// The extensions that change what is seen and that three.js r187 reads without a decoder of its
/// own. All KHR_materials_* are taken: what the viewer does not know of one is its own default.
constexpr std::array<std::string_view, 6> known_extensions{
    "KHR_texture_transform", "KHR_mesh_quantization", "KHR_lights_punctual",
    "EXT_texture_webp",      "EXT_texture_avif",      "EXT_mesh_gpu_instancing"};

bool knows(std::string_view extension) {
    return extension.starts_with("KHR_materials_") ||
           std::ranges::find(known_extensions, extension) != known_extensions.end();
}

/// The name in letters, digits and '-', for files and addresses; "object" where it has none.
std::string plain_name(const std::string& name) {
    std::string plain;
    for (const char c : name) {
        const bool kept =
            (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        if (kept)
            plain += c;
        else if (!plain.empty() && plain.back() != '-')
            plain += '-';
    }
    while (plain.ends_with('-')) plain.pop_back();
    return plain.empty() ? "object" : plain;
}

/// The name, with a number behind it where it is taken, in any case, since some disks have no
/// cases.
std::string free_name(const std::string& name, std::set<std::string>& taken) {
    const auto lower = [](std::string text) {
        std::ranges::transform(text, text.begin(),
                               [](unsigned char c) { return char(std::tolower(c)); });
        return text;
    };
    std::string chosen = name;
    for (int i = 2; !taken.insert(lower(chosen)).second; ++i)
        chosen = fmt::format("{}-{}", name, i);
    return chosen;
}

}  // namespace

std::vector<PageObject> page_objects(std::span<const std::string> paths) {
    std::vector<PageObject> objects;
    std::set<std::string> names, files;
    for (const std::string& path : paths) {
        const std::filesystem::path file(path);
        if (file.extension() != ".glb" && file.extension() != ".GLB")
            throw Error(ExitCode::usage,
                        fmt::format("{}: a page is made of .glb files; bake to one", path));
        const std::string name = free_name(file.stem().string(), names);
        objects.push_back({path, name, free_name(plain_name(name), files)});
    }
    return objects;
}

void check_page_object(const std::string& path) {
    const FileBuffer file = read_file(path);
    const tinygltf::Model model = load_gltf(file);
    if (!split_gltf(file).is_glb)
        throw Error(ExitCode::unsupported,
                    fmt::format("{}: a .gltf by its content; a page takes .glb files", path));
    for (const std::string& extension : model.extensionsRequired)
        if (!knows(extension))
            throw Error(ExitCode::unsupported,
                        fmt::format("{}: needs {}, which the page's viewer does not read", path,
                                    extension));
    const auto inside = [&](const std::string& uri) {
        if (!uri.empty() && !is_data_uri(uri))
            throw Error(ExitCode::unsupported,
                        fmt::format("{}: names the file {}; a page takes .glb files that hold all "
                                    "they need",
                                    path, uri));
    };
    for (const tinygltf::Buffer& buffer : model.buffers) inside(buffer.uri);
    for (const tinygltf::Image& image : model.images) inside(image.uri);
}

}  // namespace burl
