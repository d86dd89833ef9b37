#include "app/gl/fill/resident.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "app/gl/device/objects.h"
#include "procedural/graph/masks.h"
#include "procedural/graph/noise_count.h"
#include "procedural/graph/planes.h"

namespace burl {

namespace {

constexpr std::size_t map_budget = std::size_t(1) << 30;  // bytes of point maps that are kept
constexpr int tile_side = 2048;
constexpr std::size_t most_programs = 64, most_pictures = 8;
constexpr int other_components = 256;  // of uniforms besides numbers: matrices, sample patterns
/// The last texture units that OpenGL 3.3 has in any case: graphs' own begin at 0.
constexpr int tangents_unit = 13, normals_unit = 14, paint_unit = 15;

/// An expression for every plane of a material, by its number.
std::vector<std::string> plane_texts(const TextureGraph& graph) {
    const PlaneLayout layout(graph);
    std::vector<std::string> texts(layout.count());
    for (std::size_t c = 0; c < 3; ++c) texts[c] = fmt::format("color.{}", "rgb"[c]);
    if (layout.alpha()) texts[*layout.alpha()] = "color.a";
    for (const GraphChannel& one : graph.channels) {
        const std::size_t first = *layout.of(one.channel);
        const auto name = to_string(one.channel);
        if (!is_color(one.channel)) texts[first] = fmt::format("planes.{}", name);
        if (is_color(one.channel))
            for (std::size_t c = 0; c < 3; ++c)
                texts[first + c] = fmt::format("planes.{}.{}", name, "rgb"[c]);
    }
    return texts;
}

/// A component of a picture as an expression of its planes, in the host's order of operations
/// (procedural/fill/pictures.cpp).
std::string component_text(const PicturePlan& plan, std::size_t c,
                           const std::vector<std::string>& planes) {
    const PictureComponent& component = plan.components[c];
    std::string text = glsl_number(component.factor, GlslReal::float32);
    if (component.plane) text += " * " + planes[*component.plane];
    if (component.times) text += fmt::format(" * clamp({}, 0.0, 1.0)", planes[*component.times]);
    if (component.offset != 0.0)
        text = fmt::format("({} + {})", text, glsl_number(component.offset, GlslReal::float32));
    const bool color = plan.is_color && c < 3;
    if (!color) return fmt::format("clamp({}, 0.0, 1.0)", text);
    if (!plan.alpha) return fmt::format("code({})", text);
    const std::string& alpha = planes[*plan.alpha];
    return fmt::format("code({0} > 0.0 ? ({1}) / {0} : {1})", alpha, text);
}

/// A vector as GLSL.
std::string vector_text(const Vec3d& v) {
    const auto number = [](double x) { return glsl_number(x, GlslReal::float32); };
    return fmt::format("vec3({}, {}, {})", number(v.x), number(v.y), number(v.z));
}

/// Normals in tangent frames as in procedural/fill/tangent_frame.h and procedural/graph/bump.h.
std::string bumps_text(const Recipe& recipe, std::size_t output) {
    const Mat3d linear = texture_from_solid(recipe).linear;
    return fmt::format(R"(
uniform sampler2D frame_normals, frame_tangents;
layout(location = {0}) out vec4 picture{0};
mat3 height_linear = mat3({1}, {2}, {3});
vec3 bumped(ivec2 place, ivec2 texel) {{
    vec4 frame = texelFetch(frame_normals, place, 0);
    vec3 normal = frame.xyz, tangent = texelFetch(frame_tangents, place, 0).xyz;
    if (normal == vec3(0.0)) return vec3(0.0, 0.0, 1.0);
    vec3 gradient = {4} * (vec3(bump_input(solid_point(texel)).yzw) * height_linear);
    vec3 along = gradient - dot(gradient, normal) * normal;
    if (along == vec3(0.0)) return vec3(0.0, 0.0, 1.0);
    vec3 v = normalize(normal - along), bitangent = frame.w * cross(normal, tangent);
    float slant = dot(tangent, normal), right = dot(tangent, v), up = dot(normal, v);
    vec3 c = vec3(right - slant * up, dot(bitangent, v), max(up - slant * right, 0.0));
    return dot(bitangent, bitangent) > 1e-12 && dot(c, c) > 0.0 ? normalize(c) : vec3(0.0, 0.0, 1.0);
}}
)",
                       output, vector_text(linear[0]), vector_text(linear[1]),
                       vector_text(linear[2]), glsl_number(recipe.bump.height, GlslReal::float32));
}

/// The last part of the shader: an output per picture. `color` is an expression of the base colour
/// of `texel`; without planes it is all that there is.
std::string outputs_text(const Recipe& recipe, const std::vector<PicturePlan>& plans,
                         const std::string& color, bool bumps) {
    // The lines of texels that filters read have the tile's corner already.
    std::string text = recipe.filter.kind == FilterKind::none ? "uniform ivec2 tile_origin;\n" : "";
    text +=
        "float code(real light) { return float(srgb8(light)) / 255.0; }\n"
        "layout(location = 0) out vec4 picture0;\n";
    if (has_color_paint(recipe.paint))
        text += "uniform sampler2D paint;  // premultiplied linear light\n";
    for (std::size_t i = 1; i <= plans.size(); ++i)
        text += fmt::format("layout(location = {0}) out vec4 picture{0};\n", i);
    if (bumps) text += bumps_text(recipe, plans.size() + 1);
    text += "void main() {\n    ivec2 texel = ivec2(gl_FragCoord.xy) - tile_origin;\n";
    if (has_glsl_planes(recipe.texture))
        text +=
            "    TexturePlanes planes = texture_planes(solid_point(texel));\n"
            "    real4 color = planes.base_color;\n";
    else
        text += fmt::format("    real4 color = real4({}, 1.0);\n", color);
    if (has_color_paint(recipe.paint))
        text +=
            "    vec4 over = texelFetch(paint, ivec2(gl_FragCoord.xy), 0);\n"
            "    color.rgb = over.rgb + (1.0 - over.a) * color.rgb;\n";
    text += "    picture0 = vec4(code(color.r), code(color.g), code(color.b), 1.0);\n";
    const std::vector<std::string> planes = plane_texts(recipe.texture);
    for (std::size_t i = 0; i < plans.size(); ++i) {
        std::array<std::string, 4> all;
        for (std::size_t c = 0; c < 4; ++c) all[c] = component_text(plans[i], c, planes);
        text += fmt::format("    picture{} = vec4({});\n", i + 1, fmt::join(all, ", "));
    }
    if (bumps)
        text += fmt::format(
            "    picture{} = vec4(0.5 + 0.5 * bumped(ivec2(gl_FragCoord.xy), texel), 1.0);\n",
            plans.size() + 1);
    return text + "}\n";
}

/// How many numbers a shader may hold beside its other uniforms.
std::size_t most_numbers(const GladGLContext& gl) {
    GLint components = 0;
    gl.GetIntegerv(GL_MAX_FRAGMENT_UNIFORM_COMPONENTS, &components);
    return std::size_t(std::max(components - other_components, 0));
}

/// A texture of this side with memory for all levels.
GlTexture make_image(const GladGLContext& gl, int side, bool is_color) {
    GlTexture texture(gl);
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D, texture.get());
    int level = 0;
    for (int size = side;; size /= 2, ++level) {
        gl.TexImage2D(GL_TEXTURE_2D, level, is_color ? GL_SRGB8_ALPHA8 : GL_RGBA8, size, size, 0,
                      GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        if (size <= 1) break;
    }
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, level);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    check_gl(gl, fmt::format("making a texture of {0}x{0} texels", side));
    return texture;
}

}  // namespace

