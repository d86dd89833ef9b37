#pragma once
// A colour map prepared for look-ups, kept while only the field changes: an 8-bit table takes as
// long as a tenth of a million texels.
#include <optional>
#include <tuple>

#include "procedural/color/point_colors.h"

namespace burl {

class KeptColors {
  public:
    /// Those of the map; the last ones of such pixels, if they are that. Good until the next call.
    template <class Pixel>
    const PointColors<Pixel>& of(const ColorMap& map) {
        auto& [last, colors] = std::get<Entry<Pixel>>(entries_);
        if (!colors || last != map) {
            colors.emplace(map);
            last = map;
        }
        return *colors;
    }

  private:
    template <class Pixel>
    struct Entry {
        ColorMap map{};
        std::optional<PointColors<Pixel>> colors{};
    };
    std::tuple<Entry<Rgb8>, Entry<Rgb16>, Entry<RgbF>> entries_;
};

}  // namespace burl
