#include "procedural/field/octave_streams.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "procedural/kernels/simplex_kernel.h"
#include "procedural/model/band_limit.h"
#include "procedural/numbers/simd_target.h"

namespace burl {

namespace {

/// Crossover between kernels: an octave that crosses fewer lattice planes per texel, |dx| + |dy| +
/// |dz| for a step of one texel, is faster with shared corners. Hashes cost more where vectors have
/// fewer than 16 lanes. Measured with `burl bench kernels`.
constexpr double most_crossings(bool slopes, bool wide_vectors) {
    if (!wide_vectors) return 5.0 / 16;
    return slopes ? 8.0 / 32 : 7.0 / 32;
}

/// Range in which scan-line polynomials are faster, by 3 % or more, than the direct and the sharing
/// kernel, with AVX-512 and with AVX2. Their rounding differs from both others', so the choice must
/// not depend on the instruction set or on anything but the span. Measured with `burl bench
/// kernels`.
struct ScanRange {
    NoiseKind kind;
    bool linear;                ///< value noise with the linear fade
    std::size_t octaves = 0;    ///< largest number of octaves in a group
    double shortest = 0.0;      ///< length of the shortest span in texels
    double most_crossings = 0;  ///< lattice planes per texel that the finest octave may cross
};
constexpr ScanRange scan_ranges[] = {
    {NoiseKind::value, true, 1, 128, 3.0 / 16},    {NoiseKind::value, true, 1, 256, 5.0 / 16},
    {NoiseKind::value, true, 1, 1024, 7.0 / 16},   {NoiseKind::value, true, 2, 256, 3.0 / 16},
    {NoiseKind::value, true, 24, 512, 1.0 / 8},    {NoiseKind::value, false, 1, 256, 1.0 / 32},
    {NoiseKind::value, false, 1, 512, 1.0 / 4},    {NoiseKind::value, false, 2, 512, 1.0 / 64},
    {NoiseKind::perlin, false, 24, 128, 1.0 / 32}, {NoiseKind::perlin, false, 24, 256, 3.0 / 16},
    {NoiseKind::perlin, false, 1, 256, 1.0 / 4},   {NoiseKind::perlin, false, 1, 1024, 5.0 / 16}};

/// Adds `weight` times `part` to `sums` for the texels [at, at + count).
void add_weighted(float weight, const OctaveSums& part, std::size_t at, std::size_t count,
                  bool slopes, OctaveSums& sums) {
    const auto add = [&](const float* from, float* to) {
        for (std::size_t j = at; j < at + count; ++j) to[j] += weight * from[j];
    };
    add(part.values, sums.values);
    if (!slopes) return;
    for (int axis = 0; axis < 3; ++axis)
        add(part.gradients.along[axis], sums.gradients.along[axis]);
}

}  // namespace

OctaveStreams::OctaveStreams(std::span<const Octave> octaves, Kernel kernel, bool band_limit,
                             const Skips& skips)
    : kernel_(kernel), band_limit_(band_limit), skips_(skips), wide_vectors_(simd_lanes() >= 16) {
    for (OctaveGroup& octaves_of : group_octaves(octaves)) {
        Group& group = groups_.emplace_back(Group{std::move(octaves_of)});
        group.scans = scan_limits(group);
        for (const bool slopes : {false, true}) {
            const bool simplex = group.kind == NoiseKind::simplex;
            group.direct[slopes] = simplex  ? simplex_kernel(slopes)
                                   : slopes ? gradient_kernel(group.kind, group.fade)
                                            : direct_kernel(group.kind, group.fade);
            if (!simplex) group.sharing[slopes] = sharing_kernel(group.kind, group.fade, slopes);
        }
        if (kernel == Kernel::scanline && group.kind != NoiseKind::simplex)
            group.shortest_scan = 0.0;
        else if (!group.scans.empty())
            group.shortest_scan = group.scans.back().shortest;
    }
}

/// Whether a group is added up by scan-line polynomials on a piece; the piece's whole span alone
/// decides. (Mixing both ways within a group is slower than either.)
bool OctaveStreams::scans(const Group& group, const Piece& piece) const {
    const double length = std::max(piece.length, piece.solid.first + double(piece.solid.count));
    if (length < group.shortest_scan || length > longest_scan_line) return false;
    if (kernel_ == Kernel::scanline) return true;
    const auto allowed = std::ranges::find_if(
        group.scans, [&](const ScanLimit& limit) { return length >= limit.shortest; });
    const Vec3d step = glm::abs(group.lattice_from_solid.linear * piece.solid.step);
    return step.x + step.y + step.z < allowed->most_crossings;
}

/// The limits that scan_ranges sets a group: sorted by falling span length, with crossings that
/// never grow as spans get shorter.
std::vector<OctaveStreams::ScanLimit> OctaveStreams::scan_limits(const Group& group) const {
    std::vector<ScanLimit> limits;
    const bool linear = group.kind == NoiseKind::value && group.fade == Fade::linear;
    for (const ScanRange& range : scan_ranges)
        if (kernel_ == Kernel::automatic && range.kind == group.kind && range.linear == linear &&
            group.octaves.size() <= range.octaves)
            limits.push_back(
                {range.shortest, std::ldexp(range.most_crossings, 1 - int(group.octaves.size()))});
    std::ranges::sort(limits, std::greater(), &ScanLimit::shortest);
    for (std::size_t i = limits.size(); i-- > 1;)
        limits[i - 1].most_crossings =
            std::max(limits[i - 1].most_crossings, limits[i].most_crossings);
    return limits;
}

/// The number of a group's coarsest octaves that share corners if the first crosses `crossings`
/// lattice planes per texel.
std::size_t OctaveStreams::sharing(const Group& group, double crossings, bool slopes) const {
    if (kernel_ == Kernel::direct || group.kind == NoiseKind::simplex) return 0;
    if (kernel_ == Kernel::share) return group.octaves.size();
    const double most = most_crossings(slopes, wide_vectors_);
    std::size_t count = 0;
    while (count < group.octaves.size() && std::ldexp(crossings, int(count)) < most) ++count;
    return count;
}

/// Adds the band-limited octaves of a group: an octave that some pieces attenuate is evaluated by
/// itself and weighted piece by piece; an octave of weight 1 on all pieces adds the bits that it
/// adds without a limit.
void OctaveStreams::add_limited(const Group& group, const Plan& plan, std::span<const Piece> pieces,
                                std::size_t count, StreamBuffers& buffers) const {
    const Mat3d& map = group.lattice_from_solid.linear;
    buffers.squares.clear();
    for (const Piece& piece : pieces) {
        const double square = longer_squared(map * piece.solid.step, map * piece.down);
        buffers.squares.push_back(square < lattice_limit ? square : lattice_limit);
    }
    const auto [least, most] = std::ranges::minmax(buffers.squares);
    for (std::size_t k = group.octaves.size(); k-- > 0;) {
        const double finer = std::ldexp(1.0, 2 * int(k));
        if (band_weight(finer * least) == 0.0 && skips_.allows(Skip::band_limit)) {
            buffers.work.skip_octaves(Skip::band_limit, count);
            continue;
        }
        buffers.work.octaves += count;
        const bool whole = band_weight(finer * most) == 1.0;
        OctaveSums& sums = whole ? buffers.sums : buffers.part;
        if (!whole) sums.clear(count, plan.slopes);
        plan.kernel(group, group.octaves[k])(group.octaves[k], buffers.lattice, &buffers.runs,
                                             count, sums.values, &sums.gradients);
        if (whole) continue;
        std::size_t at = 0;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const auto weight = float(band_weight(finer * buffers.squares[i]));
            const std::size_t texels = pieces[i].solid.count;
            if (weight > 0.0f)
                add_weighted(weight, buffers.part, at, texels, plan.slopes, buffers.sums);
            at += texels;
        }
    }
}

