#include "atlas/solid/texel_owners.h"

#include <limits>
#include <utility>
#include <vector>

#include "atlas/solid/texel_rows.h"

namespace burl {

namespace {

constexpr std::uint32_t unowned = std::numeric_limits<std::uint32_t>::max();
/// The distance in texels that a bilinear lookup inside a triangle can reach.
constexpr double near = 1.5;

/// Gives texels without an owner to the triangles, `scale` times as large as in the atlas, that
/// their centres lie within `reach` texels of.
void claim(const Atlas& atlas, double scale, double reach, Image<std::uint32_t>& owners) {
    const auto size = std::uint32_t(owners.width());
    for (std::uint32_t t = 0; t < atlas.corners.size(); ++t) {
        std::array<Vec2d, 3> corners = atlas.corners[t];
        for (Vec2d& corner : corners) corner *= scale;
        visit_slices(corners, size, reach, [&](std::uint32_t row, const Interval& x) {
            const TexelRun run = centres_within(x.low - reach, x.high + reach, size);
            for (std::uint32_t& owner : owners.row(row).subspan(run.first, run.count))
                if (owner == unowned) owner = t;
        });
    }
}

using Texel = std::pair<std::uint32_t, std::uint32_t>;

/// Calls visit(x, y) for the texels beside one.
template <class Visit>
void for_neighbours(const Texel& at, std::uint32_t size, const Visit& visit) {
    const auto [x, y] = at;
    if (x > 0) visit(x - 1, y);
    if (y > 0) visit(x, y - 1);
    if (x + 1 < size) visit(x + 1, y);
    if (y + 1 < size) visit(x, y + 1);
}

/// The owned texels that lie beside one that nobody owns, row by row.
std::vector<Texel> shore_of(const Image<std::uint32_t>& owners) {
    const auto size = std::uint32_t(owners.width());
    std::vector<Texel> shore;
    for (std::uint32_t y = 0; y < size; ++y)
        for (std::uint32_t x = 0; x < size; ++x) {
            if (owners(x, y) == unowned) continue;
            bool open = false;
            for_neighbours({x, y}, size, [&](auto i, auto j) { open |= owners(i, j) == unowned; });
            if (open) shore.emplace_back(x, y);
        }
    return shore;
}

/// Gives all other texels to the owners of those nearest along rows and columns, step by step.
void spread(Image<std::uint32_t>& owners) {
    const auto size = std::uint32_t(owners.width());
    for (std::vector<Texel> shore = shore_of(owners), next; !shore.empty();) {
        next.clear();
        for (const Texel& at : shore)
            for_neighbours(at, size, [&](auto i, auto j) {
                if (owners(i, j) != unowned) return;
                owners(i, j) = owners(at.first, at.second);
                next.emplace_back(i, j);
            });
        shore.swap(next);
    }
}

}  // namespace

TexelOwners::TexelOwners(const SolidAtlas& solid, const Atlas& atlas)
    : solid_(solid), atlas_(atlas) {
    if (solid.turned.empty()) return;
    const double scale = double(solid.size) / double(atlas.options.size);
    owners_ = Image<std::uint32_t>(solid.size, solid.size, unowned);
    for (const double reach : {0.0, near}) claim(atlas, scale, reach, owners_);
    spread(owners_);
}

std::uint32_t TexelOwners::operator()(std::uint32_t x, std::uint32_t y, std::uint32_t map) const {
    const std::uint32_t shown = solid_.triangle_of(map);
    if (map < solid_.maps.size() - solid_.turned.size()) return shown;
    const std::uint32_t owner = owners_(x, y);
    const bool fits = owner != unowned && atlas_.charts[owner] == atlas_.charts[shown];
    return fits ? owner : shown;
}

}  // namespace burl
