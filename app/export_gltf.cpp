// Containers only: the document itself is made in gltf_scene.cpp.
#include "app/export_gltf.h"

#include <filesystem>
#include <limits>

#include "app/atomic_file.h"
#include "app/gltf_scene.h"
#include "app/level_names.h"
#include "atlas/error.h"

namespace burl {
namespace {

using Json = nlohmann::ordered_json;

std::string dump(const Json& json, int indent) {
    return json.dump(indent, ' ', false,
                     Json::error_handler_t::replace);  // bytes not UTF-8: U+FFFD
}

/// RFC 3986: everything but unreserved characters is escaped.
std::string percent_encoded(const std::string& name) {
    std::string uri;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        const bool plain = (byte >= '0' && byte <= '9') || (byte >= 'A' && byte <= 'Z') ||
                           (byte >= 'a' && byte <= 'z') || byte == '-' || byte == '.' ||
                           byte == '_' || byte == '~';
        uri += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
    }
    return uri;
}

void write_words(AtomicFile& file, std::initializer_list<std::uint64_t> words) {
    for (const std::uint64_t word : words) {
        std::array<std::uint8_t, 4> bytes{};
        for (std::size_t k = 0; k < 4; ++k) bytes[k] = std::uint8_t(word >> (8 * k));
        file.write(bytes);
    }
}

}  // namespace

void write_glb(const std::string& path, const GltfContent& content) {
    GltfScene scene = build_gltf_scene(content);
    const auto add_image = [&](std::span<const std::uint8_t> png) {
        const std::size_t view = add_buffer_view(scene, png);
        scene.json["images"].push_back({{"bufferView", view}, {"mimeType", "image/png"}});
    };
    add_image(content.png);
    for (const std::vector<std::uint8_t>& level : content.levels) add_image(level);
    if (!content.normal_png.empty()) add_image(content.normal_png);
    scene.json["buffers"] = Json::array({{{"byteLength", scene.binary.size()}}});
    std::string json = dump(scene.json, -1);
    json.resize((json.size() + 3) / 4 * 4, ' ');

    const std::uint64_t total = 12 + 8 + json.size() + 8 + scene.binary.size();
    if (total > std::numeric_limits<std::uint32_t>::max()) {
        throw Error(ExitCode::unsupported,
                    fmt::format("{}: the result has {} bytes, a .glb holds at most 4 GiB; write a "
                                ".gltf instead",
                                path, total));
    }
    AtomicFile file(path);
    write_words(file, {0x46546C67, 2, total});
    write_words(file, {json.size(), 0x4E4F534A});
    file.write(json);
    write_words(file, {scene.binary.size(), 0x004E4942});
    file.write(scene.binary);
    file.commit();
}

void write_gltf(const std::string& path, const GltfContent& content) {
    GltfScene scene = build_gltf_scene(content);
    const std::filesystem::path base(path);
    const auto beside = [&](const std::string& extension) {
        return std::filesystem::path(base).replace_extension(extension);
    };
    const auto uri = [](const std::filesystem::path& file) {
        return percent_encoded(file.filename().string());
    };
    std::vector<AtomicFile> files;
    files.reserve(4 + content.levels.size());
    const auto add_image = [&](const std::filesystem::path& file,
                               std::span<const std::uint8_t> png) {
        scene.json["images"].push_back({{"uri", uri(file)}, {"mimeType", "image/png"}});
        files.emplace_back(file.string()).write(png);
    };
    add_image(beside(".png"), content.png);
    for (std::size_t l = 1; l <= content.levels.size(); ++l)
        add_image(beside(level_extension(l)), content.levels[l - 1]);
    if (!content.normal_png.empty()) add_image(normal_map_path(path), content.normal_png);
    scene.json["buffers"] =
        Json::array({{{"uri", uri(beside(".bin"))}, {"byteLength", scene.binary.size()}}});

    files.emplace_back(beside(".bin").string()).write(scene.binary);
    files.emplace_back(path).write(dump(scene.json, 2) + "\n");
    commit_together(files);
}

}  // namespace burl