void make_levels(const GladGLContext& gl, const GlTexture& texture) {
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D, texture.get());
    gl.GenerateMipmap(GL_TEXTURE_2D);
}

Image<Rgb8> read_texels(const GladGLContext& gl, const GlPictures& pictures) {
    const auto side = std::size_t(pictures.side);
    Image<Rgb8> texels(side, side);
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D, pictures.images[0].get());
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGB, GL_UNSIGNED_BYTE, texels.row(0).data());
    check_gl(gl, "reading a texture");
    return texels;
}

std::shared_ptr<GlPictures> GlPicturePool::take(int side, const std::vector<bool>& is_color) {
    std::erase_if(kept_, [&](const auto& one) {
        return one.use_count() == 1 && (one->side != side || one->is_color != is_color);
    });
    for (const auto& one : kept_)
        if (one.use_count() == 1) return one;
    auto made = std::make_shared<GlPictures>();
    made->side = side;
    made->is_color = is_color;
    for (const bool color : is_color) made->images.push_back(make_image(*gl_, side, color));
    return kept_.emplace_back(std::move(made));
}

const GlTexture& GlPaint::show(const SolidAtlas& solid, std::span<const PaintStroke> strokes) {
    constexpr std::uint32_t side = PaintTiles::side;
    if (!layer_) layer_.emplace(solid, 0);
    if (!texture_) {
        const std::vector<Vec4f> none(std::size_t(solid.size) * solid.size, Vec4f(0.0f));
        texture_ =
            make_texture(*gl_, GL_RGBA32F, GlSize(int(solid.size)), std::span<const Vec4f>(none));
    }
    const PaintWork work = layer_->update(strokes_of(strokes, 0));
    gl_->ActiveTexture(GL_TEXTURE0);
    gl_->BindTexture(GL_TEXTURE_2D, texture_->get());
    const std::vector<PaintLight> clear(std::size_t(side) * side, PaintLight(0.0f));
    gl_->PixelStorei(GL_UNPACK_ROW_LENGTH, int(side));
    for (const std::uint32_t tile : work.tiles) {
        const std::uint32_t columns = layer_->tiles().columns();
        const std::uint32_t x = tile % columns * side, y = tile / columns * side;
        const std::span<const PaintLight> paint = layer_->paint(tile);
        gl_->TexSubImage2D(GL_TEXTURE_2D, 0, int(x), int(y), int(std::min(side, solid.size - x)),
                           int(std::min(side, solid.size - y)), GL_RGBA, GL_FLOAT,
                           paint.empty() ? clear.data() : paint.data());
    }
    gl_->PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    check_gl(*gl_, "uploading paint");
    return *texture_;
}

