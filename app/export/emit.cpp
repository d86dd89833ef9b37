#include "app/export/emit.h"

#include <algorithm>
#include <iterator>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfVecAttribute.h>
#include <fmt/format.h>

#include "app/base/shader_source.h"
#include "app/base/version.h"
#include "app/export/emit_material.h"
#include "app/image/exr_stream.h"
#include "app/pipeline/pipeline.h"
#include "procedural/glsl/graph.h"
#include "procedural/glsl/plain.h"
#include "procedural/maps/point_map.h"

namespace burl {

namespace {

/// The GLSL text "vec3(x, y, z)".
std::string column(const Vec3d& v) {
    const auto number = [](double x) { return glsl_number(x, GlslReal::float32); };
    return fmt::format("vec3({}, {}, {})", number(v.x), number(v.y), number(v.z));
}

/// The name in printable ASCII without backslashes, since GLSL 3.30 is ASCII and a backslash or a
/// line's end would end the comment elsewhere.
std::string in_comment(std::string name) {
    for (char& c : name)
        if (c < ' ' || c > '~' || c == '\\') c = '?';
    return name;
}

std::string header(const Recipe& recipe) {
    return fmt::format(R"(#version 330 core
// Solid texture {}, written by Burl {} from its recipe.
//
// texture_color(solid) is the texture's colour in linear light, over black, at a point of solid space.
// To colour a surface as it is drawn, call texture_color(solid_from_object * vec4(position, 1.0)) with
// the position as it stands in the mesh's file. Of the same point texture_material(solid) is the whole
// material, texture_height(solid) the height of its bumps, and texture_normal(solid, normal) the normal
// with them. To fill the mesh's atlas with the colour, run main() once per texel (one triangle over a
// target of the atlas's size) with the atlas's solid map, which burl bake --solid-map writes. Encode the
// colours as sRGB, or let the target do it. They are point samples, and Burl's own up to rounding to
// float32.
)",
                       recipe.name.empty() ? "without a name" : in_comment(recipe.name),
                       burl_version());
}

std::string matrix(const Affine3& map) {
    return fmt::format(
        "const mat4x3 solid_from_object = mat4x3(\n    {},\n    {},\n    {},\n    {});\n",
        column(map.linear[0]), column(map.linear[1]), column(map.linear[2]), column(map.offset));
}

constexpr const char* main_function =
    R"(uniform sampler2D solid_map;  // X, Y, Z and A of the file, as floats
uniform vec3 solid_base;      // "base" of the file's header

layout(location = 0) out vec4 color;

void main() {
    vec4 texel = texelFetch(solid_map, ivec2(gl_FragCoord.xy), 0);
    color = vec4(texture_color(texel.a > 0.0 ? solid_base + texel.xyz : vec3(0.0)), 1.0);
}
)";

/// The sentence about a shader's image, if it is that of the file or its alpha; else empty.
std::string image_text(const GlslImage& image, const GraphImage& known) {
    const std::string file = in_comment(known.file);
    if (image.pixels.get() == known.pixels->alpha())
        return fmt::format("// {} is the alpha of the image {}, as a grey, its top row first.\n",
                           image.uniform, file);
    if (image.pixels != known.pixels) return "";
    return fmt::format(
        "// {} is the image {}, decoded to linear light (an sRGB texture){}, "
        "its top row first.\n",
        image.uniform, file, known.pixels->alpha() ? " and multiplied by its alpha" : "");
}

std::string images_text(const GlslTexture& texture, const TextureGraph& graph) {
    std::string text;
    for (const GlslImage& image : texture.images)
        for (const GraphImage& known : graph.images)
            if (const std::string sentence = image_text(image, known); !sentence.empty()) {
                text += sentence;
                break;
            }
    return text;
}

/// The texture's graph with the images of the bumps beside its own.
TextureGraph with_images_of_bumps(const Recipe& recipe) {
    TextureGraph graph = recipe.texture;
    std::ranges::copy(recipe.bump.input.images, std::back_inserter(graph.images));
    return graph;
}

/// The text of all parts but numbers/real.glsl.
std::string text_of(const GlslTexture& texture) {
    std::string text = glsl_constant_tables(texture.tables, GlslReal::float32);
    for (const GlslPart& part : texture.parts)
        if (part.name != "numbers/real.glsl")
            text += std::string(part.text.empty() ? embedded_shader(part.name) : part.text) + "\n";
    return text;
}

constexpr const char* axes[] = {"X", "Y", "Z", "A"};
constexpr const char* owner = "owner";

Imf::Header header_of(const SolidMap& map, const Vec3d& base) {
    Imf::Header header(int(map.owners.width()), int(map.owners.height()));
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const char* axis : axes) header.channels().insert(axis, Imf::Channel(Imf::FLOAT));
    header.channels().insert(owner, Imf::Channel(Imf::UINT));
    header.insert("base", Imf::V3dAttribute(Imath::V3d(base.x, base.y, base.z)));
    return header;
}

/// A slice over one component of the pixels, which OpenEXR only reads although it takes char*.
template <class Pixel>
Imf::Slice slice_of(Imf::PixelType type, const Image<Pixel>& image, std::size_t component) {
    auto* base = const_cast<char*>(reinterpret_cast<const char*>(image.pixels().data()));
    return {type, base + 4 * component, sizeof(Pixel), sizeof(Pixel) * image.width()};
}

void encode(Imf::OStream& stream, const SolidMap& map, const Vec3d& base) {
    Imf::OutputFile file(stream, header_of(map, base));
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < std::size(axes); ++c)
        frame.insert(axes[c], slice_of(Imf::FLOAT, map.local, c));
    frame.insert(owner, slice_of(Imf::UINT, map.owners, 0));
    file.setFrameBuffer(frame);
    file.writePixels(int(map.owners.height()));
}

}  // namespace

std::string emit_glsl(const Recipe& recipe, const Affine3& texture_from_mesh) {
    const GlslTexture texture = glsl_material(recipe.texture, recipe.bump.input, GlslReal::float32);
    const std::string definitions = glsl_needed_by(
        {"texture_color", "texture_planes", "bump_input"}, glsl_in_float(text_of(texture)));
    return header(recipe) + images_text(texture, with_images_of_bumps(recipe)) + "\n" +
           definitions + "\n" + matrix(texture_from_mesh) + "\n" +
           emitted_material(recipe, texture_from_mesh) + "\n" + main_function;
}

WrittenSolidMap write_solid_map(const std::string& path, Pipeline& pipeline, int threads) {
    const SolidAtlas& solid = pipeline.solid();
    const Affine3 map = texture_from_solid(pipeline.recipe());
    const Vec3d base = solid_base(solid, map);
    const SolidMap content =
        fill_solid_map(solid, map, base, {0, 0, solid.size, solid.size}, threads);
    return {base, write_exr_stream(path, "solid map", solid.size, solid.size,
                                   [&](Imf::OStream& stream) { encode(stream, content, base); })};
}

}  // namespace burl
