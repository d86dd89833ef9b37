// Choice of a kernel per texel: the cheapest one that is free of cancellation at the footprint's
// widths.
#include "procedural/field/stream_filter.h"

#include <algorithm>
#include <cmath>

#include "procedural/color/table.h"
#include "procedural/field/break_kernel.h"

namespace burl {

namespace {

/// Largest widths of a footprint, to which wider ones are reduced: with `repeat` the mean of the
/// map is then reached to within 1e-9, with `clamp` the halves to within 1e-12.
constexpr double widest_periodic = 0x1p30, widest_clamped = 0x1p40;

}  // namespace

StreamFilter::StreamFilter(const MapPieces& map, bool both_axes)
    : pieces_(map), breaks_(map), distance_(map), both_axes_(both_axes) {}

/// The widths of a texel's filter, both 0 if f or a slope is not finite.
FilterWidths StreamFilter::widths(double f, float u, float v) const {
    const FilterWidths both = FilterWidths::of(double(u), double(v));
    if (!std::isfinite(f + both.wide + both.narrow)) return {};
    return both_axes_ ? both : FilterWidths{both.box(), 0.0};
}

StreamFilter::Method StreamFilter::method_for(const FilterWidths& w) {
    const double support = w.wide + w.narrow;
    if (!(support >= 0x1p-6)) return Method::narrow;
    if (w.narrow < 1e-6 * w.wide) return Method::box;
    return w.narrow < 1e-3 * w.wide && support < 2.0 ? Method::rare : Method::trapezoid;
}

void StreamFilter::sort(const double* f, const SlopeBatch& slopes, std::size_t count,
                        FilterBuffers& buffers) const {
    index_colors(breaks_.wrap, f, count, BreakDistance::entry_count, buffers.entries);
    for (auto& texels : buffers.texels) texels.clear();
    const std::size_t bent =
        find_bent(distance_.data(), buffers.entries, slopes, count, buffers.bent);
    for (std::size_t i = 0; i < bent; ++i) {
        const std::size_t j = buffers.bent[i];
        const Method method = method_for(widths(f[j], slopes.u[j], slopes.v[j]));
        buffers.texels[int(method)].push_back(std::uint16_t(j));
    }
}

/// Fills the stream with footprints whose f is reduced to the map's period or range, so that adding
/// half a width rounds nothing off.
void StreamFilter::pack(const std::vector<std::uint16_t>& texels, const double* f,
                        const SlopeBatch& slopes, FootprintStream& stream) const {
    const bool repeat = breaks_.wrap == Wrap::repeat;
    const double widest = repeat ? widest_periodic : widest_clamped;
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const std::size_t j = texels[i];
        FilterWidths w = widths(f[j], slopes.u[j], slopes.v[j]);
        double x = std::isfinite(f[j]) ? f[j] : 0.0;
        if (w.wide > widest) {
            const double scale = widest / w.wide;
            w = {widest, w.narrow * scale};
            if (!repeat) x *= scale;
        }
        const double half = 0.5 * (w.wide + w.narrow);
        stream.f[i] = repeat ? x - std::floor(x) : std::clamp(x, -half, 1.0 + half);
        stream.wide[i] = w.wide;
        stream.narrow[i] = w.narrow;
    }
}

void StreamFilter::run(Method method, const double* f, const SlopeBatch& slopes,
                       FilterBuffers& buffers) const {
    FootprintStream& stream = buffers.stream;
    const std::size_t count = buffers.texels[int(method)].size();
    pack(buffers.texels[int(method)], f, slopes, stream);
    if (method == Method::narrow) return filter_narrow(breaks_, stream, count);
    if (method == Method::box) return filter_boxes(breaks_, stream, count);
    if (method == Method::trapezoid) return filter_trapezoids(breaks_, stream, count);
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3d color =
            trapezoid_filtered(pieces_, stream.f[i], {stream.wide[i], stream.narrow[i]});
        for (int c = 0; c < 3; ++c) stream.color[c][i] = color[c];
    }
}

}  // namespace burl
