#include "app/gl/fill/output.h"

#include <bit>

#include <fmt/format.h>

#include "procedural/color/srgb.h"
#include "procedural/glsl/colors.h"

namespace burl {

namespace {

template <class Texels>
GlBufferTexture table(const GladGLContext& gl, GLenum internal, const Texels& texels) {
    return {gl, internal, std::as_bytes(std::span(texels))};
}

}  // namespace

GlBufferTexture srgb8_table(const GladGLContext& gl) {
    const SrgbStreamEncoder encode;
    std::vector<glm::uvec4> texels;
    for (const SrgbStreamEncoder::Bucket& bucket : encode.buckets()) {
        const auto bits = std::bit_cast<std::uint64_t>(bucket.threshold);
        texels.emplace_back(std::uint32_t(bits), std::uint32_t(bits >> 32),
                            std::uint32_t(bucket.code), 0u);
    }
    return {gl, GL_RGBA32UI, std::as_bytes(std::span(texels))};
}

void GlColorTables::set_map(const ColorMap& map) {
    if (map == map_) return;
    map_ = map;
    codes_.reset();
    segments_.reset();
}

void GlColorTables::add_index(ShaderSource& source) const {
    source.define("COLOR_REPEATS", map_.wrap == Wrap::repeat ? "1" : "0").add("color/index.glsl");
}

void GlColorTables::add_codes(ShaderSource& source) {
    if (!codes_) {
        const ColorSteps steps = color_steps(ColorTable8(map_));
        codes_.emplace(
            Codes{table(*gl_, GL_RGBA32UI, steps.entries), {}, {}, steps.count, steps.most});
        if (steps.most > 1) {
            codes_->first.emplace(table(*gl_, GL_R32UI, steps.first));
            codes_->steps.emplace(table(*gl_, GL_RGBA32UI, steps.steps));
        }
    }
    add_index(source);
    source.define("COLOR_ENTRIES", fmt::format("{}.0", codes_->count))
        .define("COLOR_STEPS", fmt::format("{}", codes_->most))
        .add("color/codes.glsl");
}

void GlColorTables::bind_codes(const GlProgram& program, int first_unit) const {
    codes_->entries.bind(program, "color_entries", first_unit);
    if (!codes_->steps) return;
    codes_->first->bind(program, "color_first", first_unit + 1);
    codes_->steps->bind(program, "color_steps", first_unit + 2);
}

void GlColorTables::add_linear(ShaderSource& source) {
    if (!segments_) {
        const PreparedColorMap map(map_);
        segments_.emplace(
            Segments{table(*gl_, GL_RGBA32UI, color_segments(map)), int(map.segments())});
    }
    add_index(source);
    source.add("color/segments.glsl");
}

void GlColorTables::bind_linear(const GlProgram& program, int first_unit) const {
    segments_->texels.bind(program, "color_segments", first_unit);
    program.set("color_segment_count", segments_->count);
}

void GlColorTables::add_srgb16(ShaderSource& source) {
    if (!thresholds_) {
        const SrgbThresholds codes = srgb_thresholds();
        thresholds_.emplace(Thresholds{table(*gl_, GL_R32UI, codes.first),
                                       table(*gl_, GL_RG32UI, codes.thresholds)});
    }
    source.define("SRGB_BUCKETS", fmt::format("{}.0", SrgbThresholds::buckets))
        .add("color/srgb16.glsl");
}

void GlColorTables::bind_srgb16(const GlProgram& program, int first_unit) const {
    thresholds_->first.bind(program, "srgb_first", first_unit);
    thresholds_->thresholds.bind(program, "srgb_thresholds", first_unit + 1);
}

}  // namespace burl
