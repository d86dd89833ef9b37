// Sums of octaves that stop where the colour is decided (early_exit.h). A group's octaves up to the
// last look at it are kept one by one, and added up with the finer ones in the usual order. What is
// decided leaves all arrays, so that kernels see the rest as one batch.
#include <algorithm>
#include <utility>

#include "procedural/field/exit_kernel.h"
#include "procedural/field/octave_streams.h"
#include "procedural/kernels/simplex_kernel.h"

namespace burl {

std::vector<double> OctaveStreams::octave_costs(std::span<const Piece> pieces, std::size_t count,
                                                StreamBuffers& buffers) const {
    std::vector<double> costs;
    for (const Group& group : groups_) {
        const Plan plan = prepare(group, pieces, count, buffers, false, nullptr);
        for (const StreamOctave& octave : group.octaves)
            costs.push_back(std::size_t(octave.doublings) < plan.shared ? shared_octave_cost : 1.0);
    }
    return costs;
}

/// sums[j] += the octave, at the first `count` texels of the stream.
void OctaveStreams::add_stream_octave(const Group& group, const StreamOctave& octave,
                                      const Plan& plan, std::size_t count, StreamBuffers& buffers,
                                      float* sums) {
    buffers.work.octaves += count;
    if (group.kind == NoiseKind::simplex)
        add_simplex_octave(octave, group.radius2, buffers.lattice, count, sums);
    else if (std::size_t(octave.doublings) < plan.shared)
        add_octave_shared(group.kind, group.fade, octave, buffers.lattice, buffers.runs, count,
                          sums);
    else
        add_octave_direct(group.kind, group.fade, octave, buffers.lattice, count, sums);
}

/// Closes what the estimates decide; they are the values there from now on. Whether anything was.
bool OctaveStreams::look_at(const ExitPlan& plan, const ExitPoint& point, const double* estimate,
                            ExitBuffers& exit, SynthesisWork& work, double* values) {
    exit.positions.resize(batch_capacity + 2 * batch_padding);
    const std::size_t undecided = find_undecided(plan.repeats, point.decided, estimate,
                                                 exit.open.texels(), exit.positions.data());
    const std::size_t closed =
        exit.open.close({exit.positions.data(), undecided},
                        [&](std::size_t from, std::size_t to, std::size_t count) {
                            std::copy_n(estimate + from, count, values + to);
                        });
    work.skip_octaves(point.octaves == 0 ? Skip::constant_tiles : Skip::early_exit,
                      closed * (plan.octaves - point.octaves));
    if (closed == 0) return false;
    exit.open.compact(exit.values);
    return true;
}

/// Coordinates of the open texels.
OctaveStreams::Plan OctaveStreams::prepare_open(const Group& group, std::span<const Piece> pieces,
                                                std::size_t count, const OpenBlocks& open,
                                                StreamBuffers& buffers) const {
    const Plan plan = prepare(group, pieces, count, buffers, false, nullptr);
    if (open.texels() == count) return plan;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        open.gather(buffers.lattice.cells[axis]);
        open.gather(buffers.lattice.places[axis]);
    }
    if (plan.shared > 0)
        find_runs(buffers.lattice, int(plan.shared) - 1, open.texels(), buffers.runs);
    return plan;
}

/// After look_at() closed some.
void OctaveStreams::compact_group(const Plan& plan, std::size_t known, ExitBuffers& exit,
                                  StreamBuffers& buffers) {
    exit.open.compact(exit.estimate);
    for (std::size_t k = 0; k < known; ++k) exit.open.compact(exit.noise[k].values);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        exit.open.compact(buffers.lattice.cells[axis]);
        exit.open.compact(buffers.lattice.places[axis]);
    }
    if (plan.shared > known && exit.open.texels() > 0)
        find_runs(buffers.lattice, int(plan.shared) - 1, exit.open.texels(), buffers.runs);
}

void OctaveStreams::add_group_open(const Group& group, std::size_t first, const ExitPlan& plan,
                                   std::span<const ExitPoint> points, std::span<const Piece> pieces,
                                   std::size_t count, StreamBuffers& buffers, ExitBuffers& exit,
                                   double* values) const {
    if (!points.empty() && points.front().octaves == first) {
        look_at(plan, points.front(), exit.values, exit, buffers.work, values);
        points = points.subspan(1);
        if (exit.open.texels() == 0) return;
    }
    const double unit = group.scale * stream_unit(group.kind);
    const Plan way = prepare_open(group, pieces, count, exit.open, buffers);
    std::size_t known = 0;
    if (!points.empty()) {
        std::copy_n(exit.values, exit.open.texels(), exit.estimate);
        exit.noise.resize(std::max(exit.noise.size(), points.back().octaves - first));
    }
    for (const ExitPoint& point : points) {
        for (; first + known < point.octaves; ++known) {
            StreamOctave octave = group.octaves[known];
            const double scale = unit * double(std::exchange(octave.weight, 1.0f));
            float* noise = exit.noise[known].values;
            std::fill_n(noise, exit.open.texels() + batch_padding, 0.0f);
            add_stream_octave(group, octave, way, exit.open.texels(), buffers, noise);
            add_sums(scale, noise, exit.open.texels(), exit.estimate);
        }
        if (look_at(plan, point, exit.estimate, exit, buffers.work, values))
            compact_group(way, known, exit, buffers);
        if (exit.open.texels() == 0) return;
    }
    const std::size_t open = exit.open.texels();
    float* sums = buffers.sums.values;
    std::fill_n(sums, open + batch_padding, 0.0f);
    for (std::size_t k = group.octaves.size(); k-- > known;)
        add_stream_octave(group, group.octaves[k], way, open, buffers, sums);
    for (std::size_t k = known; k-- > 0;)
        add_scaled(group.octaves[k].weight, exit.noise[k].values, open, sums);
    add_sums(unit, sums, open, exit.values);
}

void OctaveStreams::add_open(const ExitPlan& plan, std::span<const Piece> pieces, std::size_t count,
                             StreamBuffers& buffers, ExitBuffers& exit, double* values) const {
    exit.open.open(count);
    const auto scanned = [&](const Piece& piece) {
        return std::ranges::any_of(groups_,
                                   [&](const Group& group) { return scans(group, piece); });
    };
    if (std::ranges::any_of(pieces, scanned)) return add(pieces, count, buffers, values);
    std::copy_n(values, count, exit.values);
    std::span<const ExitPoint> points = plan.points;
    std::size_t first = 0;
    for (const Group& group : groups_) {
        const std::size_t last = first + group.octaves.size();
        std::size_t own = 0;
        while (own < points.size() && points[own].octaves < last) ++own;
        add_group_open(group, first, plan, points.first(own), pieces, count, buffers, exit, values);
        if (exit.open.texels() == 0) return;
        points = points.subspan(own);
        first = last;
    }
    for (const ExitPoint& point : points)
        look_at(plan, point, exit.values, exit, buffers.work, values);
    exit.open.scatter(exit.values, values);
}

}  // namespace burl