void GlPaint::forget_atlas() {
    layer_.reset();
    texture_.reset();
}

GlPictureMaker::GlPictureMaker(GlContext& context)
    : gl_(&context.gl()),
      graph_(*gl_, false, map_budget),
      pass_(*gl_),
      framebuffer_(*gl_),
      pool_(*gl_),
      paint_(*gl_) {}

std::string GlPictureMaker::problem(const Recipe& recipe) const {
    if (recipe.precision.kind.value_or(PrecisionKind::float32) != PrecisionKind::float32)
        return "OpenGL computes in float32, and another precision is asked for";
    const bool filtered = recipe.filter.kind != FilterKind::none || recipe.filter.band_limit;
    if (filtered && has_glsl_planes(recipe.texture))
        return "filtered materials are made on the host alone";
    if (std::string why = graph_.problem(recipe.texture, recipe.filter); !why.empty()) return why;
    const std::string mask = first_mask_node(recipe.texture, GraphOutput::planes);
    if (!mask.empty()) return no_texels_for(mask);
    const std::string node = first_host_node(recipe.texture, GraphOutput::planes);
    return node.empty() ? "" : fmt::format("its node \"{}\" is evaluated on the host alone", node);
}

bool GlPictureMaker::makes_bumps(const Recipe& recipe) const {
    const bool filtered = recipe.filter.kind != FilterKind::none || recipe.filter.band_limit;
    return !recipe.bump.empty() && !filtered && no_height_shader(recipe.bump.input).empty() &&
           graph_noises(recipe.bump.input, GraphOutput::color) <= most_shader_noises;
}

void GlPictureMaker::set_frames(const FrameMaps& frames) {
    const GlSize size{int(frames.normals.width()), int(frames.normals.height())};
    frames_ = Frames{make_texture(*gl_, GL_RGBA32F, size, frames.normals.pixels()),
                     make_texture(*gl_, GL_RGBA32F, size, frames.tangents.pixels())};
}

/// Binds what the graph does not read.
void GlPictureMaker::bind_inputs(const GlProgram& program, const GlTexture* paint) const {
    if (paint) bind_texture(*gl_, program, "paint", paint_unit, *paint);
    if (!frames_) return;
    bind_texture(*gl_, program, "frame_normals", normals_unit, frames_->normals);
    bind_texture(*gl_, program, "frame_tangents", tangents_unit, frames_->tangents);
}

/// The program of a recipe, which stays until the atlas is forgotten; sets graph_.
GlPictureMaker::Material GlPictureMaker::material(const Recipe& recipe,
                                                  const std::vector<PicturePlan>& plans,
                                                  const SolidAtlas& solid) {
    const bool bumps = draws_bumps(recipe);
    ShaderSource source = graph_.set_material(
        solid, recipe.texture, bumps ? recipe.bump.input : TextureGraph(),
        texture_from_solid(recipe), recipe.filter,
        [&](const std::string& color) { return outputs_text(recipe, plans, color, bumps); });
    const std::vector<float> numbers = source.take_numbers(most_numbers(*gl_));
    std::vector<Vec4f> fours((numbers.size() + 3) / 4, Vec4f(0.0f));
    for (std::size_t i = 0; i < numbers.size(); ++i) fours[i / 4][int(i % 4)] = numbers[i];
    if (programs_.size() >= most_programs) programs_.clear();
    std::string text = source.text();
    auto found = programs_.find(text);
    if (found == programs_.end())
        found =
            programs_.emplace(std::move(text), make_full_screen_program(*gl_, "a material", source))
                .first;
    return {&found->second, std::move(fours)};
}

