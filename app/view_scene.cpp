#include "app/view_scene.h"

#include <bit>

#include "app/gltf_scene.h"
#include "app/image_io.h"
#include "app/normals.h"
#include "app/tangents.h"

namespace burl {

namespace {

void append_word(std::string& bytes, std::size_t word) {
    for (int k = 0; k < 4; ++k) bytes += char(std::uint8_t(word >> (8 * k)));
}

/// glTF 2.0, section 4.4; parts are padded to 4 bytes.
std::string glb_of(const std::string& json, const std::string& binary) {
    std::string bytes = "glTF";
    append_word(bytes, 2);
    append_word(bytes, 12 + 8 + json.size() + 8 + binary.size());
    append_word(bytes, json.size());
    bytes += "JSON" + json;
    append_word(bytes, binary.size());
    return bytes + std::string("BIN\0", 4) + binary;
}

void append(std::string& bytes, std::span<const std::uint8_t> part) {
    for (const std::span<const std::uint8_t> piece : {part, padding_after(part.size())})
        bytes.append(reinterpret_cast<const char*>(piece.data()), piece.size());
}

/// The document with `texel` for every image.
std::string glb_of(const GltfContent& content, std::span<const std::uint8_t> texel) {
    GltfScene scene = build_gltf_scene(content);
    std::string binary;
    for (const std::span<const std::uint8_t> part : scene.binary) append(binary, part);
    const std::size_t images = content.normal_png ? 2 : 1;
    for (std::size_t i = 0; i < images; ++i) {
        const std::size_t view = add_buffer_view(scene, texel.size());
        append(binary, texel);
        scene.json["images"].push_back({{"bufferView", view}, {"mimeType", "image/png"}});
    }
    scene.json["buffers"].push_back({{"byteLength", binary.size()}});
    std::string json =
        scene.json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    json.resize((json.size() + 3) / 4 * 4, ' ');
    return glb_of(json, binary);
}

}  // namespace

Scene baked_scene(Pipeline& pipeline, double crease_degrees) {
    const Mesh& mesh = pipeline.atlas_mesh();
    const Atlas& atlas = pipeline.atlas();
    const std::vector<std::uint8_t> texel = encode_png(Image<Rgb8>(1, 1));
    const bool bumped = !pipeline.recipe().bump.empty();
    const std::vector<Vec3f> normals = corner_normals(mesh, crease_degrees);
    std::vector<Vec4f> tangents;
    if (bumped)
        tangents = corner_tangents(mesh.positions, mesh.triangles, corner_uvs(atlas), normals);
    const std::vector<PartVertices> vertices = export_vertices(mesh, atlas, normals, tangents);
    const ByteSource image = [&](const ByteSink& sink) { sink(texel); };
    GltfContent content{mesh, vertices, atlas.options, image, {}, {}};
    if (bumped) content.normal_png = image;
    const std::string glb = glb_of(content, texel);
    return load_gltf_scene(buffer_from(glb, mesh.name));
}

}  // namespace burl
