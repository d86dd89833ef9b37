#include "procedural/color_entries.h"

#include <algorithm>
#include <cmath>

namespace burl {

void fill_color_entries(std::span<const ColorTable8::Step> steps, std::span<ColorCode> entries,
                        std::span<std::uint32_t> first_step) {
    const double parts = double(entries.size() - 1);
    std::size_t begin = 0;
    for (std::uint32_t s = 0; begin < entries.size(); ++s) {
        // Those that begin before the next step; it may lie within the last of them.
        const double next = steps[s + 1].index * parts;
        const double after = std::min(std::ceil(next), double(entries.size()));
        const std::size_t end = std::max(begin, std::size_t(after));
        if (begin == end) continue;
        std::fill(entries.begin() + std::ptrdiff_t(begin), entries.begin() + std::ptrdiff_t(end),
                  ColorCode{steps[s].color, true});
        std::fill(first_step.begin() + std::ptrdiff_t(begin),
                  first_step.begin() + std::ptrdiff_t(end), s);
        entries[end - 1].uniform = next >= double(end);
        begin = end;
    }
}

}  // namespace burl