/// Fills level 0 of the textures, tile by tile.
void GlPictureMaker::draw(const GlPictures& into, const Material& material,
                          const GlTexture* paint) {
    const GlProgram& program = *material.program;
    gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
    std::vector<GLenum> outputs;
    for (std::size_t i = 0; i < most_pictures; ++i) {
        const GLenum place = GLenum(GL_COLOR_ATTACHMENT0 + i);
        const bool used = i < into.images.size();
        gl_->FramebufferTexture2D(GL_FRAMEBUFFER, place, GL_TEXTURE_2D,
                                  used ? into.images[i].get() : 0, 0);
        if (used) outputs.push_back(place);
    }
    gl_->DrawBuffers(GLsizei(outputs.size()), outputs.data());
    for (const GLenum off : {GL_BLEND, GL_DEPTH_TEST, GL_FRAMEBUFFER_SRGB}) gl_->Disable(off);
    for_tiles(GlSize(into.side), tile_side, [&](const GlTile& tile) {
        const auto points = graph_.set_tile(tile);
        gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
        gl_->Viewport(tile.origin.x, tile.origin.y, tile.size.x, tile.size.y);
        program.use();
        graph_.bind<Rgb8>(program, points.get());
        program.set("tile_origin", tile.origin);
        if (!material.numbers.empty()) program.set("generated_numbers", material.numbers);
        bind_inputs(program, paint);
        pass_.draw();
    });
    check_gl(*gl_, "drawing a material");
}

std::shared_ptr<const GlPictures> GlPictureMaker::make(const SolidAtlas& solid,
                                                       const Recipe& recipe,
                                                       const std::vector<PicturePlan>& plans) {
    std::string why = problem(recipe);
    if (why.empty() && plans.size() + 2 > most_pictures) why = "it has too many pictures";
    if (!why.empty()) throw Error(ExitCode::unsupported, why);
    std::vector<bool> is_color{true};
    for (const PicturePlan& plan : plans) is_color.push_back(plan.is_color);
    if (draws_bumps(recipe)) is_color.push_back(false);
    const std::shared_ptr<GlPictures> pictures = pool_.take(int(solid.size), is_color);
    const Material made = material(recipe, plans, solid);
    const GlTexture* paint =
        has_color_paint(recipe.paint) ? &paint_.show(solid, recipe.paint) : nullptr;
    draw(*pictures, made, paint);
    graph_.finish();
    for (const GlTexture& image : pictures->images) make_levels(*gl_, image);
    gl_->Finish();
    check_gl(*gl_, "drawing MIP levels");
    return pictures;
}

void GlPictureMaker::forget_atlas() {
    graph_.forget_atlas();
    paint_.forget_atlas();
    frames_.reset();
}

GlPassMaker::GlPassMaker(GlContext& context)
    : gl_(&context.gl()), passes_(context, {}), framebuffer_(*gl_), pool_(*gl_) {}

std::string GlPassMaker::problem(const Recipe& recipe) const {
    if (recipe.filter.kind != FilterKind::none || recipe.filter.band_limit)
        return "the papers' passes have no filters";
    if (has_color_paint(recipe.paint)) return "the papers' passes have no paint";
    if (has_glsl_planes(recipe.texture)) return "the papers' passes make a colour alone";
    if (recipe.atlas.size > std::uint32_t(largest_tile))
        return fmt::format("the papers' passes are shown up to {} texels a side", largest_tile);
    const Texture* texture = plain_texture(recipe.texture);
    return texture ? passes_.problem(*texture)
                   : "the papers' passes make no other textures than an opaque color_map over a "
                     "field";
}

std::shared_ptr<const GlPictures> GlPassMaker::make(const SolidAtlas& solid, const Recipe& recipe,
                                                    std::size_t count) {
    if (const std::string why = problem(recipe); !why.empty())
        throw Error(ExitCode::unsupported, why);
    const std::shared_ptr<GlPictures> pictures = pool_.take(int(solid.size), {true});
    const auto begin = [&] {
        gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
        gl_->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                                  pictures->images[0].get(), 0);
        gl_->Viewport(0, 0, pictures->side, pictures->side);
        gl_->Disable(GL_FRAMEBUFFER_SRGB);
    };
    const std::optional<Pass> pass = passes_.show(solid, *plain_texture(recipe.texture),
                                                  texture_from_solid(recipe), count, begin);
    shown_.count = passes_.passes();
    shown_.number = std::min(count, shown_.count);
    shown_.words = pass ? words_of(*pass) : "colour";
    make_levels(*gl_, pictures->images[0]);
    gl_->Finish();
    return pictures;
}

}  // namespace burl