/// Fills the stream of lattice coordinates, and the runs of cells of the octaves that share
/// corners.
OctaveStreams::Plan OctaveStreams::prepare(const Group& group, std::span<const Piece> pieces,
                                           std::size_t count, StreamBuffers& buffers, bool slopes,
                                           const TexelOffsets* offsets) const {
    const Affine3& map = group.lattice_from_solid;
    const double planes = fill_stream(map, group.finest(), pieces, buffers.lattice, group.period());
    if (offsets) move_stream(map, pieces, *offsets, buffers.lattice);
    return plan_of(group, planes, count, buffers, slopes);
}

OctaveStreams::Plan OctaveStreams::prepare_lines(const Group& group, const SpanLines& lines,
                                                 StreamBuffers& buffers) const {
    const double planes = fill_stream(group.lattice_from_solid, group.finest(), lines,
                                      buffers.lattice, group.period());
    return plan_of(group, planes, lines.texels, buffers, false);
}

/// The plan for `count` texels whose lines cross `planes` lattice planes in all.
OctaveStreams::Plan OctaveStreams::plan_of(const Group& group, double planes, std::size_t count,
                                           StreamBuffers& buffers, bool slopes) const {
    const Plan plan{sharing(group, planes / double(count), slopes), slopes};
    if (plan.shared > 0) find_runs(buffers.lattice, int(plan.shared) - 1, count, buffers.runs);
    return plan;
}

