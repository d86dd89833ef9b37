// Welding by one open-addressing hash table: keyed by the coordinates' bits for exact welding, by
// grid cells twice as wide as the distance for tolerant welding, where the point's cell and its
// neighbours on the near sides hold every candidate (welded points lie apart, so a cell holds few).
#include "atlas/mesh/weld.h"

#include <bit>
#include <cmath>

#include "atlas/mesh/polygon_soup.h"

namespace burl {
namespace {

std::uint64_t mix(std::uint64_t h) {
    h ^= h >> 32;
    h *= 0xd6e8feb86659fd93ull;
    h ^= h >> 32;
    h *= 0xd6e8feb86659fd93ull;
    return h ^ (h >> 32);
}

std::uint64_t hash_of(const Vec3d& p) {
    const auto x = std::bit_cast<std::uint64_t>(p.x), y = std::bit_cast<std::uint64_t>(p.y),
               z = std::bit_cast<std::uint64_t>(p.z);
    return mix(x + mix(y + mix(z)));
}

/// A hash table of ids with linear probing; it grows fourfold when two thirds full.
class IdTable {
  public:
    /// Calls same(id) for each id stored under `hash`; returns the first that matches, or no_index.
    template <typename Same>
    std::uint32_t find(std::uint64_t hash, const Same& same) const {
        for (std::size_t at = hash & mask_; slots_[at].id != no_index; at = (at + 1) & mask_)
            if (slots_[at].tag == tag_of(hash) && same(slots_[at].id)) return slots_[at].id;
        return no_index;
    }
    void insert(std::uint64_t hash, std::uint32_t id) {
        if (3 * ++count_ > 2 * slots_.size()) grow();
        place({hash, tag_of(hash), id});
    }

  private:
    struct Slot {
        std::uint64_t hash = 0;
        std::uint32_t tag = 0;
        std::uint32_t id = no_index;
    };
    static std::uint32_t tag_of(std::uint64_t hash) {
        return static_cast<std::uint32_t>(hash >> 32);
    }
    void place(const Slot& slot) {
        std::size_t at = slot.hash & mask_;
        while (slots_[at].id != no_index) at = (at + 1) & mask_;
        slots_[at] = slot;
    }
    void grow() {
        std::vector<Slot> old(4 * slots_.size());
        old.swap(slots_);
        mask_ = slots_.size() - 1;
        for (const Slot& slot : old)
            if (slot.id != no_index) place(slot);
    }
    std::vector<Slot> slots_ = std::vector<Slot>(1024);
    std::size_t mask_ = 1023;
    std::size_t count_ = 0;
};

/// Welds points with the same bits.
class ExactWelder {
  public:
    std::uint32_t id_of(const Vec3d& p, std::vector<Vec3d>& positions) {
        const std::uint64_t hash = hash_of(p);
        const std::uint32_t found =
            table_.find(hash, [&](std::uint32_t id) { return positions[id] == p; });
        if (found != no_index) return found;
        table_.insert(hash, static_cast<std::uint32_t>(positions.size()));
        positions.push_back(p);
        return static_cast<std::uint32_t>(positions.size() - 1);
    }

  private:
    IdTable table_;
};

/// Welds each point to the earliest welded point within `distance`.
class TolerantWelder {
  public:
    TolerantWelder(const Vec3d& low, double distance)
        // A little wider than 2 * distance, so that rounding never puts a candidate two cells away.
        : low_(low), distance_(distance), cell_width_(distance * (2.0 + 1e-6)) {}

    std::uint32_t id_of(const Vec3d& p, std::vector<Vec3d>& positions) {
        const Vec3d place = (p - low_) / cell_width_;
        const Vec3d cell = glm::floor(place);
        const std::uint32_t found = earliest_near(p, cell, place - cell, positions);
        if (found != no_index) return found;
        table_.insert(hash_of(cell), static_cast<std::uint32_t>(positions.size()));
        positions.push_back(p);
        return static_cast<std::uint32_t>(positions.size() - 1);
    }

  private:
    /// The first welded point within the distance, among the eight cells that can hold one.
    std::uint32_t earliest_near(const Vec3d& p, const Vec3d& cell, const Vec3d& fraction,
                                const std::vector<Vec3d>& positions) const {
        const Vec3d side(fraction.x < 0.5 ? -1.0 : 1.0, fraction.y < 0.5 ? -1.0 : 1.0,
                         fraction.z < 0.5 ? -1.0 : 1.0);
        std::uint32_t best = no_index;
        for (int n = 0; n < 8; ++n) {
            const Vec3d pick(n & 1, n >> 1 & 1, n >> 2);
            const Vec3d near = cell + side * pick + 0.0;  // + 0.0: a cell of -0 must hash as 0
            table_.find(hash_of(near), [&](std::uint32_t id) {
                if (id < best && glm::distance(positions[id], p) <= distance_) best = id;
                return false;
            });
        }
        return best;
    }
    IdTable table_;
    Vec3d low_;
    double distance_;
    double cell_width_;
};

template <typename Welder>
void weld_with(Welder welder, const std::vector<Vec3d>& points, WeldedPoints& welded) {
    std::vector<std::uint32_t> id_of_point(points.size(), no_index);
    for (std::uint32_t& corner : welded.corners) {
        std::uint32_t& id = id_of_point[corner];
        if (id == no_index) {
            const std::size_t before = welded.positions.size();
            id = welder.id_of(points[corner] + 0.0, welded.positions);  // -0 + 0 is 0
            welded.merged += welded.positions.size() == before;
        }
        corner = id;
    }
    welded.positions.shrink_to_fit();  // grown one by one, and kept from now on
    for (const std::uint32_t id : id_of_point) welded.unreferenced += id == no_index;
}

}  // namespace

WeldedPoints weld_points(const std::vector<Vec3d>& points, std::vector<std::uint32_t> corners,
                         double distance) {
    WeldedPoints welded;
    welded.corners = std::move(corners);
    if (!(distance > 0.0)) {
        weld_with(ExactWelder(), points, welded);
        return welded;
    }
    Vec3d low = points[welded.corners.front()];
    for (const std::uint32_t corner : welded.corners) low = glm::min(low, points[corner]);
    weld_with(TolerantWelder(low, distance), points, welded);
    return welded;
}

}  // namespace burl
