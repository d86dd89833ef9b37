#include "app/gl/fill/map_filter.h"

#include <utility>

#include <fmt/format.h>

#include "app/gl/fill/output.h"
#include "app/gl/fill/spans.h"
#include "procedural/color/map_pieces.h"
#include "procedural/color/mip.h"
#include "procedural/color/srgb.h"
#include "procedural/color/sums.h"
#include "procedural/fill/pieces.h"
#include "procedural/glsl/colors.h"
#include "procedural/maps/slope_map.h"

namespace burl {

namespace {

GlBufferTexture distance_table(const GladGLContext& gl, const MapPieces& map) {
    const BreakDistance distances(map);
    return {gl, GL_R32F,
            std::as_bytes(std::span(distances.data(), BreakDistance::entry_count + 1))};
}

GlBufferTexture color_table(const GladGLContext& gl, std::span<const Vec3d> colors) {
    return {gl, GL_RGBA32UI, std::as_bytes(std::span<const TableTexel>(color_texels(colors)))};
}

/// A buffer texture of at least one texel: `fill` where there are none.
template <class Texel>
GlBufferTexture table(const GladGLContext& gl, GLenum internal, std::vector<Texel> texels,
                      const Texel& fill) {
    if (texels.empty()) texels.push_back(fill);
    return {gl, internal, std::as_bytes(std::span(texels))};
}

}  // namespace

GlMapFilter::GlMapFilter(const GladGLContext& gl, bool float64, std::size_t budget)
    : gl_(&gl), float64_(float64), budget_(budget), lines_(gl, budget), srgb8_(srgb8_table(gl)) {}

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
    lines_.forget_atlas();
    lines_known_ = false;
    solid_ = nullptr;
}

void GlMapFilter::set_map(const ColorMap& map, const Filter& filter) {
    if (std::exchange(map_known_, true) && map == map_ && filter == filter_) return;
    map_ = map;
    filter_ = filter;
    pieces_.reset();
    table_.reset();
    if (tabled()) return make_table();
    if (!has_colors() || !has_means()) return;
    const MapPieces pieces(map);
    const MapBreaks breaks(pieces);
    pieces_.emplace(Pieces{filter_shape(breaks, filter.kind), filter_uniforms(breaks),
                           distance_table(*gl_, pieces)});
}

void GlMapFilter::make_table() {
    const Vec3d background = PreparedColorMap(map_)(0.0);
    if (filter_.kind == FilterKind::table_mip) {
        std::vector<Vec3d> colors;
        const ColorMip mip(map_);
        for (const auto& level : mip.levels())
            colors.insert(colors.end(), level.begin(), level.end());
        table_.emplace(Table{color_table(*gl_, colors), background});
        return;
    }
    const ColorSums sums(map_, filter_.kind == FilterKind::table_sat3);
    table_.emplace(Table{color_table(*gl_, sums.sums()), background, sums.first(),
                         int(sums.sums().size()), sums.ends()});
}

void GlMapFilter::set_field(const FieldOctaves& octaves, const Quadric& quadric) {
    quadric_ = quadric;
    lone_octaves_ = !octaves.lone.empty();
    line_uniforms_ = line_uniforms(octaves, quadric);
    if (!beside_centres())
        sides_.emplace(table(*gl_, GL_RGBA32F, lattice_sides(maps_, octaves.groups), Vec4f(0.0f)));
    if (!filter_.band_limit) return;
    shares_.emplace(table(*gl_, GL_R32F, octave_shares(maps_, octaves.groups), 1.0f));
    lone_terms_.emplace(table(*gl_, GL_RGBA32UI, lone_terms(maps_, octaves.lone), Vec2d(0.0)));
}

void GlMapFilter::set_tile(const GlTile& tile) {
    if (!beside_centres()) slopes_ = slope_map(tile);
    if (!has_lines()) return;
    if (!lines_known_) lines_.set_atlas(*solid_, maps_, threads_);
    lines_known_ = true;
    lines_.set_tile(tile);
}

/// The slope map of a tile, from the cache where it is there; those of other quadrics are dropped.
std::shared_ptr<const GlTexture> GlMapFilter::slope_map(const GlTile& tile) {
    std::erase_if(kept_, [&](const SlopeMap& kept) {
        if (kept.quadric != quadric_) bytes_ -= sizeof(MapTexel) * kept.tile.texels();
        return kept.quadric != quadric_;
    });
    for (const SlopeMap& kept : kept_)
        if (kept.tile == tile) return kept.texture;
    const Image<MapTexel> texels =
        fill_slope_map(*solid_, maps_, quadric_, area_of(tile), threads_);
    auto texture = std::make_shared<const GlTexture>(
        make_texture(*gl_, GL_RGBA32UI, tile.size, std::as_bytes(texels.pixels())));
    if (bytes_ + sizeof(MapTexel) * tile.texels() <= budget_) {
        bytes_ += sizeof(MapTexel) * tile.texels();
        kept_.push_back({quadric_, tile, texture});
    }
    return texture;
}

