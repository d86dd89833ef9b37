#include "app/gl/fill/fixed_synthesize.h"

#include <fmt/format.h>

#include "app/base/stopwatch.h"
#include "app/gl/fill/synthesize.h"
#include "procedural/fill/sparse.h"

namespace burl {

namespace {

static_assert(sizeof(ColorCode) == sizeof(std::uint32_t));

/// Rows that are read back at a time: they stay in a cache until they are packed.
constexpr int strip_rows = 64;

/// Of an atlas's texels, open ones cost more than a draw in float64 that decides them all.
std::size_t most_undecided(const SolidAtlas& solid) {
    return std::size_t(solid.size) * solid.size / 32 + 64;
}

int limit_of(const GladGLContext& gl, GLenum name) {
    GLint limit = 0;
    gl.GetIntegerv(name, &limit);
    return limit;
}

void define(ShaderSource& source, const FixedShape& shape) {
    for (const auto& [name, value] : glsl_fixed_macros(shape)) source.define(name, value);
}

}  // namespace

GlFixedSynthesis::GlFixedSynthesis(const GladGLContext& gl, int tile, std::size_t budget)
    : gl_(&gl), tile_(tile), full_screen_(gl), timer_(gl), maps_(gl, budget) {}

void GlFixedSynthesis::set_colors(const ColorMap& map) {
    if (colors_ && colors_->map == map) return;
    colors_.emplace(Colors{map, ColorTable8(map), {}, {}});
    colors_->fixed = fixed_colors(colors_->table);
    if (!colors_->fixed) return;
    colors_->entries.emplace(*gl_, GL_RGBA32UI,
                             std::span<const glm::uvec4>(colors_->fixed->entries));
    colors_->fixed->entries = {};
}

bool GlFixedSynthesis::fits(const FixedShape& shape) const {
    const int inputs = 4 * int(shape.octave_pairs() + shape.terms() + 2);
    const auto side = std::uint32_t(tile_);
    return inputs <= limit_of(*gl_, GL_MAX_VARYING_COMPONENTS) &&
           int(shape.groups.size()) + 2 <= limit_of(*gl_, GL_MAX_TEXTURE_IMAGE_UNITS) &&
           SiteOrder(side, side).texels() <=
               std::size_t(limit_of(*gl_, GL_MAX_TEXTURE_BUFFER_SIZE));
}

const GlProgram& GlFixedSynthesis::program(const FixedShape& shape, GlWork& work) {
    constexpr std::size_t most_programs = 64;
    ShaderSource vertex, fragment;
    vertex.add("maps/fixed_index.vert");
    fragment.define_real(false);
    define(vertex, shape);
    define(fragment, shape);
    add_parts(fragment, glsl_fixed_index(shape));
    std::string text = fragment.text();
    if (const auto found = programs_.find(text); found != programs_.end()) return found->second;
    if (programs_.size() == most_programs) programs_.clear();
    GlProgram program = timed(work.compile, [&] {
        return make_program(*gl_, "the single pass in fixed point", vertex, fragment);
    });
    return programs_.emplace(std::move(text), std::move(program)).first->second;
}

std::optional<GlFixedSynthesis::Maps> GlFixedSynthesis::maps_of(const FixedIndex& index,
                                                                const Quadric& quadric,
                                                                const GlTile& tile) {
    Maps maps{maps_.bases(quadric, index, tile), {}};
    if (!maps.bases) return std::nullopt;
    for (const OctaveGroup& group : index.groups)
        maps.sites.push_back(maps_.sites(stream_key(group), tile));
    return maps;
}

/// A tile of the picture, into target_.
void GlFixedSynthesis::draw(const GlProgram& program, const FixedIndex& index, const Maps& maps,
                            const GlTile& tile, GlWork& work) {
    const bool fits =
        target_ && target_->size().x >= tile.size.x && target_->size().y >= tile.size.y;
    if (!fits) target_.emplace(*gl_, tile.size, std::initializer_list<GLenum>{GL_R32UI});
    program.use();
    int unit = 0;
    const auto bind = [&](const std::string& name, const GlBufferTexture& texture) {
        texture.bind(unit);
        program.set(name.c_str(), unit++);
    };
    bind("color_entries", *colors_->entries);
    bind("map_bases", *maps.bases);
    for (std::size_t i = 0; i < maps.sites.size(); ++i)
        bind(fmt::format("map_sites{}", i), *maps.sites[i]);
    const SiteOrder order(std::uint32_t(tile.size.x), std::uint32_t(tile.size.y));
    const FixedUniforms uniforms =
        fixed_uniforms(index, *colors_->fixed, order.columns, colors_->table(0.0));
    const auto set = [&](const char* name, std::span<const glm::uvec4> values) {
        gl_->Uniform4uiv(program.uniform(name), GLsizei(values.size()), &values[0].x);
    };
    set("octaves", uniforms.octaves);
    set("terms", uniforms.terms);
    program.set("index", uniforms.index);
    program.set("entry", uniforms.entry);
    target_->bind({{0, 0}, tile.size});
    timer_.start();
    full_screen_.draw();
    const GlSeconds seconds = timer_.stop();
    work.draw += seconds.wall;
    work.gpu += seconds.gpu;
    ++work.passes;
}

/// Sets the tile's texels, and notes those that are open.
void GlFixedSynthesis::read_back(const GlTile& tile, Image<Rgb8>& image) {
    const auto width = std::size_t(tile.size.x);
    strip_.resize(std::max(strip_.size(), width * strip_rows));
    for (int first = 0; first < tile.size.y; first += strip_rows) {
        const int rows = std::min(strip_rows, tile.size.y - first);
        target_->read(std::span(strip_.data(), width * std::size_t(rows)),
                      {{0, first}, {tile.size.x, rows}});
        for (int row = 0; row < rows; ++row) {
            const std::span codes(strip_.data() + width * std::size_t(row), width);
            const auto y = std::uint32_t(tile.origin.y + first + row);
            pack_pixels(reinterpret_cast<const ColorCode*>(codes.data()), width,
                        &image(std::size_t(tile.origin.x), y));
            std::uint32_t all = 0;
            for (const std::uint32_t code : codes) all |= code;
            if (all >> 24 == 0) continue;
            for (std::size_t x = 0; x < width; ++x)
                if (codes[x] >> 24 != 0)
                    undecided_.emplace_back(std::uint32_t(tile.origin.x) + x, y);
        }
    }
}

bool GlFixedSynthesis::synthesize(const SolidAtlas& solid, const Texture& texture,
                                  const Affine3& texture_from_atlas, int threads,
                                  Image<Rgb8>& image, GlWork& work) {
    undecided_.clear();
    const std::optional<FixedIndex> index = fixed_index(texture);
    if (!index) return false;
    timed(work.colors, [&] { set_colors(texture.colors); });
    if (!colors_->fixed) return false;
    const FixedShape shape(*index);
    if (!fits(shape)) return false;
    maps_.set_atlas(solid, texture_from_atlas, threads);
    const GlProgram& program = this->program(shape, work);
    const int made = maps_.made();
    bool held = true;
    for_tiles({int(solid.size), int(solid.size)}, tile_, [&](const GlTile& tile) {
        if (!held || undecided_.size() > most_undecided(solid)) return;
        const auto maps = timed(work.map, [&] { return maps_of(*index, texture.quadric, tile); });
        held = maps.has_value();
        if (!held) return;
        draw(program, *index, *maps, tile, work);
        timed(work.transfer, [&] { read_back(tile, image); });
    });
    maps_.drop_unused();
    work.maps += maps_.made() - made;
    if (!held || undecided_.size() > most_undecided(solid)) return false;
    timed(work.transfer, [&] {
        synthesize_sparse(solid, maps_.texel_maps(), texture, colors_->table, undecided_, image);
    });
    return true;
}

}  // namespace burl
