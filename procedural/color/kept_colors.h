#pragma once
// Cache of one prepared colour map per pixel type, for edits that change only the field: making an
// 8-bit table takes as long as a tenth of a million texels.
#include <optional>
#include <tuple>

#include "procedural/color/point_colors.h"

namespace burl {

class KeptColors {
  public:
    /// The prepared colours of the map: the cached ones if the last call for this pixel type had
    /// the same map. The reference is valid until the next call.
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
