#pragma once
// The texture's field f for batches of texels, with its change along the texel's two sides where a
// filter asks for it (Hart et al. 1999, eq. 10 to 12), or at places other than the texels' centres.
#include <memory>
#include <vector>

#include "procedural/kept_noise.h"
#include "procedural/octave_streams.h"
#include "procedural/quadric_kernel.h"
#include "procedural/slope_kernels.h"
#include "procedural/texel_piece.h"

namespace burl {

/// What a thread works with: pieces of several spans packed into one stream of texels.
struct FieldBatch {
    std::vector<Piece> pieces;
    std::size_t count = 0;
    alignas(64) double field[batch_capacity + batch_padding];
    SlopeBatch slopes;
    TexelOffsets offsets;  ///< for values_at_offsets

    std::vector<ParabolaLine> parabolas;
    StreamBuffers streams;
};

/// Every texel is computed from its own span's start and its distance from it, so the batches'
/// limits leave no trace.
class FieldSampler {
  public:
    /// With `band_limit` octaves that a texel cannot show are left out, their mean stays.
    FieldSampler(const Texture& texture, bool band_limit, Kernel kernel = Kernel::automatic,
                 const Skips& skips = {});

    /// batch.field = f at the centres of the texels of batch.pieces.
    void values(FieldBatch& batch) const;
    /// The same to the bit, but evaluates only octaves whose noise is not known, and keeps it. Not
    /// with a band limit.
    void values(FieldBatch& batch, const KeptBatch& kept) const;
    /// What the kept noise depends on, octave by octave.
    std::vector<NoiseKey> noise_keys() const;
    /// Besides, batch.slopes = df/du and df/dv per texel.
    void values_and_slopes(FieldBatch& batch) const;
    /// batch.field = f at batch.offsets.
    void values_at_offsets(FieldBatch& batch) const;

  private:
    /// An octave without a kernel.
    struct ScalarOctave {
        Octave octave;
        double mean = 0.0;  ///< without its offset
    };
    void fill_quadric(FieldBatch& batch) const;
    void fill_parabolas_of(FieldBatch& batch) const;
    void add_constant(FieldBatch& batch) const;
    void fill_quadric_at_offsets(FieldBatch& batch) const;
    void add_kept_scalar_octaves(FieldBatch& batch, const KeptBatch& kept) const;
    void add_scalar_octaves(FieldBatch& batch, SlopeBatch* slopes,
                            const TexelOffsets* offsets) const;

    Quadric quadric_;
    OctaveStreams streams_;
    std::vector<ScalarOctave> scalar_octaves_;
    double constant_ = 0.0;
    bool band_limit_;
    Skips skips_;
};

}  // namespace burl
