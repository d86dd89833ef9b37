#include "atlas/solid/texel_owners.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "atlas/solid/texel_rows.h"

namespace burl {

namespace {

/// The owner of a texel without one, and the chart of a texel that needs none.
constexpr std::uint32_t unowned = std::numeric_limits<std::uint32_t>::max();
/// The distance in texels that a bilinear lookup inside a triangle can reach.
constexpr double lookup_reach = 1.5;

/// The owners of texels, and the charts of those that may be owned.
struct OwnedTexels {
    Image<std::uint32_t> charts, owners;

    void claim(std::size_t x, std::size_t y, std::uint32_t triangle, std::uint32_t chart) {
        if (charts(x, y) == chart && owners(x, y) == unowned) owners(x, y) = triangle;
    }
};

/// Gives texels of a triangle's chart without an owner to the triangle, `scale` times as large as
/// in the atlas, if their centres lie within `reach` texels of it.
void claim_texels(const Atlas& atlas, double scale, double reach, OwnedTexels& texels) {
    const auto size = std::uint32_t(texels.owners.width());
    for (std::uint32_t t = 0; t < atlas.corners.size(); ++t) {
        std::array<Vec2d, 3> corners = atlas.corners[t];
        for (Vec2d& corner : corners) corner *= scale;
        visit_slices(corners, size, reach, [&](std::uint32_t row, const Interval& x) {
            const TexelRun run = centres_within(x.low - reach, x.high + reach, size);
            for (std::uint32_t i = run.first; i < run.first + run.count; ++i)
                texels.claim(i, row, t, atlas.charts[t]);
        });
    }
}

using TexelAt = std::pair<std::uint32_t, std::uint32_t>;

/// Calls visit(x, y) for the texels beside one.
template <class Visit>
void for_texels_beside(const TexelAt& at, std::uint32_t size, const Visit& visit) {
    const auto [x, y] = at;
    if (x > 0) visit(x - 1, y);
    if (y > 0) visit(x, y - 1);
    if (x + 1 < size) visit(x + 1, y);
    if (y + 1 < size) visit(x, y + 1);
}

/// Gives the texels of its chart beside an owned one to the same triangle; `take` gets them.
template <class Take>
void spread_owner(const TexelAt& at, OwnedTexels& texels, const Take& take) {
    const std::uint32_t owner = texels.owners(at.first, at.second);
    const std::uint32_t chart = texels.charts(at.first, at.second);
    if (owner == unowned) return;
    for_texels_beside(at, std::uint32_t(texels.owners.width()), [&](auto x, auto y) {
        if (texels.owners(x, y) != unowned || texels.charts(x, y) != chart) return;
        texels.owners(x, y) = owner;
        take(TexelAt(x, y));
    });
}

/// Gives all other texels to the owners of those of their chart that are nearest along rows and
/// columns, step by step.
void spread_owners(OwnedTexels& texels) {
    const auto size = std::uint32_t(texels.owners.width());
    std::vector<TexelAt> shore, next;
    const Image<std::uint32_t> claimed = texels.owners;
    for (std::uint32_t y = 0; y < size; ++y)
        for (std::uint32_t x = 0; x < size; ++x)
            if (claimed(x, y) != unowned)
                spread_owner({x, y}, texels, [&](const TexelAt& at) { shore.push_back(at); });
    for (; !shore.empty(); shore.swap(next)) {
        next.clear();
        for (const TexelAt& at : shore)
            spread_owner(at, texels, [&](const TexelAt& more) { next.push_back(more); });
    }
}

}  // namespace

TexelOwners::TexelOwners(const SolidAtlas& solid, const Atlas& atlas, OwnerReach reach)
    : solid_(solid), atlas_(atlas) {
    if (solid.turned.empty()) return;
    const double scale = double(solid.size) / double(atlas.options.size);
    OwnedTexels texels{charts(), Image<std::uint32_t>(solid.size, solid.size, unowned)};
    for (const double near : {0.0, lookup_reach}) claim_texels(atlas, scale, near, texels);
    if (reach == OwnerReach::gutters) spread_owners(texels);
    owners_ = std::move(texels.owners);
}

bool TexelOwners::has_single_triangle(std::uint32_t map) const {
    return map < solid_.maps.size() - solid_.turned.size();
}

/// The charts of the texels whose maps have no single triangle.
Image<std::uint32_t> TexelOwners::charts() const {
    Image<std::uint32_t> charts(solid_.size, solid_.size, unowned);
    for (std::uint32_t y = 0; y < solid_.size; ++y)
        for (const Span& span : solid_.row(y))
            if (!has_single_triangle(span.map))
                std::fill_n(&charts(span.x, y), span.count,
                            atlas_.charts[solid_.triangle_of(span.map)]);
    return charts;
}

std::uint32_t TexelOwners::operator()(std::uint32_t x, std::uint32_t y, std::uint32_t map) const {
    if (has_single_triangle(map)) return solid_.triangle_of(map);
    const std::uint32_t owner = owners_(x, y);
    return owner != unowned ? owner : solid_.triangle_of(map);
}

}  // namespace burl
