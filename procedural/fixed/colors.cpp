#include "procedural/fixed/colors.h"

#include <cmath>

namespace burl {

namespace {

/// The binary logarithms of the least and the largest number of entries (64 KiB and 1 MiB): short
/// tables stay in a cache, long entries leave more colours undecided.
constexpr int least_bits = 12, most_bits = 16;

/// A change of the colour code: from `index` on it is `code`.
struct Change {
    double index = 0.0;
    std::uint32_t code = 0;
};

std::uint32_t code_of(const Rgb8& color) {
    return std::uint32_t(color.r) | std::uint32_t(color.g) << 8 | std::uint32_t(color.b) << 16;
}

/// The changes by rising index; the first holds before all others. With `repeat` the list includes
/// the changes of the neighbouring periods.
std::vector<Change> changes_of(const ColorTable8& table) {
    const auto steps = table.steps().first(table.steps().size() - 1);
    std::vector<Change> changes{{-2.0, code_of(steps.front().color)}};
    const auto add = [&](double offset) {
        for (const ColorTable8::Step& step : steps)
            if (code_of(step.color) != changes.back().code)
                changes.push_back({step.index + offset, code_of(step.color)});
    };
    if (table.wrap() == Wrap::repeat) add(-1.0);
    add(0.0);
    if (table.wrap() == Wrap::repeat) add(1.0);
    return changes;
}

/// The table entry number `entry`; `first` is advanced to the last change below it.
glm::uvec4 entry_of(std::span<const Change> changes, std::size_t& first, std::uint32_t entry,
                    int bits) {
    const double per_index = std::ldexp(1.0, bits + 15);
    const double begin = std::ldexp(double(entry), 15) - FixedColors::margin;
    const double end = std::ldexp(double(entry) + 1.0, 15) + FixedColors::margin;
    while (first + 1 < changes.size() && changes[first + 1].index * per_index < begin) ++first;
    glm::uvec4 texel(changes[first].code);
    std::uint32_t places[] = {FixedColors::no_change, FixedColors::no_change};
    std::size_t count = 0;
    for (std::size_t i = first + 1; i < changes.size(); ++i, ++count) {
        if (changes[i].index * per_index > end) break;
        if (count == 2) return glm::uvec4(changes[first].code | undecided_code);
        places[count] = std::uint32_t(std::floor(changes[i].index * per_index - begin));
        for (std::size_t k = count + 1; k < 3; ++k) texel[glm::length_t(k)] = changes[i].code;
    }
    texel.w = places[0] | places[1] << 16;
    return texel;
}

}  // namespace

std::optional<FixedColors> fixed_colors(const ColorTable8& table) {
    const std::vector<Change> changes = changes_of(table);
    for (int bits = least_bits; bits <= most_bits; ++bits) {
        FixedColors colors{{}, bits};
        std::size_t first = 0;
        std::uint32_t open = 0;
        for (std::uint32_t entry = 0; entry <= 1u << bits; ++entry) {
            colors.entries.push_back(entry_of(changes, first, entry, bits));
            open += colors.entries.back().x >= undecided_code ? 1 : 0;
        }
        if (open <= 1u << bits >> 13) return colors;
    }
    return std::nullopt;
}

}  // namespace burl
