// Octaves with a vectorised kernel are split into cells and places, the others are evaluated texel
// by texel in float32.
#include "procedural/field_sampler.h"

#include <algorithm>
#include <cmath>

#include "procedural/band_limit.h"
#include "procedural/lattice_line.h"
#include "procedural/noise.h"
#include "procedural/quadric_kernel.h"

namespace burl {

namespace {

/// The pieces in an octave's lattice coordinates. What leaves the lattice stays at its origin.
void fill_lines(const Affine3& map, FieldBatch& batch) {
    batch.lines.clear();
    for (const Piece& piece : batch.pieces)
        batch.lines.push_back(lattice_line(map, piece.solid, piece.length));
}

/// The pieces' steps to the next row in an octave's lattice coordinates.
void fill_downs(const Affine3& map, FieldBatch& batch) {
    batch.downs.clear();
    for (const Piece& piece : batch.pieces) {
        Vec3d down = map.linear * piece.down;
        for (int axis = 0; axis < 3; ++axis)
            if (!(std::abs(down[axis]) < lattice_limit)) down[axis] = 0.0;
        batch.downs.push_back(down);
    }
}

/// Calls visit(texel of the batch, its lattice point), at the offsets if wanted.
template <class Visit>
void for_each_point(const FieldBatch& batch, bool offsets, Visit&& visit) {
    std::size_t at = 0;
    for (std::size_t i = 0; i < batch.lines.size(); ++i) {
        const LatticeLine& line = batch.lines[i];
        for (std::size_t j = 0; j < line.count; ++j, ++at) {
            double x = line.first + double(j);
            if (offsets) x += double(batch.offset_u[at]);
            Vec3d p = line.start + x * line.step;
            if (offsets) p += double(batch.offset_v[at]) * batch.downs[i];
            visit(i, at, p);
        }
    }
}

void split_at_offsets(FieldBatch& batch) {
    for_each_point(batch, true, [&](std::size_t, std::size_t at, const Vec3d& p) {
        const LatticeSite<float, 3> site = lattice_site<float, 3>({p.x, p.y, p.z});
        for (std::size_t axis = 0; axis < 3; ++axis) {
            batch.lattice.cells[axis][at] = std::int32_t(std::uint32_t(site.cell[axis]));
            batch.lattice.places[axis][at] = site.place[axis];
        }
    });
}

void fill_directions(FieldBatch& batch) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        float *u = batch.directions.along_u[axis], *v = batch.directions.along_v[axis];
        for (std::size_t i = 0; i < batch.lines.size(); ++i) {
            const std::size_t count = batch.lines[i].count;
            u = std::fill_n(u, count, float(batch.lines[i].step[int(axis)]));
            v = std::fill_n(v, count, float(batch.downs[i][int(axis)]));
        }
    }
}

void add_scalar_noise(const Octave& octave, FieldBatch& batch, bool offsets, double* sums) {
    for_each_point(batch, offsets, [&](std::size_t, std::size_t at, const Vec3d& p) {
        const float n = noise_value<float, 3>(octave.noise, {p.x, p.y, p.z});
        sums[at] += octave.scale * double(shaped(octave.shape, n));
    });
}

void add_scalar_slopes(const Octave& octave, FieldBatch& batch, double* sums, SlopeBatch& slopes) {
    for_each_point(batch, false, [&](std::size_t i, std::size_t at, const Vec3d& p) {
        const auto n = shaped(octave.shape, sample_noise<float, 3>(octave.noise, {p.x, p.y, p.z}));
        const Vec3d gradient(n.gradient[0], n.gradient[1], n.gradient[2]);
        sums[at] += octave.scale * double(n.value);
        slopes.u[at] += float(octave.scale * glm::dot(gradient, batch.lines[i].step));
        slopes.v[at] += float(octave.scale * glm::dot(gradient, batch.downs[i]));
    });
}

/// Adds the octave of batch.lines to sums and, if wanted, slopes.
void add_octave(const Octave& octave, FieldBatch& batch, bool with_slopes, bool offsets,
                double* sums, SlopeBatch& slopes) {
    const NoiseSpec& noise = octave.noise;
    if (!has_kernel(octave))
        return with_slopes ? add_scalar_slopes(octave, batch, sums, slopes)
                           : add_scalar_noise(octave, batch, offsets, sums);
    offsets ? split_at_offsets(batch) : split_lattice_lines(batch.lines, batch.lattice);
    if (!with_slopes)
        return add_noise(noise.kind, noise.fade, noise.seed, octave.scale, batch.lattice,
                         batch.count, sums);
    fill_directions(batch);
    add_noise_and_slopes(noise.kind, noise.fade, noise.seed, octave.scale, batch.lattice,
                         batch.directions, batch.count, sums, slopes);
}

/// The pieces' shares of the octave of batch.lines and batch.downs; false where all have all of it.
bool fill_weights(FieldBatch& batch) {
    batch.weights.clear();
    for (std::size_t i = 0; i < batch.lines.size(); ++i)
        batch.weights.push_back(band_weight(batch.lines[i].step, batch.downs[i]));
    return std::any_of(batch.weights.begin(), batch.weights.end(),
                       [](double w) { return w < 1.0; });
}

}  // namespace

