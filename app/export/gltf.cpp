// Files of glTF 2.0; gltf_scene.cpp makes the document. The JSON and buffers are written
// here rather than by a library, so that the texture is a plain bufferView (not a data URI), bounds
// are those of the floats written, and every byte goes through AtomicFile.

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "app/export/gltf_file.h"
#include "app/export/gltf_scene.h"
#include "app/image/image_io.h"
#include "app/surface/normals.h"
#include "app/surface/tangents.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"

namespace burl {
namespace {

using Json = nlohmann::ordered_json;

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
void write_image(AtomicFile& file, GltfScene& scene, const SceneImage& image, std::size_t view) {
    std::uint64_t size = 0;
    image.encode([&](std::span<const std::uint8_t> bytes) {
        size += bytes.size();
        if (scene.binary_size + size > most_glb_bytes) throw glb_too_long(file.target());
        file.write(bytes);
    });
    file.write(padding_after(size));
    Json& json = scene.json["bufferViews"][view];
    json["byteOffset"] = scene.binary_size;
    json["byteLength"] = size;
    scene.binary_size += size + padding_after(size).size();
}

/// The vertex arrays of the mesh in its atlas; normals and tangents per corner are freed on return.
std::vector<PartVertices> vertices_of(const SceneContent& content) {
    const auto& [path, mesh, atlas, image, options] = content;
    const std::vector<Vec3f> normals = corner_normals(mesh, options.crease_degrees);
    std::vector<Vec2d> uvs;
    std::vector<Vec4f> tangents;
    if (options.normals && options.normals->tangent_space) {
        uvs = corner_uvs(atlas);
        tangents = corner_tangents(mesh.positions, mesh.triangles, uvs, normals);
    }
    std::optional<PosedCorners> posed;
    if (options.pose) posed = posed_corners(mesh, options.pose->corners, normals, uvs);
    std::vector<PartVertices> parts =
        export_vertices(mesh, atlas, normals, tangents, posed ? &*posed : nullptr);
    if (options.vertex_colors.empty()) return parts;
    for (PartVertices& part : parts)
        for (const std::uint32_t point : part.points)
            part.colors.push_back(options.vertex_colors[point]);
    return parts;
}

}  // namespace

// Lengths of images are known only once they are encoded: the head is first written with the
// largest numbers, and at the end overwritten with the true ones.
AtomicFile write_glb(const SceneContent& content) {
    const std::vector<PartVertices> vertices = vertices_of(content);
    GltfScene scene = build_gltf_scene(content, vertices);
    std::size_t view = scene.json["bufferViews"].size();
    std::vector<SceneImage> images;
    for (std::vector<SceneImage>& texture : scene_textures(content, ""))
        std::ranges::move(texture, std::back_inserter(images));
    for (const SceneImage& image : images) {
        scene.json["images"].push_back({{"name", image.name},
                                        {"bufferView", scene.json["bufferViews"].size()},
                                        {"mimeType", media_type(content.options.coding.format)}});
        scene.json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", most_glb_bytes}, {"byteLength", most_glb_bytes}});
    }
    scene.json["buffers"] = Json::array({{{"byteLength", most_glb_bytes}}});
    const std::size_t length = (gltf_text(scene.json, -1).size() + 3) / 4 * 4;
    AtomicFile file(content.path);
    file.write(glb_head("", length, 0));
    write_meshes(file, scene);
    for (const SceneImage& image : images) write_image(file, scene, image, view++);
    scene.json["buffers"][0]["byteLength"] = scene.binary_size;
    const std::string head = glb_head(gltf_text(scene.json, -1), length, scene.binary_size);
    if (head.size() + scene.binary_size > most_glb_bytes) throw glb_too_long(content.path);
    file.overwrite(0, bytes_of(head));
    return file;
}

std::vector<AtomicFile> write_gltf(const SceneContent& content) {
    const std::vector<PartVertices> vertices = vertices_of(content);
    GltfScene scene = build_gltf_scene(content, vertices);
    const auto beside = [&](std::string_view extension) {
        return path_beside(content.path, extension);
    };
    const TextureFormat format = content.options.coding.format;
    const std::string color = beside(extension_of(format));
    for (const std::vector<SceneImage>& texture : scene_textures(content, color))
        for (const SceneImage& image : texture)
            scene.json["images"].push_back({{"name", image.name},
                                            {"uri", relative_uri(image.path)},
                                            {"mimeType", media_type(format)}});
    const std::string buffer = beside(".bin");
    scene.json["buffers"] =
        Json::array({{{"uri", relative_uri(buffer)}, {"byteLength", scene.binary_size}}});
    std::vector<AtomicFile> files;
    add_images(files, content, color);
    write_meshes(files.emplace_back(buffer), scene);
    files.emplace_back(content.path).write(gltf_text(scene.json, 2) + "\n");
    return files;
}

}  // namespace burl
