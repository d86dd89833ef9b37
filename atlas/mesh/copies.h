#pragma once
// Triangles that lie on the same points as earlier ones, found with one hash table.
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "atlas/mesh/mesh.h"

namespace burl {

/// A triangle's points in ascending order: equal for copies that face either way.
inline Triangle in_order(Triangle t) {
    if (t[0] > t[1]) std::swap(t[0], t[1]);
    if (t[1] > t[2]) std::swap(t[1], t[2]);
    if (t[0] > t[1]) std::swap(t[0], t[1]);
    return t;
}

/// A triangle turned so that its least point comes first: equal for copies that face the same way.
inline Triangle least_first(const Triangle& t) {
    if (t[1] < t[0] && t[1] <= t[2]) return {t[1], t[2], t[0]};
    if (t[2] < t[0] && t[2] < t[1]) return {t[2], t[0], t[1]};
    return t;
}

/// Calls visit(t, first) for every triangle t that has the same key as an earlier one, the first of
/// which is `first`; key(triangle) must be a triangle.
template <class Key, class Visit>
void visit_copies(std::span<const Triangle> triangles, const Key& key, const Visit& visit) {
    const std::size_t slots = std::bit_ceil(2 * triangles.size() + 64);
    const auto hash = [](const Triangle& points) {
        std::uint64_t h = points[0] * 0x9e3779b97f4a7c15ull + points[1];
        h = (h ^ h >> 32) * 0xd6e8feb86659fd93ull + points[2];
        h = (h ^ h >> 32) * 0xd6e8feb86659fd93ull;
        return h ^ h >> 32;
    };
    std::vector<std::uint32_t> table(slots, 0);  // triangle number + 1
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        const Triangle wanted = key(triangles[t]);
        std::size_t at = hash(wanted) & (slots - 1);
        while (table[at] != 0 && key(triangles[table[at] - 1]) != wanted)
            at = (at + 1) & (slots - 1);
        if (table[at] != 0)
            visit(t, table[at] - 1);
        else
            table[at] = t + 1;
    }
}

}  // namespace burl