void GlMapFilter::add(ShaderSource& source, const FieldShape& shape) const {
    add_parts(source, beside_centres() ? glsl_field_corners(shape, filter_.band_limit)
                                       : glsl_field_slopes(shape, filter_.band_limit));
    if (pieces_)
        source.add("color/box_width.glsl")
            .add("color/map_filter.glsl")
            .add("filter", glsl_map_filter(pieces_->shape));
}

void GlMapFilter::add_field(ShaderSource& source, const FieldShape& shape) const {
    add(source, shape);
    const char* test = pieces_ ? "    if (has_break(f, slopes)) discard;\n" : "";
    source.add("straight", fmt::format("real field(ivec2 texel) {{\n"
                                       "    vec2 slopes;\n"
                                       "    real f = field_and_slopes(texel, slopes);\n"
                                       "{}"
                                       "    return f;\n"
                                       "}}\n",
                                       test));
}

void GlMapFilter::add_means(ShaderSource& source, const FieldShape& shape) const {
    if (sampled()) return add_parts(source, glsl_supersampled(shape, filter_.band_limit));
    add(source, shape);
    source.define("COLOR_REPEATS", map_.wrap == Wrap::repeat ? "1" : "0").add("color/index.glsl");
    if (pieces_) {
        source.add("means", R"(
real3 mean_color(ivec2 texel) {
    vec2 slopes;
    real f = field_and_slopes(texel, slopes);
    return filtered_mean(f, slopes);
}
)");
        return;
    }
    source.add("color/box_width.glsl").add("color/table.glsl");
    if (filter_.kind == FilterKind::table_mip)
        source.define("COLOR_MIP_FINEST", fmt::format("{}", ColorMip::finest))
            .add("numbers/elementary.glsl")
            .add("color/mip.glsl");
    else
        source.add("color/sums.glsl");
    source.add("means", R"(
real3 mean_color(ivec2 texel) {
    vec2 slopes;
    real f = field_and_slopes(texel, slopes);
    real u = abs(real(slopes.x)), v = abs(real(slopes.y));
    real3 mean = table_mean(f, box_width(max(u, v), min(u, v)));
    return isnan(f) ? background : mean;
}
)");
}

void GlMapFilter::bind_pieces(const GlProgram& program, int unit) const {
    pieces_->distances.bind(program, "break_distances", unit);
    const FilterUniforms& uniforms = pieces_->uniforms;
    program.set_reals("map_base", std::span(&uniforms.map_base, 1), float64_);
    program.set_reals("break_jumps", uniforms.break_jumps, float64_);
    program.set_reals("break_kinks", uniforms.break_kinks, float64_);
    program.set_reals("break_positions", uniforms.break_positions, float64_);
}

void GlMapFilter::bind_table(const GlProgram& program, int unit) const {
    table_->colors.bind(program, "color_table", unit);
    program.set("sums_count", table_->count);
    program.set_reals("background", std::span(&table_->background, 1), float64_);
    program.set_reals("sums_first", std::span(&table_->first, 1), float64_);
    program.set_reals("sums_ends", table_->ends, float64_);
}

void GlMapFilter::bind_lines(const GlProgram& program, int first_unit) const {
    lines_.bind(program, first_unit);
    program.set_reals("lattices", line_uniforms_.lattices, float64_);
    program.set_reals("lone_lattices", line_uniforms_.lone_lattices, float64_);
    program.set_reals("lattice_limits", line_uniforms_.lattice_limits, float64_);
    program.set_reals("quadric", line_uniforms_.quadric, float64_);
    bind_pattern(program, SamplePattern(filter_.samples));
}

void GlMapFilter::bind(const GlProgram& program, int first_unit) const {
    const int lines_unit = beside_centres() ? first_unit : first_unit + 6;
    if (has_lines()) bind_lines(program, lines_unit);
    if (!beside_centres()) {
        bind_texture(*gl_, program, "slope_map", first_unit, *slopes_);
        sides_->bind(program, "lattice_sides", first_unit + 1);
    }
    srgb8_.bind(program, "srgb8_buckets", first_unit + 2);
    if (pieces_) bind_pieces(program, first_unit + 3);
    if (table_) bind_table(program, first_unit + 3);
    // Samplers of different types must name different units, whether they are read or not.
    program.set("octave_shares", first_unit + 4);
    program.set("lone_terms", first_unit + 5);
    if (!filter_.band_limit) return;
    shares_->bind(program, "octave_shares", first_unit + 4);
    lone_terms_->bind(program, "lone_terms", first_unit + 5);
}

void GlMapFilter::draw(const GlFullScreen& full_screen, GlSize target, const GlProgram& straight,
                       const GlProgram& bent) {
    if (depth_size_ != target) {
        depth_ = GlRenderbuffer(*gl_);
        gl_->BindRenderbuffer(GL_RENDERBUFFER, depth_.get());
        gl_->RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, target.x, target.y);
        depth_size_ = target;
    }
    const auto attach = [&](GLuint depth) {
        gl_->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    };
    attach(depth_.get());
    gl_->Enable(GL_DEPTH_TEST);
    gl_->DepthFunc(GL_LESS);
    gl_->Clear(GL_DEPTH_BUFFER_BIT);  // the clear value is 1
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
