#include "procedural/glsl/colors.h"

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

/// The largest number of steps within one of `count` entries, not at its begin, rounded up to a
/// power of two.
std::uint32_t most_steps(std::span<const ColorTable8::Step> steps, std::uint32_t count) {
    std::uint32_t most = 1, entry = 0, in_entry = 0;
    for (const ColorTable8::Step& step : steps.first(steps.size() - 1)) {
        const double place = step.index * count;
        const auto own = std::uint32_t(place);
        in_entry = (own == entry ? in_entry : 0) + (double(own) < place ? 1 : 0);
        entry = own;
        most = std::max(most, in_entry);
    }
    return std::bit_ceil(most);
}

}  // namespace

ColorSteps color_steps(const ColorTable8& table) {
    const auto steps = table.steps();
    ColorSteps result;
    result.count = 1u << 14;
    result.most = most_steps(steps, result.count);
    for (std::uint32_t count = 1u << 15; count <= 1u << 16; count *= 2)
        if (const std::uint32_t most = most_steps(steps, count); most < result.most)
            result.count = count, result.most = most;
    std::uint32_t first = 0;
    for (std::uint32_t i = 0; i <= result.count; ++i) {
        while (steps[first + 1].index <= double(i) / result.count) ++first;
        result.entries.emplace_back(number_of({steps[first].color}), halves(steps[first + 1].index),
                                    number_of({steps[first + 1].color}));
        result.first.push_back(first);
    }
    for (const ColorTable8::Step& step : steps)
        result.steps.emplace_back(halves(step.index), number_of({step.color}), 0u);
    result.steps.insert(result.steps.end(), result.most, result.steps.back());
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

std::vector<TableTexel> color_texels(std::span<const Vec3d> colors) {
    std::vector<TableTexel> texels;
    for (const Vec3d& color : colors) {
        texels.push_back(two(color.x, color.y));
        texels.push_back(two(color.z, 0.0));
    }
    return texels;
}

SrgbThresholds srgb_thresholds() {
    const SrgbEncoder<std::uint16_t> encode;
    SrgbThresholds result;
    for (std::uint32_t code = 0; code <= encode.max_code; ++code)
        result.thresholds.push_back(halves(encode.threshold(std::uint16_t(code))));
    // A float's square root may be a little too large, so a bucket's code is that of a point below
    // it.
    for (std::uint32_t i = 0; i <= SrgbThresholds::buckets; ++i) {
        const double root = std::max(i - 0.1, 0.0) / SrgbThresholds::buckets;
        result.first.push_back(encode(root * root));
    }
    return result;
}

}  // namespace burl