FieldSampler::FieldSampler(const Texture& texture, bool band_limit, Kernel kernel)
    : quadric_(texture.quadric),
      octaves_(expand_octaves(texture)),
      streams_(octaves_, kernel),
      band_limit_(band_limit) {
    for (const Octave& octave : octaves_) constant_ += octave.offset;
    if (band_limit)
        for (const Octave& octave : octaves_) means_.push_back(octave_mean(octave));
}

void FieldSampler::values(FieldBatch& batch) const {
    sample(batch, Wanted::values);
}

void FieldSampler::values_and_slopes(FieldBatch& batch) const {
    sample(batch, Wanted::slopes);
}

void FieldSampler::values_at_offsets(FieldBatch& batch) const {
    sample(batch, Wanted::offsets);
}

/// The quadric along a line is a parabola; the noise's constant parts come with it.
void FieldSampler::fill_quadric(FieldBatch& batch, Wanted wanted) const {
    if (wanted == Wanted::offsets) return fill_quadric_at_offsets(batch);
    batch.parabolas.resize(batch.pieces.size());
    make_parabolas(quadric_, constant_, batch.pieces, batch.parabolas);
    fill_parabolas(batch.parabolas, batch.field);
    if (wanted == Wanted::slopes) fill_quadric_slopes(batch);
}

/// Both slopes are linear along a line.
void FieldSampler::fill_quadric_slopes(FieldBatch& batch) const {
    std::size_t at = 0;
    for (std::size_t i = 0; i < batch.pieces.size(); ++i) {
        const auto& [start, step, first, count] = batch.pieces[i].solid;
        const Vec3d& down = batch.pieces[i].down;
        const Vec3d turn = half_gradient_change(quadric_, step);
        const double u = batch.parabolas[i].c1, u_step = 2.0 * batch.parabolas[i].c2;
        const double v = 2.0 * glm::dot(half_gradient(quadric_, start), down);
        const double v_step = 2.0 * glm::dot(turn, down);
        for (std::size_t j = 0; j < count; ++j, ++at) {
            const double x = first + double(j);
            batch.slopes.u[at] = float(u + x * u_step);
            batch.slopes.v[at] = float(v + x * v_step);
        }
    }
}

void FieldSampler::fill_quadric_at_offsets(FieldBatch& batch) const {
    std::size_t at = 0;
    for (const Piece& piece : batch.pieces)
        for (std::size_t j = 0; j < piece.solid.count; ++j, ++at) {
            const double x = piece.solid.first + double(j) + double(batch.offset_u[at]);
            const Vec3d p =
                piece.solid.start + x * piece.solid.step + double(batch.offset_v[at]) * piece.down;
            batch.field[at] = evaluate_quadric(quadric_, p) + constant_;
        }
}

/// An octave of which some pieces get a part only: what is 1 adds the same bits as unweighted.
void FieldSampler::add_weighted(std::size_t octave, FieldBatch& batch, Wanted wanted) const {
    const bool slopes = wanted == Wanted::slopes;
    std::fill_n(batch.part, batch.count, 0.0);
    std::fill_n(batch.part_slopes.u, batch.count, 0.0f);
    std::fill_n(batch.part_slopes.v, batch.count, 0.0f);
    if (std::any_of(batch.weights.begin(), batch.weights.end(), [](double w) { return w > 0.0; }))
        add_octave(octaves_[octave], batch, slopes, wanted == Wanted::offsets, batch.part,
                   batch.part_slopes);
    std::size_t at = 0;
    for (std::size_t i = 0; i < batch.lines.size(); ++i) {
        const double weight = batch.weights[i];
        const double missing = weight < 1.0 ? (1.0 - weight) * means_[octave] : 0.0;
        for (std::size_t j = 0; j < batch.lines[i].count; ++j, ++at) {
            if (weight > 0.0) batch.field[at] += weight * batch.part[at];
            if (weight < 1.0) batch.field[at] += missing;
            if (!slopes) continue;
            batch.slopes.u[at] += float(weight) * batch.part_slopes.u[at];
            batch.slopes.v[at] += float(weight) * batch.part_slopes.v[at];
        }
    }
}

void FieldSampler::sample(FieldBatch& batch, Wanted wanted) const {
    fill_quadric(batch, wanted);
    const bool streams = wanted == Wanted::values && !band_limit_;
    if (streams) streams_.add(batch.pieces, batch.count, batch.streams, batch.field);
    for (std::size_t k = 0; k < octaves_.size(); ++k) {
        if (streams && has_kernel(octaves_[k])) continue;
        fill_lines(octaves_[k].lattice_from_solid, batch);
        if (wanted != Wanted::values || band_limit_)
            fill_downs(octaves_[k].lattice_from_solid, batch);
        if (band_limit_ && fill_weights(batch)) {
            add_weighted(k, batch, wanted);
            continue;
        }
        add_octave(octaves_[k], batch, wanted == Wanted::slopes, wanted == Wanted::offsets,
                   batch.field, batch.slopes);
    }
}

}  // namespace burl
