#include "procedural/bresenham/noise.h"

#include "procedural/bresenham/cell_polynomial.h"
#include "procedural/bresenham/cell_walk.h"
#include "procedural/bresenham/differences.h"
#include "procedural/noise/lattice_site.h"

namespace burl {

namespace {

/// The texels of one line and the array that their noise is added to.
struct Target {
    LatticeLine line;
    double scale = 1.0;
    double* sums = nullptr;  ///< element 0 belongs to texel `begin`
    std::int64_t begin = 0, end = 0;

    void add(std::int64_t texel, double n) const { sums[texel - begin] += scale * n; }
};

template <class Number, Fade fade>
void add_stretch(const CellBlend& blend, const CellStretch& stretch, std::int64_t longest,
                 const Target& to, ForwardCounts& counts) {
    constexpr std::size_t degree = 3 * fade_degree(fade);
    const CellSpan texels{stretch.first, stretch.last, to.begin, to.end};
    if (std::min(longest, stretch.last - stretch.first) <= std::int64_t(degree)) {
        for (std::int64_t j = texels.wanted_first(); j < texels.wanted_last(); ++j)
            to.add(j, blend_at(blend, fade, cell_place(to.line, stretch.cell, j)));
        counts.direct += texels.wanted_last() - texels.wanted_first();
        return;
    }
    counts.runs += for_each_run(texels, longest, [&](std::int64_t origin, std::int64_t last) {
        const auto powers =
            noise_along<fade>(blend, cell_place(to.line, stretch.cell, origin), to.line.step);
        run_differences(ForwardDifferences<Number, degree>(differences_at_zero(powers)), origin,
                        last, to.begin, [&](std::int64_t j, double n) { to.add(j, n); });
    });
}

template <class Number, Fade fade>
ForwardCounts add_line(const NoiseSpec& noise, std::int64_t longest, const Target& to) {
    ForwardCounts counts;
    const Period<3> period{noise.period[0], noise.period[1], noise.period[2]};
    for (CellWalk walk(to.line);; walk.advance()) {
        const CellBlend blend = cell_blend(walk.stretch().cell, noise.seed, period);
        add_stretch<Number, fade>(blend, walk.stretch(), longest, to, counts);
        ++counts.cells;
        if (walk.stretch().last >= to.end) return counts;
    }
}

template <class Number>
ForwardCounts add_line(const NoiseSpec& noise, std::int64_t longest, const Target& to) {
    switch (noise.fade) {
        case Fade::linear:
            return add_line<Number, Fade::linear>(noise, longest, to);
        case Fade::smooth:
            return add_line<Number, Fade::smooth>(noise, longest, to);
        case Fade::quintic:
            return add_line<Number, Fade::quintic>(noise, longest, to);
    }
    return {};
}

}  // namespace

ForwardCounts& ForwardCounts::operator+=(const ForwardCounts& more) {
    cells += more.cells;
    runs += more.runs;
    direct += more.direct;
    return *this;
}

std::int64_t longest_run(std::size_t degree, ForwardPrecision precision, double cells_per_texel) {
    switch (precision) {
        case ForwardPrecision::float32:
            // Sums drift by up to half a last place per texel. In a high degree, differences that
            // cancel each other also grow on the way through the cell.
            if (degree == 3) return 64;
            return std::int64_t(std::clamp(0.6 / cells_per_texel, 1.0, 64.0));
        case ForwardPrecision::float64:
            return 4096;
        case ForwardPrecision::fixed64:
            // Half a unit of the highest difference becomes binomial(texels, degree) halves.
            return degree == 3 ? 4096 : degree == 9 ? 64 : 32;
    }
    return 1;
}

std::string no_forward_form(const NoiseSpec& noise) {
    if (noise.kind != NoiseKind::value) return "only value noise is a polynomial along a line";
    if (noise.time) return "noise with a time is of four dimensions";
    return {};
}

ForwardCounts add_forward_noise(const NoiseSpec& noise, double scale, const LatticeLine& line,
                                const ForwardOptions& options, double* sums) {
    if (line.count == 0) return {};
    const auto first = std::int64_t(line.first);
    const Target to{line, scale, sums, first, first + std::int64_t(line.count)};
    const std::int64_t longest =
        options.longest_run > 0
            ? options.longest_run
            : longest_run(3 * fade_degree(noise.fade), options.precision, fastest_step(line));
    switch (options.precision) {
        case ForwardPrecision::float32:
            return add_line<float>(noise, longest, to);
        case ForwardPrecision::float64:
            return add_line<double>(noise, longest, to);
        case ForwardPrecision::fixed64:
            return add_line<std::int64_t>(noise, longest, to);
    }
    return {};
}

}  // namespace burl
