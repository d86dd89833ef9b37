#include "app/export/emit.h"

#include <algorithm>
#include <iterator>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfVecAttribute.h>
#include <fmt/format.h>

#include "app/base/shader_numbers.h"
#include "app/base/shader_source.h"
#include "app/base/version.h"
#include "app/export/emit_knobs.h"
#include "app/export/emit_material.h"
#include "app/export/knob.h"
#include "app/image/exr_stream.h"
#include "app/pipeline/pipeline.h"
#include "app/recipe/edit/controls.h"
#include "procedural/glsl/graph.h"
#include "procedural/glsl/plain.h"
#include "procedural/maps/point_map.h"
#include "procedural/numbers/rotation.h"

namespace burl {

namespace {

/// The GLSL text "vec3(x, y, z)".
std::string column(const Vec3d& v) {
    return fmt::format("vec3({}, {}, {})", shader_number(v.x), shader_number(v.y),
                       shader_number(v.z));
}

constexpr const char* about_knobs =
    R"( The uniforms knob_... are the recipe's controls: other values give what
// --set "NAME=VALUE" gives.)";

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
// float32.{}
)",
                       recipe.name.empty() ? "without a name" : in_glsl_comment(recipe.name),
                       burl_version(), recipe.controls.empty() ? "" : about_knobs);
}

std::string matrix(const char* name, const Affine3& map) {
    return fmt::format("const mat4x3 {} = mat4x3(\n    {},\n    {},\n    {},\n    {});\n", name,
                       column(map.linear[0]), column(map.linear[1]), column(map.linear[2]),
                       column(map.offset));
}

/// The map from texture coordinates of `from` to those of the same points by `to`.
Affine3 change_of(const SolidOptions& from, const SolidOptions& to) {
    const double scale = to.scale / from.scale;
    Affine3 change{Mat3d(scale)};
    if (from.rotate != to.rotate)
        change.linear = scale * rotation_about_axes(to.rotate) *
                        glm::transpose(rotation_about_axes(from.rotate));
    change.offset = to.translate - change.linear * from.translate;
    return change;
}

/// Whether a control of the recipe moves its texture coordinates.
bool moves_solid(const Recipe& recipe) {
    return std::ranges::any_of(recipe.controls, [](const RecipeControl& control) {
        return std::ranges::any_of(control.sets, [](const std::string& entry) {
            return control_target(entry).path.starts_with("solid.");
        });
    });
}

constexpr const char* main_function =
    R"(uniform sampler2D solid_map;  // X, Y, Z and A of the file, as floats
uniform vec3 solid_base;      // "base" of the file's header
{}
layout(location = 0) out vec4 color;

void main() {{
    vec4 texel = texelFetch(solid_map, ivec2(gl_FragCoord.xy), 0);
    vec3 solid = texel.a > 0.0 ? {} : vec3(0.0);
    color = vec4(texture_color(solid), 1.0);
}}
)";

/// The main function of a shader whose solid map is in texture coordinates of `mapped`.
std::string main_text(const Recipe& recipe, const Recipe& mapped) {
    if (!moves_solid(mapped))
        return fmt::format(fmt::runtime(main_function), "", "solid_base + texel.xyz");
    return fmt::format(fmt::runtime(main_function),
                       "// From the map's points to the same with the controls' values.\n" +
                           matrix("solid_from_map", change_of(mapped.solid, recipe.solid)),
                       "solid_from_map * vec4(solid_base + texel.xyz, 1.0)");
}

/// The sentence about a shader's image, if it is that of the file or its alpha; else empty.
std::string image_text(const GlslImage& image, const GraphImage& known) {
    const std::string file = in_glsl_comment(known.file);
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

EmittedShader emit_glsl(const Recipe& recipe, const Affine3& solid_from_mesh) {
    std::string images;
    const auto text = [&](const Recipe& turned) {
        const GlslTexture texture =
            glsl_material(turned.texture, turned.bump.input, GlslReal::float32);
        images = images_text(texture, with_images_of_bumps(turned));
        const Affine3 map = texture_from_solid(turned).after(solid_from_mesh);
        const std::string definitions = glsl_needed_by(
            {"texture_color", "texture_planes", "bump_input"}, glsl_in_float(text_of(texture)));
        return definitions + "\n" + matrix("solid_from_object", map) + "\n" +
               emitted_material(turned, map) + "\n" + main_text(turned, recipe);
    };
    KnobbedShader shader = with_knobs(recipe, text);
    if (recipe.filter != Filter{})
        shader.notes.push_back(
            fmt::format("filter {} is left out: the shader gives the colour at a point",
                        to_string(recipe.filter.kind)));
    if (!recipe.paint.empty())
        shader.notes.emplace_back("paint is left out: the shader computes the recipe's texture");
    const std::string uniforms = shader.uniforms.empty() ? "" : "\n" + shader.uniforms;
    return {header(recipe) + images + uniforms + "\n" + shader.text, std::move(shader.notes)};
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