void OctaveStreams::add_streamed(const Group& group, const Run& run, StreamBuffers& buffers,
                                 double* values, SlopeBatch* slopes,
                                 const TexelOffsets* offsets) const {
    const Plan plan = prepare(group, run.pieces, run.texels, buffers, slopes != nullptr, offsets);
    OctaveSums& sums = buffers.sums;
    sums.clear(run.texels, plan.slopes);
    if (band_limit_)
        add_limited(group, plan, run.pieces, run.texels, buffers);
    else
        for (std::size_t k = group.octaves.size(); k-- > 0;) {
            const StreamOctave& octave = group.octaves[k];
            plan.kernel(group, octave)(octave, buffers.lattice, &buffers.runs, run.texels,
                                       sums.values, &sums.gradients);
            buffers.work.octaves += run.texels;
        }
    const double unit = group.scale * stream_unit(group.kind);
    add_sums(unit, sums.values, run.texels, values);
    if (slopes) add_slopes(group.lattice_from_solid, unit, run.pieces, sums.gradients, *slopes);
}

void OctaveStreams::add_scanned(const Group& group, const Run& run, StreamBuffers& buffers,
                                double* values) const {
    map_scan_lines(group.lattice_from_solid, group.finest(), run.pieces, buffers.lines);
    buffers.sums.clear(run.texels, false);
    for (std::size_t k = group.octaves.size(); k-- > 0;)
        add_octave_scanline(group.kind, group.fade, group.octaves[k], buffers.lines,
                            buffers.segments, buffers.sums.values);
    buffers.work.octaves += group.octaves.size() * run.texels;
    add_sums(group.scale * stream_unit(group.kind), buffers.sums.values, run.texels, values);
}

/// The longest run that `pieces`, which are not empty, begin with.
OctaveStreams::Run OctaveStreams::first_run(const Group& group,
                                            std::span<const Piece> pieces) const {
    const bool scanned = scans(group, pieces.front());
    std::size_t end = 0, texels = 0;
    do texels += pieces[end++].solid.count;
    while (end < pieces.size() && scans(group, pieces[end]) == scanned);
    return {pieces.first(end), texels, scanned};
}

void OctaveStreams::add(std::span<const Piece> pieces, std::size_t count, StreamBuffers& buffers,
                        double* values, SlopeBatch* slopes, const TexelOffsets* offsets) const {
    const bool streams_alone = slopes || offsets || band_limit_;
    for (const Group& group : groups_) {
        double* to = values;
        for (std::span<const Piece> rest = pieces; !rest.empty();) {
            const Run run = streams_alone ? Run{rest, count} : first_run(group, rest);
            if (run.scanned)
                add_scanned(group, run, buffers, to);
            else
                add_streamed(group, run, buffers, to, slopes, offsets);
            rest = rest.subspan(run.pieces.size());
            to += run.texels;
        }
    }
}

}  // namespace burl
