#include "procedural/glsl_colors.h"

#include <algorithm>
#include <bit>

namespace burl {

namespace {

glm::uvec2 halves(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    return {std::uint32_t(bits), std::uint32_t(bits >> 32)};
}

TableTexel two(double x, double y) {
    return {halves(x), halves(y)};
}

std::uint32_t code_of(const Rgb8& color) {
    return std::uint32_t(color.r) | std::uint32_t(color.g) << 8 | std::uint32_t(color.b) << 16;
}

}  // namespace

ColorSteps color_steps(const ColorTable8& table) {
    const auto steps = table.steps();
    ColorSteps result;
    for (const ColorTable8::Step& step : steps)
        result.steps.emplace_back(halves(step.index), code_of(step.color), 0u);
    const auto last = std::uint32_t(steps.size() - 1);
    for (std::uint32_t i = 0; i <= ColorTable8::entry_count; ++i) {
        const std::uint32_t first = table.first_step(i), next = first + 1;
        result.entries.emplace_back(code_of(steps[first].color), halves(steps[next].index),
                                    code_of(steps[next].color));
        result.first.push_back(first);
        const double end = double(i + 1) / ColorTable8::entry_count;
        result.several = result.several || (next < last && steps[next + 1].index < end);
    }
    return result;
}

std::vector<TableTexel> color_segments(const PreparedColorMap& map) {
    std::vector<TableTexel> texels;
    for (std::size_t i = 0; i < map.segments(); ++i) {
        const Vec3d color = map.color(i, map.begin(i)), &slope = map.slope(i);
        texels.push_back(two(map.begin(i), color.x));
        texels.push_back(two(color.y, color.z));
        texels.push_back(two(slope.x, slope.y));
        texels.push_back(two(slope.z, 0.0));
    }
    return texels;
}

SrgbThresholds srgb_thresholds() {
    const SrgbEncoder<std::uint16_t> encode;
    SrgbThresholds result;
    for (std::uint32_t code = 0; code <= encode.max_code; ++code)
        result.thresholds.push_back(halves(encode.threshold(std::uint16_t(code))));
    // A float's square root may be a little too large: buckets begin with a code before their own.
    for (std::uint32_t i = 0; i <= SrgbThresholds::buckets; ++i) {
        const double root = std::max(i - 0.1, 0.0) / SrgbThresholds::buckets;
        result.first.push_back(encode(root * root));
    }
    return result;
}

}  // namespace burl
