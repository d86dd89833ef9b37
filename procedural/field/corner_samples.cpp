// A row of corners is evaluated as a row of texels that is shifted by half a texel and one texel
// longer.
#include "procedural/field/corner_samples.h"

#include <algorithm>

namespace burl {

namespace {

/// Appends the batch's field to `values` and empties the batch.
void flush(const FieldSampler& sampler, FieldBatch& batch, std::vector<double>& values) {
    if (batch.count == 0) return;
    sampler.values(batch);
    values.insert(values.end(), batch.field, batch.field + batch.count);
    batch.pieces.clear();
    batch.count = 0;
}

/// Fills `values` with f at the corners `side` texels below the texels' centres, count + 1 per
/// piece.
void sample_row(const FieldSampler& sampler, const std::vector<Piece>& pieces, double side,
                FieldBatch& batch, std::vector<double>& values) {
    values.clear();
    for (const Piece& piece : pieces) {
        const Vec3d start = piece.solid.start - 0.5 * piece.solid.step + side * piece.down;
        for (std::size_t done = 0; done <= piece.solid.count;) {
            const std::size_t count =
                std::min(piece.solid.count + 1 - done, batch_capacity - batch.count);
            batch.pieces.push_back(
                {piece.x + done,
                 piece.y,
                 {start, piece.solid.step, piece.solid.first + double(done), count},
                 piece.down,
                 piece.length + 1.0});
            batch.count += count;
            done += count;
            if (batch.count == batch_capacity) flush(sampler, batch, values);
        }
    }
    flush(sampler, batch, values);
}

}  // namespace

void average_with_corners(const FieldSampler& sampler, FieldBatch& batch, CornerBuffers& buffers) {
    sample_row(sampler, batch.pieces, -0.5, *buffers.batch, buffers.upper);
    sample_row(sampler, batch.pieces, 0.5, *buffers.batch, buffers.lower);
    const double *upper = buffers.upper.data(), *lower = buffers.lower.data();
    std::size_t at = 0;
    for (const Piece& piece : batch.pieces) {
        for (std::size_t j = 0; j < piece.solid.count; ++j, ++at) {
            const double a = upper[j], b = upper[j + 1], c = lower[j], d = lower[j + 1];
            const double f = batch.field[at];
            // The mean of the four corners is f + (f_uu + f_vv) / 8 to second order.
            batch.field[at] = f + (0.25 * ((a - f) + (b - f) + (c - f) + (d - f))) / 3.0;
            batch.slopes.u[at] = float(0.5 * ((b - a) + (d - c)));
            batch.slopes.v[at] = float(0.5 * ((c - a) + (d - b)));
        }
        upper += piece.solid.count + 1;
        lower += piece.solid.count + 1;
    }
}

}  // namespace burl
