#include "atlas/uv/claims.h"

#include <algorithm>
#include <cmath>

#include "atlas/solid/texel_rows.h"

namespace burl {

namespace {

constexpr double least_area = 1e-20;  ///< of a triangle with area, as a share of the texture

/// Distance in texels, in x and in y, by which a centre must lie inside of a triangle that shares
/// it, so that triangles that meet in an edge share none.
constexpr double inset = 1e-6;

/// Claims texels for one triangle after the other.
class Claiming {
  public:
    explicit Claiming(const Atlas& atlas)
        : atlas_(atlas),
          columns_(atlas.options.columns()),
          rows_(atlas.options.rows()),
          inner_(columns_, rows_, unclaimed),
          shares_(atlas.corners.size()) {
        claims_.owner = Image<std::uint32_t>(columns_, rows_, unclaimed);
    }

    UvClaims run() {
        for (std::uint32_t t = 0; t < atlas_.corners.size(); ++t)
            if (has_texture_area(atlas_.corners[t], double(columns_) * rows_)) claim(t);
        claims_.shared_texels = std::uint64_t(std::ranges::count(shared_, true));
        claims_.sharing_triangles = std::uint64_t(std::ranges::count(shares_, true));
        return std::move(claims_);
    }

  private:
    void claim(std::uint32_t t) {
        const std::array<Vec2d, 3>& corners = atlas_.corners[t];
        const auto [low, high] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
        visit_slices(corners, rows_, 0.0, [&, low, high](std::uint32_t y, const Interval& x) {
            const TexelRun run = centres_within(x.low, x.high, columns_);
            for (std::uint32_t& texel : claims_.owner.row(y).subspan(run.first, run.count))
                texel = std::min(texel, t);
            if (y + 0.5 - low > inset && high - (y + 0.5) > inset)
                claim_inside(t, y, centres_within(x.low + inset, x.high - inset, columns_));
        });
    }

    void claim_inside(std::uint32_t t, std::uint32_t y, const TexelRun& run) {
        for (std::uint32_t x = run.first; x < run.first + run.count; ++x) {
            std::uint32_t& first = inner_(x, y);
            if (first == unclaimed) {
                first = t;
                continue;
            }
            if (shared_.empty()) shared_.resize(std::size_t(columns_) * rows_);
            shared_[std::size_t(y) * columns_ + x] = true;
            shares_[first] = shares_[t] = true;
        }
    }

    const Atlas& atlas_;
    std::uint32_t columns_, rows_;
    Image<std::uint32_t> inner_;  ///< the first triangle that each centre lies inside of
    std::vector<bool> shares_;    ///< per triangle, whether it shares a texel
    std::vector<bool> shared_;    ///< per texel, whether it is shared; empty: none is
    UvClaims claims_;
};

}  // namespace

bool has_texture_area(const std::array<Vec2d, 3>& corners, double texture_area) {
    const double twice = cross(corners[1] - corners[0], corners[2] - corners[0]);
    return std::isfinite(twice) && std::abs(twice) > 2.0 * least_area * texture_area;
}

UvClaims claim_texels(const Atlas& atlas) {
    return Claiming(atlas).run();
}

}  // namespace burl
