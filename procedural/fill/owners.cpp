#include "procedural/fill/owners.h"

#include <limits>

#include "atlas/solid/texel_rows.h"

namespace burl {

namespace {

constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();
// The distance in texels that a bilinear lookup inside a triangle can reach.
constexpr double near = 1.5;

/// Gives texels without an owner to the triangles that their centres lie within `reach` texels of.
void claim(const Atlas& atlas, double reach, Image<std::uint32_t>& owners) {
    const auto size = std::uint32_t(owners.width());
    for (std::uint32_t t = 0; t < atlas.corners.size(); ++t)
        visit_slices(atlas.corners[t], size, reach, [&](std::uint32_t row, const Interval& x) {
            const TexelRun run = centres_within(x.low - reach, x.high + reach, size);
            for (std::uint32_t& owner : owners.row(row).subspan(run.first, run.count))
                if (owner == nobody) owner = t;
        });
}

}  // namespace

FrameOwners::FrameOwners(const SolidAtlas& solid, const Atlas& atlas)
    : solid_(solid), atlas_(atlas) {
    if (solid.turned.empty()) return;
    owners_ = Image<std::uint32_t>(solid.size, solid.size, nobody);
    for (const double reach : {0.0, near}) claim(atlas, reach, owners_);
}

std::uint32_t FrameOwners::operator()(std::uint32_t x, std::uint32_t y, std::uint32_t map) const {
    const std::uint32_t shown = solid_.triangle_of(map);
    if (map < solid_.maps.size() - solid_.turned.size()) return shown;
    const std::uint32_t owner = owners_(x, y);
    const bool fits = owner != nobody && atlas_.charts[owner] == atlas_.charts[shown];
    return fits ? owner : shown;
}

}  // namespace burl
