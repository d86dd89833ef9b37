#include "app/gl/draw/view_texels.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "atlas/base/error.h"

namespace burl {

namespace {

/// The largest number of triangles, since samples hold the triangle's number in a float.
constexpr std::size_t most_numbered = std::size_t{1} << 24;

struct Texels {
    std::int64_t first = 0, last = 0;  ///< both are read
};

/// std::floor of a number within std::int64_t, without the function call of old instruction sets.
std::int64_t floor_of(double x) {
    const auto whole = std::int64_t(x);
    return whole - (x < double(whole) ? 1 : 0);
}

/// The texels along an axis of n texels that a lookup at `place` (in texture coordinates) reads.
Texels read_by(double place, std::uint32_t n, bool linear, double slack) {
    const double x = place * n - (linear ? 0.5 : 0.0);
    return {floor_of(x - slack), linear ? -floor_of(-(x + slack)) : floor_of(x + slack)};
}

std::uint32_t wrapped(std::int64_t x, std::uint32_t n, TextureWrap wrap) {
    const std::int64_t size = n;
    if (wrap == TextureWrap::clamp) return std::uint32_t(std::clamp<std::int64_t>(x, 0, size - 1));
    const std::int64_t turns = 2 * size;
    const std::int64_t at = (x % turns + turns) % turns;
    if (wrap == TextureWrap::repeat) return std::uint32_t(at % size);
    return std::uint32_t(at < size ? at : turns - 1 - at);
}

class Marker {
  public:
    Marker(const TextureLookup& lookup, const LookupSlack& slack, ViewTexels& texels)
        : lookup_(lookup), slack_(slack), texels_(texels) {}

    void operator()(const LookupSample& sample) {
        const double u = double(sample.x), v = double(sample.y);
        if (!(sample.w > 0.0f) || !(std::abs(u) < 1e6) || !(std::abs(v) < 1e6)) return;
        if (lookup_.filter != TextureFilter::mip) return mark(0, u, v);
        const bool in_blocks = !lookup_.blocks.empty();
        const double level = level_of(double(sample.z));
        const int coarsest = int(texels_.levels.size()) - 1;
        const int first = std::clamp(int(floor_of(level - slack_.level)), 0, coarsest);
        const int last = std::clamp(int(-floor_of(-level - slack_.level)), 0, coarsest);
        for (int l = first; l <= last; ++l) {
            if (in_blocks)
                mark_in(lookup_.blocks[std::size_t(sample.w) - 1], l, u, v);
            else
                mark(l, u, v);
        }
    }

  private:
    /// The level as lookup() of mesh.frag computes it, without the lower bound; the coarsest for
    /// infinite and undefined footprints.
    static double level_of(double square) {
        if (square < 0.25) return -1.0;
        return square < 1e30 ? 0.5 * std::log2(square) : 50.0;
    }

    /// Marks the texels of level l with the lookup clamped to a block as by block_level() of
    /// mesh.frag.
    void mark_in(const Vec4f& block, int l, double u, double v) {
        const double half = 0.5 / texels_.levels[std::size_t(l)].size();
        const auto clamped = [&](double place, double low, double high) {
            const double middle = 0.5 * (low + high);
            return std::clamp(place, std::min(low + half, middle), std::max(high - half, middle));
        };
        mark(l, clamped(u, double(block.x), double(block.z)),
             clamped(v, double(block.y), double(block.w)));
    }

    void mark(int l, double u, double v) {
        TexelSet& level = texels_.levels[std::size_t(l)];
        const bool linear = lookup_.filter != TextureFilter::nearest;
        const Texels xs = read_by(u, level.size(), linear, slack_.coordinate),
                     ys = read_by(v, level.size(), linear, slack_.coordinate);
        for (std::int64_t y = ys.first; y <= ys.last; ++y)
            for (std::int64_t x = xs.first; x <= xs.last; ++x)
                level.insert(wrapped(x, level.size(), lookup_.wrap_u),
                             wrapped(y, level.size(), lookup_.wrap_v));
    }

    const TextureLookup& lookup_;
    const LookupSlack& slack_;
    ViewTexels& texels_;
};

bool shows(const Surface& surface, int number) {
    return surface.material.shows(number);
}

}  // namespace

TextureFilter drawn_filter(const Scene& scene, int number, std::optional<TextureFilter> filter) {
    const TextureFilter own = scene.textures[std::size_t(number)].filter;
    if (filter || own != TextureFilter::linear) return filter.value_or(own);
    const bool in_blocks = std::ranges::any_of(scene.surfaces, [&](const Surface& surface) {
        return shows(surface, number) && !surface.blocks.empty();
    });
    return in_blocks ? TextureFilter::mip : own;
}

TextureLookup lookup_of(const Scene& scene, int number, std::optional<TextureFilter> filter,
                        std::uint32_t size) {
    const SceneTexture& texture = scene.textures[std::size_t(number)];
    TextureLookup lookup{size, drawn_filter(scene, number, filter), texture.wrap_u, texture.wrap_v};
    bool any_blocks = false;
    for (const Surface& surface : scene.surfaces) {
        any_blocks |= shows(surface, number) && !surface.blocks.empty();
        for (const Triangle& triangle : surface.triangles)
            lookup.blocks.push_back(surface.blocks.empty() ? Vec4f(0, 0, 1, 1)
                                                           : surface.blocks[triangle[2]]);
    }
    if (!any_blocks || lookup.filter != TextureFilter::mip) lookup.blocks.clear();
    if (lookup.blocks.size() >= most_numbered)
        throw Error(ExitCode::unsupported,
                    fmt::format("the mesh has {} triangles; which texels a picture of a quad atlas "
                                "shows is found for less than {}: bake it, or use a patch atlas",
                                lookup.blocks.size(), most_numbered));
    return lookup;
}

ViewTexels::ViewTexels(std::uint32_t size) {
    for (std::uint32_t n = size; n > 0; n /= 2) levels.emplace_back(n);
}

std::vector<TexelSet> ViewTexels::beneath(
    const std::function<std::uint32_t(std::uint32_t)>& source) const {
    std::vector<TexelSet> made;
    for (std::uint32_t l = 0; l < levels.size(); ++l) {
        made.emplace_back(levels[l].size());
        TexelSet texels = levels[l];
        const std::uint32_t from = source(l);
        for (std::uint32_t k = l; k > from; --k) texels = texels.beneath(levels[k - 1].size());
        made[from] |= texels;
    }
    return made;
}

std::uint64_t ViewTexels::count_tiles() const {
    std::uint64_t count = 0;
    for (const TexelSet& level : levels) count += level.count_tiles();
    return count;
}

ViewTexels& ViewTexels::operator|=(const ViewTexels& other) {
    for (std::size_t l = 0; l < levels.size(); ++l) levels[l] |= other.levels[l];
    return *this;
}

void add_lookups(const Image<LookupSample>& samples, const TextureLookup& lookup,
                 ViewTexels& texels, const LookupSlack& slack) {
    tbb::enumerable_thread_specific<ViewTexels> parts{ViewTexels(lookup.size)};
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, samples.height(), 16),
                      [&](const auto& rows) {
                          Marker mark(lookup, slack, parts.local());
                          for (std::size_t y = rows.begin(); y < rows.end(); ++y)
                              for (const LookupSample& sample : samples.row(y)) mark(sample);
                      });
    for (const ViewTexels& part : parts) texels |= part;
}

}  // namespace burl
