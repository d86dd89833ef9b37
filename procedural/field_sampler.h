#pragma once
// The texture's field f for batches of texels, with its change along the texel's two sides where a
// filter asks for it (Hart et al. 1999, eq. 10 to 12), or at places other than the texels' centres.
#include <memory>
#include <vector>

#include "procedural/octave_streams.h"
#include "procedural/slope_kernels.h"
#include "procedural/texel_piece.h"

namespace burl {

/// What a thread works with: pieces of several spans packed into one stream of texels.
struct FieldBatch {
    std::vector<Piece> pieces;
    std::size_t count = 0;
    alignas(64) double field[batch_capacity + batch_padding];
    SlopeBatch slopes;
    /// For values_at_offsets: where in its texel a sample lies, from the centre, in texels.
    alignas(64) float offset_u[batch_capacity + batch_padding];
    alignas(64) float offset_v[batch_capacity + batch_padding];

    // Of one octave at a time.
    std::vector<LatticeLine> lines;
    std::vector<Vec3d> downs;
    std::vector<double> weights;
    std::vector<ParabolaLine> parabolas;
    StreamBuffers streams;
    LatticeBatch lattice;
    DirectionBatch directions;
    alignas(64) double part[batch_capacity + batch_padding];
    SlopeBatch part_slopes;
};

/// Every texel is computed from its own span's start and its distance from it, so the batches'
/// limits leave no trace.
class FieldSampler {
  public:
    /// With `band_limit` octaves that a texel cannot show are left out, their mean stays.
    FieldSampler(const Texture& texture, bool band_limit, Kernel kernel = Kernel::automatic);

    /// batch.field = f at the centres of the texels of batch.pieces.
    void values(FieldBatch& batch) const;
    /// Besides, batch.slopes = df/du and df/dv per texel.
    void values_and_slopes(FieldBatch& batch) const;
    /// batch.field = f at centre + batch.offset_u, batch.offset_v.
    void values_at_offsets(FieldBatch& batch) const;

  private:
    enum class Wanted { values, slopes, offsets };
    void sample(FieldBatch& batch, Wanted wanted) const;
    void fill_quadric(FieldBatch& batch, Wanted wanted) const;
    void fill_quadric_slopes(FieldBatch& batch) const;
    void fill_quadric_at_offsets(FieldBatch& batch) const;
    void add_weighted(std::size_t octave, FieldBatch& batch, Wanted wanted) const;

    Quadric quadric_;
    std::vector<Octave> octaves_;
    OctaveStreams streams_;
    std::vector<double> means_;  ///< of each octave without its offset; with band_limit only
    double constant_ = 0.0;
    bool band_limit_;
};

}  // namespace burl
