#include "procedural/maps/site_map.h"

#include <atomic>
#include <bit>

#include "procedural/batch/row_tasks.h"
#include "procedural/maps/lattice_map.h"
#include "procedural/numbers/lattice_hash.h"

namespace burl {

namespace {

/// Calls visit(number in the order, number in the map) for all texels of the area.
template <class Visit>
void for_texels(const TexelArea& area, int threads, const Visit& visit) {
    const SiteOrder order(area.width, area.height);
    for_row_ranges(area.height, 1 << 14, threads, [&](const RowRange& rows) {
        for (auto y = std::uint32_t(rows.begin()); y != rows.end(); ++y)
            for (std::uint32_t x = 0; x < area.width; ++x)
                visit(order(x, y), std::size_t(y) * area.width + x);
    });
}

/// The bits of the quadric's float64 value at texel i.
std::uint64_t quadric_bits(const LatticeMap& map, std::size_t i) {
    return std::uint64_t(map.cells.pixels()[i].w) << 32 | map.places.pixels()[i].w;
}

}  // namespace

std::vector<MapTexel> fill_site_map(const SolidAtlas& solid, std::span<const TexelMap> maps,
                                    const LatticeStreamKey& stream, const TexelArea& area,
                                    int threads) {
    const LatticeMap map = fill_lattice_map(solid, maps, stream, std::nullopt, area, threads);
    std::vector<MapTexel> sites(SiteOrder(area.width, area.height).texels(), MapTexel(0));
    for_texels(area, threads, [&](std::size_t to, std::size_t from) {
        const MapTexel &cell = map.cells.pixels()[from], &place = map.places.pixels()[from];
        const std::uint32_t hash = cell.x * LatticeHash::prime_x + cell.y * LatticeHash::prime_y +
                                   cell.z * LatticeHash::prime_z;
        sites[to] = {hash, place.x, place.y, place.z};
    });
    return sites;
}

std::optional<std::vector<std::uint32_t>> fill_base_map(const SolidAtlas& solid,
                                                        std::span<const TexelMap> maps,
                                                        const Quadric& quadric,
                                                        const FixedIndex& field,
                                                        const TexelArea& area, int threads) {
    const LatticeMap map = fill_lattice_map(solid, maps, std::nullopt, quadric, area, threads);
    std::vector<std::uint32_t> bases(SiteOrder(area.width, area.height).texels(), no_base);
    std::atomic<bool> held = true;
    for_texels(area, threads, [&](std::size_t to, std::size_t from) {
        const std::uint64_t bits = quadric_bits(map, from);
        if (bits == no_quadric) return;
        const auto base = fixed_base(field, std::bit_cast<double>(bits));
        if (base)
            bases[to] = *base;
        else
            held = false;
    });
    if (!held) return std::nullopt;
    return bases;
}

}  // namespace burl
