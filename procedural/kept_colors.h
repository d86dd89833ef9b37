#pragma once
// The 8-bit colours of texels whose places in the colour map are kept while its colours change.
// Places are so fine that f, which takes twice their memory, need not be read again.
#include <cstdint>
#include <vector>

#include "procedural/color_table.h"

namespace burl {

/// As ColorTable8, of places that index_colors() made of f with `places` as their number.
class KeptColors {
  public:
    static constexpr std::uint32_t places = std::uint32_t(1) << 30;

    explicit KeptColors(const ColorMap& map);

    /// codes[j].color = the colour of f[j], whose place is at[j]. Both begin on a line of the cache
    /// and are read up to the end of a vector of floats; `later` holds `count` and 16 numbers more.
    void look_up(const std::int32_t* at, const double* f, std::size_t count, ColorCode* codes,
                 std::uint32_t* later) const;
    Rgb8 operator()(double f) const { return table_(f); }

  private:
    ColorCode searched(std::int32_t place, const double& f) const;

    ColorTable8 table_;
    std::vector<ColorCode> entries_;         ///< of 2^16 places each, and one for index 1
    std::vector<std::uint32_t> first_step_;  ///< per entry: the last step up to its begin
    std::vector<std::int32_t> step_places_;  ///< and some beyond all
    std::vector<ColorCode> step_codes_;
};

}  // namespace burl
