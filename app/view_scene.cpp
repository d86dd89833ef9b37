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
std::string glb_of(const std::string& json, std::span<const std::uint8_t> binary) {
    std::string bytes = "glTF";
    append_word(bytes, 2);
    append_word(bytes, 12 + 8 + json.size() + 8 + binary.size());
    append_word(bytes, json.size());
    bytes += "JSON" + json;
    append_word(bytes, binary.size());
    bytes += std::string("BIN\0", 4);
    bytes.append(reinterpret_cast<const char*>(binary.data()), binary.size());
    return bytes;
}

/// The document with its images in it.
std::string glb_of(const GltfContent& content) {
    GltfScene scene = build_gltf_scene(content);
    for (const auto& png : {content.png, content.normal_png})
        if (!png.empty())
            scene.json["images"].push_back(
                {{"bufferView", add_buffer_view(scene, png)}, {"mimeType", "image/png"}});
    scene.json["buffers"].push_back({{"byteLength", scene.binary.size()}});
    std::string json =
        scene.json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    json.resize((json.size() + 3) / 4 * 4, ' ');
    return glb_of(json, scene.binary);
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
    std::span<const std::uint8_t> normal_png;
    if (bumped) normal_png = texel;
    const std::string glb =
        glb_of(GltfContent{mesh, vertices, atlas.options, texel, {}, {}, normal_png});
    return load_gltf_scene(buffer_from(glb, mesh.name));
}

}  // namespace burl
