#include "app/gl/fill/spans.h"

#include <algorithm>

#include "atlas/base/error.h"
#include "procedural/maps/point_map.h"
#include "procedural/noise/lattice_site.h"

namespace burl {

namespace {

/// The number of RGBA32UI texels that a TexelMap takes in memory.
constexpr std::size_t map_texels = 5;
static_assert(sizeof(TexelMap) == map_texels * sizeof(glm::uvec4));
static_assert(sizeof(Span) == sizeof(glm::uvec3));

std::vector<std::uint32_t> row_numbers(const SolidAtlas& solid) {
    std::vector<std::uint32_t> rows(solid.spans.size());
    for (std::uint32_t y = 0; y < solid.size; ++y)
        std::fill(rows.begin() + std::ptrdiff_t(solid.row_begin[y]),
                  rows.begin() + std::ptrdiff_t(solid.row_begin[y + 1]), y);
    return rows;
}

template <class T>
GlBuffer make_array(const GladGLContext& gl, const std::vector<T>& elements) {
    GlBuffer buffer(gl);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer.get());
    gl.BufferData(GL_ARRAY_BUFFER, GLsizeiptr(elements.size() * sizeof(T)), elements.data(),
                  GL_STATIC_DRAW);
    return buffer;
}

/// Sets an instanced attribute to the elements of the bound array buffer from `first` on.
void set_attribute(const GladGLContext& gl, GLuint index, GLint components, std::size_t first) {
    const std::size_t stride = std::size_t(components) * sizeof(std::uint32_t);
    gl.EnableVertexAttribArray(index);
    gl.VertexAttribIPointer(index, components, GL_UNSIGNED_INT, GLsizei(stride),
                            reinterpret_cast<const void*>(first * stride));
    gl.VertexAttribDivisor(index, 1);
}

bool can_draw(const GladGLContext& gl, const SolidAtlas& solid) {
    GLint most = 0;
    gl.GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    return has_float64(gl) && gl.Uniform1d != nullptr &&
           map_texels * solid.maps.size() <= std::size_t(most);
}

std::span<const TexelMap> checked(const GladGLContext& gl, const SolidAtlas& solid,
                                  std::span<const TexelMap> maps) {
    if (can_draw(gl, solid)) return maps;
    throw Error(ExitCode::unsupported,
                "this OpenGL cannot draw an atlas's spans: it has no float64 (OpenGL 4.0 brings "
                "it), or its arrays are too small");
}

}  // namespace

bool draws_maps(const GladGLContext& gl, const SolidAtlas& solid, MapFill fill) {
    if (fill != MapFill::automatic) return fill == MapFill::gpu;
    return !is_software(gl) && can_draw(gl, solid);
}

GlProgram GlSpans::make_program(const GladGLContext& gl, std::string_view vertex,
                                std::string_view fragment) {
    ShaderSource parts[2];
    for (ShaderSource& part : parts)
        part.extension("GL_ARB_gpu_shader_fp64").extension("GL_ARB_gpu_shader5");
    parts[0].add("maps/span.glsl").add(vertex);
    parts[1].add("maps/line.glsl").add(fragment);
    return {gl, std::string(vertex), parts[0], parts[1]};
}

GlSpans::GlSpans(const GladGLContext& gl, const SolidAtlas& solid, std::span<const TexelMap> maps)
    : gl_(&gl),
      vertices_(gl),
      spans_(make_array(gl, solid.spans)),
      rows_(make_array(gl, row_numbers(solid))),
      maps_(gl, GL_RGBA32UI, checked(gl, solid, maps)),
      row_begin_(solid.row_begin) {
    check_gl(gl, "uploading an atlas's spans");
}

void GlSpans::draw(const GlProgram& program, const GlTile& tile) const {
    const std::size_t begin = row_begin_[std::size_t(tile.origin.y)],
                      end = row_begin_[std::size_t(tile.origin.y + tile.size.y)];
    if (begin == end) return;
    maps_.bind(program, "texel_maps", 0);
    program.set("tile_origin", tile.origin);
    program.set("tile_size", tile.size);
    gl_->BindVertexArray(vertices_.get());
    gl_->BindBuffer(GL_ARRAY_BUFFER, spans_.get());
    set_attribute(*gl_, 0, 3, begin);
    gl_->BindBuffer(GL_ARRAY_BUFFER, rows_.get());
    set_attribute(*gl_, 1, 1, begin);
    gl_->DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, GLsizei(end - begin));
    check_gl(*gl_, "drawing an atlas's spans");
}

void GlTexelLines::set_atlas(const SolidAtlas& solid, std::span<const TexelMap> maps, int threads) {
    static_assert(sizeof(TexelMap) % sizeof(MapTexel) == 0);
    maps_.emplace(*gl_, GLenum(GL_RGBA32UI), std::as_bytes(maps));
    spans_.clear();
    solid_ = &solid;
    threads_ = threads;
}

void GlTexelLines::forget_atlas() {
    spans_.clear();
    maps_.reset();
    solid_ = nullptr;
}

void GlTexelLines::set_tile(const GlTile& tile) {
    const auto known = std::ranges::find(spans_, tile, &Spans::tile);
    if (known != spans_.end()) {
        std::rotate(known, known + 1, spans_.end());
        return;
    }
    std::size_t bytes = 0;
    for (const Spans& spans : spans_) bytes += sizeof(MapTexel) * spans.tile.texels();
    if (!spans_.empty() && bytes >= budget_) spans_.pop_back();
    const Image<MapTexel> texels = fill_span_map(*solid_, area_of(tile), threads_);
    spans_.push_back(
        {tile, make_texture(*gl_, GL_RGBA32UI, tile.size, std::as_bytes(texels.pixels()))});
}

void GlTexelLines::bind(const GlProgram& program, int first_unit) const {
    bind_texture(*gl_, program, "span_map", first_unit, spans_.back().texture);
    maps_->bind(program, "texel_maps", first_unit + 1);
    program.set("tile_origin", spans_.back().tile.origin);
}

}  // namespace burl
