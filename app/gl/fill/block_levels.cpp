#include "app/gl/fill/block_levels.h"

#include <algorithm>
#include <bit>
#include <optional>

#include "atlas/base/mip_chain.h"

namespace burl {

namespace {

bool has_current_float64(GlContext& context) {
    context.make_current();
    return has_float64(context.gl());
}

GlProgram make_pass(GlContext& context, bool even, bool gutters, bool float64) {
    const GladGLContext& gl = context.gl();
    return make_full_screen_program(gl, "the MIP levels",
                                    ShaderSource()
                                        .define_real(float64)
                                        .define("EVEN", even ? "1" : "0")
                                        .define("GUTTERS", gutters ? "1" : "0")
                                        .add("numbers/real.glsl")
                                        .add("maps/level.frag"));
}

/// The weights along an axis, three per texel of the new level, in float64 where shaders have it.
GlBufferTexture weights_of(const GladGLContext& gl, int size, bool float64) {
    std::vector<double> weights;
    for (const MipTaps& taps : mip_taps(std::size_t(size)))
        weights.insert(weights.end(), taps.weight.begin(), taps.weight.end());
    if (float64) return {gl, GL_RG32UI, std::span<const double>(weights)};
    const std::vector<float> rounded(weights.begin(), weights.end());
    return {gl, GL_R32F, std::span<const float>(rounded)};
}

int taps_of(int size) {
    return size == 1 ? 1 : 2 + size % 2;
}

GlSize half(GlSize size) {
    return glm::max(size / 2, GlSize(1));
}

/// The texels of a part of an image, rows without gaps.
template <class T>
std::vector<T> cut(const Image<T>& image, const GlTile& part) {
    std::vector<T> texels;
    texels.reserve(std::size_t(part.size.x) * std::size_t(part.size.y));
    for (int y = 0; y < part.size.y; ++y) {
        const auto row = image.row(std::size_t(part.origin.y + y))
                             .subspan(std::size_t(part.origin.x), std::size_t(part.size.x));
        texels.insert(texels.end(), row.begin(), row.end());
    }
    return texels;
}

template <class T>
GlTexture upload(const GladGLContext& gl, GLenum internal, const Image<T>& image,
                 const GlTile& part) {
    if (part.size == GlSize(int(image.width()), int(image.height())))
        return make_texture(gl, internal, part.size, image.pixels());
    const std::vector<T> texels = cut(image, part);
    return make_texture(gl, internal, part.size, std::span<const T>(texels));
}

/// Copies a target's texture into the image, with its corner at `origin`.
template <class T>
void read_into(const GlTarget& target, std::size_t number, glm::ivec2 origin, Image<T>& image) {
    constexpr std::size_t components = sizeof(T) / sizeof(float);
    const auto width = std::size_t(target.size().x), height = std::size_t(target.size().y);
    std::vector<T> texels(width * height);
    target.read(std::span(reinterpret_cast<float*>(texels.data()), components * texels.size()),
                {{0, 0}, target.size()}, number, int(components));
    for (std::size_t y = 0; y < height; ++y)
        std::copy_n(texels.begin() + std::ptrdiff_t(y * width), width,
                    image.row(std::size_t(origin.y) + y).begin() + origin.x);
}

}  // namespace

/// The level before the next pass, as uploaded or as drawn.
struct GlBlockLevels::Stage {
    GlSize size{0};
    bool first = true;  ///< `means` and `surface` are the texture and its surface shares
    GlTexture means, surface;
    std::optional<GlTarget> drawn{};
};

GlBlockLevels::GlBlockLevels(GlContext& context, const MeshAtlas& atlas, bool float32)
    : context_(context),
      atlas_(atlas),
      float64_(!float32 && has_current_float64(context)),
      even_(make_pass(context, true, atlas.patches() != nullptr, float64_)),
      any_(make_pass(context, false, atlas.patches() != nullptr, float64_)),
      pass_(context.gl()),
      pure_(last_pure_level(atlas)) {}

void GlBlockLevels::halve(Stage& stage, std::uint32_t level) const {
    const GladGLContext& gl = context_.gl();
    const bool even = stage.size % 2 == GlSize(0);
    const GlProgram& program = even ? even_ : any_;
    GlTarget target(gl, half(stage.size), {GL_RGBA32F, GL_RGBA32F, GL_RGBA32F});
    target.bind();
    program.use();
    program.set("first", int(stage.first));
    program.set("gutters_count", int(level <= pure_));
    program.set("taps", glm::ivec2(taps_of(stage.size.x), taps_of(stage.size.y)));
    bind_texture(gl, program, "before", 0, stage.drawn ? stage.drawn->texture(0) : stage.means);
    bind_texture(gl, program, "surface_before", 1,
                 stage.drawn ? stage.drawn->texture(1) : stage.surface);
    std::optional<GlBufferTexture> columns, rows;
    if (!even) {
        columns = weights_of(gl, stage.size.x, float64_);
        rows = weights_of(gl, stage.size.y, float64_);
        columns->bind(program, "columns", 2);
        rows->bind(program, "rows", 3);
    }
    pass_.draw();
    check_gl(gl, fmt::format("drawing MIP level {}", level));
    stage = {target.size(), false, {}, {}, std::move(target)};
}

void GlBlockLevels::draw(Stage& stage, glm::ivec2 origin, std::uint32_t first, std::uint32_t last,
                         std::vector<Image<RgbF>>& levels) const {
    for (std::uint32_t l = first; l <= last; ++l) {
        halve(stage, l);
        read_into(*stage.drawn, 2, origin >> int(l), levels[l - 1]);
    }
}

std::vector<Image<RgbF>> GlBlockLevels::operator()(const Image<RgbF>& texture, std::uint32_t levels,
                                                   int tile) const {
    context_.make_current();
    const GladGLContext& gl = context_.gl();
    const auto size = std::uint32_t(texture.width());
    const std::uint32_t last = std::min(levels, std::uint32_t(std::bit_width(size)) - 1);
    std::vector<Image<RgbF>> result;
    for (std::uint32_t l = 1; l <= last; ++l)
        result.push_back(Image<RgbF>::unset(size >> l, size >> l));
    const PatchAtlas* const patches = atlas_.patches();
    const Image<float> shares = patches ? inner_texels(*patches) : Image<float>(size, size);
    // The levels at which every texel lies in one tile.
    const int halvings = std::min(std::countr_zero(size), std::countr_zero(unsigned(tile)));
    const std::uint32_t apart =
        size <= std::uint32_t(tile) ? 0 : std::min(std::uint32_t(halvings), last);
    Image<Vec4f> means(size >> apart, size >> apart), surface(size >> apart, size >> apart);
    for_tiles(GlSize(int(size)), apart == 0 ? int(size) : tile, [&](const GlTile& part) {
        Stage stage{part.size, true, upload(gl, GL_RGB32F, texture, part),
                    upload(gl, GL_R32F, shares, part)};
        draw(stage, part.origin, 1, apart == 0 ? last : apart, result);
        if (apart == 0) return;
        read_into(*stage.drawn, 0, part.origin >> int(apart), means);
        read_into(*stage.drawn, 1, part.origin >> int(apart), surface);
    });
    if (apart > 0 && apart < last) {
        const GlTile all{{0, 0}, GlSize(int(size >> apart))};
        Stage stage{all.size, false, upload(gl, GL_RGBA32F, means, all),
                    upload(gl, GL_RGBA32F, surface, all)};
        draw(stage, {0, 0}, apart + 1, last, result);
    }
    return result;
}

}  // namespace burl
