// Ownership of resized texels in integers: with N old and n new texels a side, new texel i has its
// centre at (i + 1/2) N / n.
#include "atlas/solid/level.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burl {
namespace {

constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();

/// Resamples the spans of an atlas at the texel centres of a texture of another size.
class Resizing {
  public:
    Resizing(const SolidAtlas& solid, std::uint32_t size)
        : solid_(solid), old_(solid.size), new_(size), number_(solid.maps.size(), unused) {
        result_.size = size;
    }

    SolidAtlas run() {
        result_.row_begin.push_back(0);
        for (std::uint32_t y = 0; y < new_; ++y) {
            for (const Span& span : solid_.row(old_texel(y))) add(span);
            result_.row_begin.push_back(result_.spans.size());
        }
        return std::move(result_);
    }

  private:
    /// The old texel that holds the centre of new texel i.
    std::uint32_t old_texel(std::uint64_t i) const {
        return std::uint32_t((2 * i + 1) * old_ / (2 * new_));
    }
    /// The first new texel whose centre is in old texel `begin` or after it.
    std::uint32_t first_from(std::uint64_t begin) const {
        return std::uint32_t((2 * begin * new_ + old_ - 1) / (2 * old_));
    }

    void add(const Span& span) {
        const std::uint32_t first = first_from(span.x), end = first_from(span.x + span.count);
        if (first == end) return;
        const std::uint32_t map = number_of(span.map);
        const bool first_of_row = result_.spans.size() == result_.row_begin.back();
        if (!first_of_row) {
            Span& last = result_.spans.back();
            if (last.map == map && last.x + last.count == first) {
                last.count += end - first;
                return;
            }
        }
        result_.spans.push_back({first, end - first, map});
    }

    std::uint32_t number_of(std::uint32_t map) {
        if (number_[map] == unused) {
            number_[map] = std::uint32_t(result_.maps.size());
            result_.maps.push_back(resized(solid_.maps[map]));
            result_.turned.push_back(solid_.triangle_of(map));
        }
        return number_[map];
    }

    TexelMap resized(const TexelMap& map) const {
        const double scale = double(old_) / double(new_);
        const auto anchor = [&](std::int32_t at) {
            return std::int32_t(std::clamp(std::floor((at + 0.5) / scale), 0.0, double(new_ - 1)));
        };
        const auto moved = [&](std::int32_t to, std::int32_t from) {
            return (to + 0.5) * scale - (from + 0.5);
        };
        TexelMap result;
        result.anchor_x = anchor(map.anchor_x);
        result.anchor_y = anchor(map.anchor_y);
        result.origin = map.origin + moved(result.anchor_x, map.anchor_x) * map.step_x +
                        moved(result.anchor_y, map.anchor_y) * map.step_y;
        result.step_x = scale * map.step_x;
        result.step_y = scale * map.step_y;
        return result;
    }

    const SolidAtlas& solid_;
    std::uint64_t old_, new_;
    std::vector<std::uint32_t> number_;  ///< new number of each old map, or unused
    SolidAtlas result_;
};

}  // namespace

std::uint32_t level_size(std::uint32_t size, std::uint32_t level) {
    return std::max(level < 32 ? size >> level : 0u, 1u);
}

SolidAtlas resized(const SolidAtlas& solid, std::uint32_t size) {
    return Resizing(solid, size).run();
}

SolidAtlas solid_level(const SolidAtlas& solid, std::uint32_t level) {
    return resized(solid, level_size(solid.size, level));
}

}  // namespace burl
