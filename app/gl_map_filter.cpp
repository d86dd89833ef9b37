#include "app/gl_map_filter.h"

#include <fmt/format.h>

#include "app/gl_color_tables.h"
#include "app/gl_map_upload.h"
#include "procedural/break_distance.h"
#include "procedural/srgb_kernels.h"
#include "procedural/synthesize_pieces.h"
#include "procedural/synthesize_slope_map.h"

namespace burl {

namespace {

GlBufferTexture distance_table(const GladGLContext& gl, const MapPieces& map) {
    const BreakDistance distances(map);
    return {gl, GL_R32F,
            std::as_bytes(std::span(distances.data(), BreakDistance::entry_count + 1))};
}

}  // namespace

GlMapFilter::GlMapFilter(const GladGLContext& gl, bool float64, std::size_t budget)
    : gl_(&gl), float64_(float64), budget_(budget), srgb8_(srgb8_table(gl)) {}

void GlMapFilter::set_atlas(const SolidAtlas& solid, const Affine3& texture_from_atlas,
                            int threads) {
    threads_ = threads;
    if (solid_ == &solid && texture_from_atlas_ == texture_from_atlas) return;
    forget_atlas();
    maps_ = moved_maps(solid.maps, texture_from_atlas, threads);
    solid_ = &solid;
    texture_from_atlas_ = texture_from_atlas;
}

void GlMapFilter::forget_atlas() {
    kept_.clear();
    bytes_ = 0;
    slopes_.reset();
    solid_ = nullptr;
}

void GlMapFilter::set_map(const ColorMap& map, const Filter& filter) {
    if (tables_ && map == map_ && filter == filter_) return;
    map_ = map;
    filter_ = filter;
    const MapPieces pieces(map);
    const MapBreaks breaks(pieces);
    tables_.emplace(Tables{filter_shape(breaks, filter.kind), filter_uniforms(breaks),
                           distance_table(*gl_, pieces)});
}

void GlMapFilter::set_field(std::span<const OctaveGroup> groups) {
    std::vector<Vec4f> sides = lattice_sides(maps_, groups);
    if (sides.empty()) sides.emplace_back(0.0f);
    sides_.emplace(*gl_, GLenum(GL_RGBA32F), std::as_bytes(std::span(sides)));
    if (!filter_.band_limit) return;
    std::vector<float> shares = octave_shares(maps_, groups);
    if (shares.empty()) shares.push_back(1.0f);
    shares_.emplace(*gl_, GLenum(GL_R32F), std::as_bytes(std::span(shares)));
}

/// Other quadrics' are dropped.
std::shared_ptr<const GlTexture> GlMapFilter::slope_map(const Quadric& quadric,
                                                        const GlTile& tile) {
    std::erase_if(kept_, [&](const SlopeMap& kept) {
        if (kept.quadric != quadric) bytes_ -= sizeof(MapTexel) * kept.tile.texels();
        return kept.quadric != quadric;
    });
    for (const SlopeMap& kept : kept_)
        if (kept.tile == tile) return kept.texture;
    const Image<MapTexel> texels = fill_slope_map(*solid_, maps_, quadric, area_of(tile), threads_);
    auto texture = std::make_shared<const GlTexture>(
        make_texture(*gl_, GL_RGBA32UI, tile.size, std::as_bytes(texels.pixels())));
    if (bytes_ + sizeof(MapTexel) * tile.texels() <= budget_) {
        bytes_ += sizeof(MapTexel) * tile.texels();
        kept_.push_back({quadric, tile, texture});
    }
    return texture;
}

void GlMapFilter::add(ShaderSource& source, const FieldShape& shape) const {
    add_parts(source, glsl_field_slopes(shape, filter_.band_limit));
    if (!has_means()) return;
    source.add("map_filter.glsl").add("filter", glsl_map_filter(tables_->shape));
}

void GlMapFilter::add_field(ShaderSource& source, const FieldShape& shape) const {
    add(source, shape);
    const char* test = has_means() ? "    if (has_break(f, slopes)) discard;\n" : "";
    source.add("straight", fmt::format("real field(ivec2 texel) {{\n"
                                       "    vec2 slopes;\n"
                                       "    real f = field_and_slopes(texel, slopes);\n"
                                       "{}"
                                       "    return f;\n"
                                       "}}\n",
                                       test));
}

void GlMapFilter::add_means(ShaderSource& source, const FieldShape& shape) const {
    add(source, shape);
    source.define("COLOR_REPEATS", map_.wrap == Wrap::repeat ? "1" : "0")
        .add("color_index.glsl")
        .add("means", R"(
real3 mean_color(ivec2 texel) {
    vec2 slopes;
    real f = field_and_slopes(texel, slopes);
    return filtered_mean(f, slopes);
}
)");
}

/// Of a `real` uniform array, or one of real3.
void GlMapFilter::set_numbers(const GlProgram& program, const char* name,
                              std::span<const double> values, int components) const {
    const std::vector<float> floats(values.begin(), values.end());
    const GLint at = program.uniform(name);
    const auto count = GLsizei(values.size()) / components;
    if (components == 1 && float64_)
        gl_->Uniform1dv(at, count, values.data());
    else if (components == 1)
        gl_->Uniform1fv(at, count, floats.data());
    else if (float64_)
        gl_->Uniform3dv(at, count, values.data());
    else
        gl_->Uniform3fv(at, count, floats.data());
}

void GlMapFilter::bind(const GlProgram& program, int first_unit) const {
    bind_texture(*gl_, first_unit, *slopes_);
    sides_->bind(first_unit + 1);
    tables_->distances.bind(first_unit + 2);
    srgb8_.bind(first_unit + 3);
    program.set("slope_map", first_unit);
    program.set("lattice_sides", first_unit + 1);
    program.set("break_distances", first_unit + 2);
    program.set("srgb8_buckets", first_unit + 3);
    if (filter_.band_limit) shares_->bind(first_unit + 4);
    program.set("octave_shares", first_unit + 4);
    const auto colors = [&](const char* name, std::span<const Vec3d> values) {
        if (!values.empty()) set_numbers(program, name, {&values[0].x, 3 * values.size()}, 3);
    };
    const FilterUniforms& uniforms = tables_->uniforms;
    colors("map_base", std::span(&uniforms.map_base, 1));
    colors("break_jumps", uniforms.break_jumps);
    colors("break_kinks", uniforms.break_kinks);
    set_numbers(program, "break_positions", uniforms.break_positions, 1);
}

void GlMapFilter::draw(const GlFullScreen& full_screen, GlSize target, const GlProgram& straight,
                       const GlProgram& bent) {
    if (depth_size_ != target) {
        GLuint name = 0;
        gl_->GenRenderbuffers(1, &name);
        depth_ = GlRenderbuffer(*gl_, name);
        gl_->BindRenderbuffer(GL_RENDERBUFFER, name);
        gl_->RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, target.x, target.y);
        depth_size_ = target;
    }
    const auto attach = [&](GLuint depth) {
        gl_->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    };
    attach(depth_.get());
    gl_->Enable(GL_DEPTH_TEST);
    gl_->DepthFunc(GL_LESS);
    gl_->Clear(GL_DEPTH_BUFFER_BIT);  // to 1
    gl_->DepthRange(0.0, 0.0);
    straight.use();
    full_screen.draw();
    gl_->DepthRange(0.5, 0.5);
    bent.use();
    full_screen.draw();
    gl_->DepthRange(0.0, 1.0);
    gl_->Disable(GL_DEPTH_TEST);
    attach(0);
    check_gl(*gl_, "filtering");
}

}  // namespace burl
