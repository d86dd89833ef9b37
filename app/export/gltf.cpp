// The containers of glTF; gltf_scene.cpp makes the document.
#include "app/export/gltf.h"

#include <array>
#include <filesystem>
#include <limits>

#include <nlohmann/json.hpp>

#include "app/base/atomic_file.h"
#include "app/export/gltf_scene.h"
#include "app/image/image_io.h"
#include "atlas/base/error.h"

namespace burl {
namespace {

using Json = nlohmann::ordered_json;

std::string dump(const Json& json, int indent) {
    return json.dump(indent, ' ', false,
                     Json::error_handler_t::replace);  // invalid UTF-8 becomes U+FFFD
}

/// The name with everything but RFC 3986's unreserved characters escaped.
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

constexpr std::uint64_t most_bytes = std::numeric_limits<std::uint32_t>::max();

Error too_long(const std::string& path) {
    return Error(ExitCode::unsupported,
                 fmt::format("{}: the result has more than 4 GiB, which no .glb holds; write a "
                             ".gltf instead",
                             path));
}

template <std::size_t Count>
std::array<std::uint8_t, 4 * Count> as_words(const std::array<std::uint64_t, Count>& words) {
    std::array<std::uint8_t, 4 * Count> bytes{};
    for (std::size_t k = 0; k < bytes.size(); ++k)
        bytes[k] = std::uint8_t(words[k / 4] >> (8 * (k % 4)));
    return bytes;
}

/// The container's bytes before the buffer: file header, JSON chunk and the buffer chunk's header.
/// The JSON is padded with spaces to `length` bytes, a multiple of 4.
std::string glb_head(const std::string& json, std::size_t length, std::uint64_t binary_size) {
    std::string head;
    const auto append = [&](const auto& bytes) { head.append(bytes.begin(), bytes.end()); };
    append(as_words<5>({0x46546C67, 2, 28 + length + binary_size, length, 0x4E4F534A}));
    head += json;
    head.resize(20 + length, ' ');
    append(as_words<2>({binary_size, 0x004E4942}));
    return head;
}

std::span<const std::uint8_t> bytes_of(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

void write_meshes(AtomicFile& file, const GltfScene& scene) {
    for (const auto& bytes : scene.binary) {
        file.write(bytes);
        file.write(padding_after(bytes.size()));
    }
}

/// Appends the image to the buffer and stores its offset and length in its bufferView. Throws
/// Error(unsupported) beyond 4 GiB.
void write_image(AtomicFile& file, GltfScene& scene, const ByteSource& png, std::size_t view) {
    std::uint64_t size = 0;
    png([&](std::span<const std::uint8_t> bytes) {
        size += bytes.size();
        if (scene.binary_size + size > most_bytes) throw too_long(file.target());
        file.write(bytes);
    });
    file.write(padding_after(size));
    Json& json = scene.json["bufferViews"][view];
    json["byteOffset"] = scene.binary_size;
    json["byteLength"] = size;
    scene.binary_size += size + padding_after(size).size();
}

struct NamedImage {
    std::string name;
    ByteSource png;
};

/// The texture, its MIP levels, then the normal map.
std::vector<NamedImage> images_of(const GltfContent& content) {
    std::vector<NamedImage> images{{content.name, content.png}};
    for (const ByteSource& level : content.levels)
        images.push_back({fmt::format("{} level {}", content.name, images.size()), level});
    if (content.normal_png) images.push_back({content.name + " normals", content.normal_png});
    return images;
}

}  // namespace

// Lengths of images are known only once they are encoded: the head is first written with the
// largest numbers, and at the end overwritten with the true ones.
AtomicFile write_glb(const GltfContent& content) {
    GltfScene scene = build_gltf_scene(content);
    const std::vector<NamedImage> images = images_of(content);
    const std::size_t views = scene.json["bufferViews"].size();
    for (std::size_t i = 0; i < images.size(); ++i) {
        scene.json["images"].push_back(
            {{"name", images[i].name}, {"bufferView", views + i}, {"mimeType", "image/png"}});
        scene.json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", most_bytes}, {"byteLength", most_bytes}});
    }
    scene.json["buffers"] = Json::array({{{"byteLength", most_bytes}}});
    const std::size_t length = (dump(scene.json, -1).size() + 3) / 4 * 4;
    AtomicFile file(content.path);
    file.write(glb_head("", length, 0));
    write_meshes(file, scene);
    for (std::size_t i = 0; i < images.size(); ++i)
        write_image(file, scene, images[i].png, views + i);
    scene.json["buffers"][0]["byteLength"] = scene.binary_size;
    const std::string head = glb_head(dump(scene.json, -1), length, scene.binary_size);
    if (head.size() + scene.binary_size > most_bytes) throw too_long(content.path);
    file.overwrite(0, bytes_of(head));
    return file;
}

std::vector<AtomicFile> write_gltf(const GltfContent& content) {
    const std::string& path = content.path;
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
    const std::vector<NamedImage> images = images_of(content);
    for (std::size_t i = 0; i < images.size(); ++i) {
        std::filesystem::path file = normal_map_path(path);
        if (i <= content.levels.size()) file = beside(i == 0 ? ".png" : level_extension(i));
        scene.json["images"].push_back(
            {{"name", images[i].name}, {"uri", uri(file)}, {"mimeType", "image/png"}});
        images[i].png(sink_of(files.emplace_back(file.string())));
    }
    scene.json["buffers"] =
        Json::array({{{"uri", uri(beside(".bin"))}, {"byteLength", scene.binary_size}}});

    write_meshes(files.emplace_back(beside(".bin").string()), scene);
    files.emplace_back(path).write(dump(scene.json, 2) + "\n");
    return files;
}

}  // namespace burl
