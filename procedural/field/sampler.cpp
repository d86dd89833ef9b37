// Evaluation of the field: octaves with a vectorised kernel by OctaveStreams, the others texel by
// texel in float32.
#include "procedural/field/sampler.h"

#include <algorithm>
#include <cmath>

#include "procedural/kernels/quadric_kernel.h"
#include "procedural/model/band_limit.h"
#include "procedural/noise/lattice_site.h"
#include "procedural/noise/noise.h"

namespace burl {

namespace {

/// A piece in an octave's lattice coordinates; a coordinate that leaves the lattice (lattice_limit)
/// is 0 on the whole line.
struct LatticePiece {
    LatticeLine line;
    Vec3d down{0.0};
    std::size_t at = 0;  ///< index of the piece's first texel in the batch

    LatticePiece(const Affine3& map, const Piece& piece, std::size_t first)
        : line(lattice_line(map, piece.solid, piece.length)),
          down(map.linear * piece.down),
          at(first) {
        for (int axis = 0; axis < 3; ++axis)
            if (!(std::abs(down[axis]) < lattice_limit)) down[axis] = 0.0;
    }

    /// The lattice point of texel j, at its offset if `offsets` is not null.
    Point<3> point(std::size_t j, const TexelOffsets* offsets) const {
        double x = line.first + double(j);
        if (offsets) x += double(offsets->u[at + j]);
        Vec3d p = line.start + x * line.step;
        if (offsets) p += double(offsets->v[at + j]) * down;
        return {p.x, p.y, p.z};
    }
};

/// values[j] += scale * the octave's shaped noise, for the texels of one piece.
void add_values(const Octave& octave, double scale, const LatticePiece& piece,
                const TexelOffsets* offsets, double* values) {
    for (std::size_t j = 0; j < piece.line.count; ++j) {
        const float n = noise_value<float, 3>(octave.noise, piece.point(j, offsets));
        values[piece.at + j] += scale * double(shaped(octave.shape, n));
    }
}

/// noise[j] = the octave's shaped noise without scale and offset, for the texels of one piece.
void fill_noise(const Octave& octave, const LatticePiece& piece, float* noise) {
    for (std::size_t j = 0; j < piece.line.count; ++j)
        noise[piece.at + j] =
            shaped(octave.shape, noise_value<float, 3>(octave.noise, piece.point(j, nullptr)));
}

/// Adds the octave to the values, and its derivatives along the texel's sides to the slopes.
void add_values_and_slopes(const Octave& octave, double scale, const LatticePiece& piece,
                           double* values, SlopeBatch& slopes) {
    for (std::size_t j = 0; j < piece.line.count; ++j) {
        const auto n =
            shaped(octave.shape, sample_noise<float, 3>(octave.noise, piece.point(j, nullptr)));
        const Vec3d gradient(n.gradient[0], n.gradient[1], n.gradient[2]);
        values[piece.at + j] += scale * double(n.value);
        slopes.u[piece.at + j] += float(scale * glm::dot(gradient, piece.line.step));
        slopes.v[piece.at + j] += float(scale * glm::dot(gradient, piece.down));
    }
}

/// The octaves that are evaluated. Where `skips` forbids leaving out octaves of amplitude 0, they
/// come last, so that they do not change the grouping of the others.
std::vector<Octave> octaves_of(const Texture& texture, const Skips& skips) {
    std::vector<Octave> octaves = expand_octaves(texture);
    if (skips.allows(Skip::zero_terms)) return octaves;
    for (const Octave& octave : idle_octaves(texture)) octaves.push_back(octave);
    return octaves;
}

}  // namespace

FieldSampler::FieldSampler(const Texture& texture, bool band_limit, Kernel kernel,
                           const Skips& skips)
    : quadric_(texture.quadric),
      streams_(octaves_of(texture, skips), kernel, band_limit, skips),
      band_limit_(band_limit),
      skips_(skips) {
    if (skips.allows(Skip::zero_terms)) idle_octaves_ = idle_octaves(texture).size();
    for (const Octave& octave : octaves_of(texture, skips)) {
        constant_ += octave.offset;
        // (The mean of octaves with a kernel is 0.)
        if (!has_kernel(octave))
            scalar_octaves_.push_back({octave, band_limit ? octave_mean(octave) : 0.0});
    }
}

void FieldSampler::values(FieldBatch& batch) const {
    fill_quadric(batch);
    streams_.add(batch.pieces, batch.count, batch.streams, batch.field);
    add_scalar_octaves(batch, nullptr, nullptr);
}

void FieldSampler::values(FieldBatch& batch, const KeptBatch& kept) const {
    const std::size_t scalars = scalar_octaves_.size(), streamed = kept.octaves.size() - scalars;
    if (kept.start.known) {
        count_idle(batch);
    } else if (kept.quadric_known) {
        std::copy_n(kept.quadric + kept.at, batch.count, batch.field);
        add_constant(batch);
    } else {
        fill_parabolas_of(batch);
        if (kept.quadric) std::copy_n(batch.field, batch.count, kept.quadric + kept.at);
        add_constant(batch);
    }
    streams_.add_kept(batch.pieces, batch.count, kept.part(0, streamed), batch.streams,
                      batch.field);
    add_kept_scalar_octaves(batch, kept.part(streamed, scalars));
}

bool FieldSampler::needs_pieces(const KeptBatch& kept, double longest) const {
    const std::size_t streamed = kept.octaves.size() - scalar_octaves_.size();
    return !(kept.quadric_known || kept.start.known) ||
           !std::ranges::all_of(kept.octaves.subspan(streamed), &KeptNoise::known) ||
           streams_.needs_pieces(kept.part(0, streamed), longest);
}

std::vector<NoiseKey> FieldSampler::noise_keys() const {
    std::vector<NoiseKey> keys = streams_.noise_keys();
    for (const auto& [octave, mean] : scalar_octaves_)
        keys.push_back({octave.noise, octave.shape, octave.lattice_from_solid});
    return keys;
}

void FieldSampler::values_and_slopes(FieldBatch& batch) const {
    fill_quadric(batch);
    fill_quadric_slopes(quadric_, batch.pieces, batch.slopes);
    streams_.add(batch.pieces, batch.count, batch.streams, batch.field, &batch.slopes);
    add_scalar_octaves(batch, &batch.slopes, nullptr);
}

void FieldSampler::values_at_offsets(FieldBatch& batch) const {
    fill_quadric_at_offsets(batch);
    streams_.add(batch.pieces, batch.count, batch.streams, batch.field, nullptr, &batch.offsets);
    add_scalar_octaves(batch, nullptr, &batch.offsets);
}

void FieldSampler::fill_quadric(FieldBatch& batch) const {
    fill_parabolas_of(batch);
    add_constant(batch);
}

/// batch.field = the quadric, which along the line of a piece is a parabola.
void FieldSampler::fill_parabolas_of(FieldBatch& batch) const {
    batch.parabolas.resize(batch.pieces.size());
    make_parabolas(quadric_, 0.0, batch.pieces, batch.parabolas);
    fill_parabolas(batch.parabolas, batch.field);
}

/// Adds the sum of the octaves' offsets. Separate from the quadric, whose cached values thus stay
/// valid when an offset changes.
void FieldSampler::add_constant(FieldBatch& batch) const {
    count_idle(batch);
    if (constant_ == 0.0) return;
    for (std::size_t j = 0; j < batch.count; ++j) batch.field[j] += constant_;
}

/// Counts the octaves of amplitude 0 as left out.
void FieldSampler::count_idle(FieldBatch& batch) const {
    batch.streams.work.skip_octaves(Skip::zero_terms, idle_octaves_ * batch.count);
}

void FieldSampler::fill_quadric_at_offsets(FieldBatch& batch) const {
    count_idle(batch);
    std::size_t at = 0;
    for (const Piece& piece : batch.pieces)
        for (std::size_t j = 0; j < piece.solid.count; ++j, ++at) {
            const double x = piece.solid.first + double(j) + double(batch.offsets.u[at]);
            const Vec3d p =
                piece.solid.start + x * piece.solid.step + double(batch.offsets.v[at]) * piece.down;
            batch.field[at] = evaluate_quadric(quadric_, p) + constant_;
        }
}

void FieldSampler::add_kept_scalar_octaves(FieldBatch& batch, const KeptBatch& kept) const {
    for (std::size_t k = 0; k < scalar_octaves_.size(); ++k) {
        const Octave& octave = scalar_octaves_[k].octave;
        const auto [noise, known] = kept.octaves[k];
        if (known)
            batch.streams.work.skip_octaves(Skip::kept_terms, batch.count);
        else
            batch.streams.work.octaves += batch.count;
        float* numbers = noise ? noise + kept.at : batch.streams.part.values;
        for (std::size_t i = 0, at = 0; !known && i < batch.pieces.size(); ++i) {
            fill_noise(octave, LatticePiece(octave.lattice_from_solid, batch.pieces[i], at),
                       numbers);
            at += batch.pieces[i].solid.count;
        }
        for (std::size_t j = 0; j < batch.count; ++j)
            batch.field[j] += octave.scale * double(numbers[j]);
    }
}

void FieldSampler::add_scalar_octaves(FieldBatch& batch, SlopeBatch* slopes,
                                      const TexelOffsets* offsets) const {
    for (const auto& [octave, mean] : scalar_octaves_) {
        std::size_t at = 0;
        for (const Piece& solid : batch.pieces) {
            const LatticePiece piece(octave.lattice_from_solid, solid, at);
            const double weight = band_limit_ ? band_weight(piece.line.step, piece.down) : 1.0;
            const double scale = weight * octave.scale, missing = (1.0 - weight) * mean;
            const std::size_t texels = solid.solid.count;
            if (weight == 0.0 && skips_.allows(Skip::band_limit)) {
                batch.streams.work.skip_octaves(Skip::band_limit, texels);
            } else {
                batch.streams.work.octaves += texels;
                if (slopes)
                    add_values_and_slopes(octave, scale, piece, batch.field, *slopes);
                else
                    add_values(octave, scale, piece, offsets, batch.field);
            }
            if (weight < 1.0)
                for (std::size_t j = 0; j < texels; ++j) batch.field[at + j] += missing;
            at += texels;
        }
    }
}

}  // namespace burl
