// Sums of octaves with cached noise (kept_noise.h): the additions are those of a sum from scratch,
// but only octaves that are not in the cache are evaluated.
#include <algorithm>
#include <utility>

#include "procedural/field/octave_streams.h"
#include "procedural/kernels/stream_kernels.h"

namespace burl {

namespace {

/// Adds a group whose octaves are all in the cache.
void add_known_group(const OctaveGroup& group, const KeptBatch& kept, std::size_t count,
                     SynthesisWork& work, double* values) {
    std::vector<KeptSummand> summands;
    for (std::size_t k = group.octaves.size(); k-- > 0;)
        summands.push_back({group.octaves[k].weight, kept.octaves[k].noise + kept.at});
    add_kept_sums(summands, group.scale * stream_unit(group.kind), count, values);
    work.skip_octaves(Skip::kept_terms, group.octaves.size() * count);
}

bool keeps_any(const KeptBatch& kept) {
    return std::ranges::any_of(kept.octaves, [](const KeptNoise& octave) { return octave.noise; });
}

bool knows_all(const KeptBatch& kept) {
    return std::ranges::all_of(kept.octaves, &KeptNoise::known);
}

}  // namespace

std::vector<FieldSum::Group> OctaveStreams::sum_groups() const {
    std::vector<FieldSum::Group> groups;
    for (const Group& group : groups_) {
        FieldSum::Group& sum = groups.emplace_back();
        sum.scale = group.scale;
        for (const StreamOctave& octave : group.octaves) {
            NoiseKey& key = sum.keys.emplace_back();
            key.noise.kind = group.kind, key.noise.fade = group.fade, key.noise.seed = octave.seed;
            key.noise.radius2 = group.radius2;
            key.lattice_from_solid = group.lattice_from_solid;
            key.doublings = octave.doublings;
            key.most_doublings = group.finest();
            sum.weights.push_back(octave.weight);
        }
    }
    return groups;
}

std::vector<NoiseKey> OctaveStreams::noise_keys() const {
    std::vector<NoiseKey> keys;
    for (const FieldSum::Group& group : sum_groups())
        keys.insert(keys.end(), group.keys.begin(), group.keys.end());
    return keys;
}

/// buffers.sums = the sum of the group's octaves; noise that has a place in the cache but is not
/// known is evaluated and stored there.
void OctaveStreams::add_kept_octaves(const Group& group, const Plan& plan, std::size_t count,
                                     const KeptBatch& kept, StreamBuffers& buffers) const {
    buffers.sums.clear(count, false);
    for (std::size_t k = group.octaves.size(); k-- > 0;) {
        const auto [noise, known] = kept.octaves[k];
        StreamOctave octave = group.octaves[k];
        if (known) {
            add_scaled(octave.weight, noise + kept.at, count, buffers.sums.values);
            buffers.work.skip_octaves(Skip::kept_terms, count);
            continue;
        }
        buffers.work.octaves += count;
        const auto add_to = [&](OctaveSums& sums) {
            if (plan.scanned)
                add_octave_scanline(group.kind, group.fade, octave, buffers.lines, buffers.segments,
                                    sums.values);
            else
                plan.kernel(group, octave)(octave, buffers.lattice, &buffers.runs, count,
                                           sums.values, nullptr);
        };
        if (!noise) {
            add_to(buffers.sums);
            continue;
        }
        const float weight = std::exchange(octave.weight, 1.0f);
        buffers.part.clear(count, false);
        add_to(buffers.part);
        std::copy_n(buffers.part.values, count, noise + kept.at);
        add_scaled(weight, buffers.part.values, count, buffers.sums.values);
    }
}

void OctaveStreams::add_kept_pieces(const Group& group, std::span<const Piece> pieces,
                                    const KeptBatch& kept, StreamBuffers& buffers,
                                    double* values) const {
    KeptBatch own = kept;
    for (std::span<const Piece> rest = pieces; !rest.empty();) {
        const Run run = first_run(group, rest);
        Plan plan{.scanned = run.scanned};
        if (run.scanned)
            map_scan_lines(group.lattice_from_solid, group.finest(), run.pieces, buffers.lines);
        else
            plan = prepare(group, run.pieces, run.texels, buffers, false, nullptr);
        add_kept_octaves(group, plan, run.texels, own, buffers);
        add_sums(group.scale * stream_unit(group.kind), buffers.sums.values, run.texels, values);
        own.at += run.texels;
        values += run.texels;
        rest = rest.subspan(run.pieces.size());
    }
}

/// values[j] = lines.needed[j] + the group's sum, from span lines instead of pieces.
void OctaveStreams::add_kept_lines(const Group& group, const SpanLines& lines,
                                   const KeptBatch& kept, StreamBuffers& buffers,
                                   double* values) const {
    const double unit = group.scale * stream_unit(group.kind);
    const Plan plan = prepare_lines(group, lines, buffers);
    add_kept_octaves(group, plan, lines.texels, kept, buffers);
    add_sums_to(lines.needed, unit, buffers.sums.values, lines.texels, values);
}

bool OctaveStreams::needs_pieces(const KeptBatch& kept, double longest) const {
    std::size_t first = 0;
    for (std::size_t i = 0; i < groups_.size(); ++i) {
        const Group& group = groups_[i];
        const bool known = (kept.start.known && i < kept.start.groups) ||
                           knows_all(kept.part(first, group.octaves.size()));
        if (!known && longest >= group.shortest_scan) return true;
        first += group.octaves.size();
    }
    return false;
}

void OctaveStreams::add_kept(std::span<const Piece> pieces, std::size_t count,
                             const KeptBatch& kept, StreamBuffers& buffers, double* values) const {
    const FieldStart& start = kept.start;
    const auto keep_start = [&](std::size_t groups) {
        if (start.values && !start.known && start.groups == groups)
            std::copy_n(values, count, start.values + kept.at);
    };
    // The sum so far: in the cached prefix until something is added, then in `values`.
    const double* from = start.known ? start.values + kept.at : values;
    const auto fetch = [&] {
        if (from != values) std::copy_n(from, count, values);
        from = values;
    };
    std::size_t first = start.known ? start.octaves : 0;
    buffers.work.skip_octaves(Skip::kept_terms, first * count);
    for (std::size_t i = start.known ? start.groups : 0; i < groups_.size(); ++i) {
        const Group& group = groups_[i];
        const KeptBatch own = kept.part(first, group.octaves.size());
        first += group.octaves.size();
        keep_start(i);
        if (keeps_any(own) && knows_all(own)) {
            fetch();
            add_known_group(group, own, count, buffers.work, values);
        } else if (kept.lines) {
            SpanLines lines = *kept.lines;
            lines.needed = std::exchange(from, values);
            add_kept_lines(group, lines, own, buffers, values);
        } else {
            fetch();
            add_kept_pieces(group, pieces, own, buffers, values);
        }
    }
    fetch();
    keep_start(groups_.size());
}

}  // namespace burl
