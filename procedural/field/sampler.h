#pragma once
// The texture's field f for batches of texels, with its derivatives along the texel's sides where a
// filter asks for them (Hart et al. 1999, eq. 10 to 12), or at positions other than the texels'
// centres.
#include <memory>
#include <vector>

#include "procedural/batch/texel_batch.h"
#include "procedural/field/kept_start.h"
#include "procedural/field/octave_streams.h"
#include "procedural/kernels/quadric_kernel.h"
#include "procedural/kernels/slope_kernels.h"

namespace burl {

/// Batch of at most batch_capacity texels whose field is evaluated together, packed from pieces of
/// several spans, with the scratch arrays of the evaluation; one per thread.
struct FieldBatch {
    std::vector<Piece> pieces;
    /// Number of texels in all pieces.
    std::size_t count = 0;
    /// f of every texel, in the order of the pieces.
    alignas(64) double field[batch_capacity + batch_padding];
    /// df/du and df/dv per texel, filled by FieldSampler::values_and_slopes or
    /// average_with_corners.
    SlopeBatch slopes;
    /// Sample positions of FieldSampler::values_at_offsets.
    TexelOffsets offsets;

    std::vector<ParabolaLine> parabolas;
    StreamBuffers streams;
};

/// Evaluates f for batches of texels. A texel is computed from its span's start and its distance
/// from there, so that its bits do not depend on how spans are cut into batches. Constant after
/// construction: several threads may use one object, each with its own batch.
class FieldSampler {
  public:
    /// Samples the field of `texture`; with `band_limit` octaves are faded to their mean where a
    /// texel cannot show them (procedural/model/band_limit.h).
    FieldSampler(const Texture& texture, bool band_limit, Kernel kernel = Kernel::automatic,
                 const Skips& skips = {});

    /// Sets batch.field to f at the centres of the texels of batch.pieces.
    void values(FieldBatch& batch) const;
    /// Sets batch.field with the bits of values(batch), but evaluates only octaves whose noise is
    /// not cached, and fills the caches of `kept` (OctaveStreams::add_kept). Not allowed with a
    /// band limit.
    void values(FieldBatch& batch, const KeptBatch& kept) const;
    /// Whether values(batch, kept) needs pieces for a batch whose longest span has `longest`
    /// texels; if not, kept.lines does.
    bool needs_pieces(const KeptBatch& kept, double longest) const;
    /// The keys of the octaves' cached noise, in the order of KeptBatch::octaves.
    std::vector<NoiseKey> noise_keys() const;
    /// The summands of f, of which a prefix may be cached (kept_start.h).
    FieldSum sum() const { return {quadric_, constant_, streams_.sum_groups()}; }
    /// Sets batch.field to f at the texels' centres and batch.slopes to df/du and df/dv per texel.
    void values_and_slopes(FieldBatch& batch) const;
    /// Sets batch.field to f at the offsets batch.offsets from the texels' centres, in texels.
    void values_at_offsets(FieldBatch& batch) const;

  private:
    /// An octave without a vectorised kernel.
    struct ScalarOctave {
        Octave octave;
        double mean = 0.0;  ///< mean of the octave without its offset; 0 without a band limit
    };
    void fill_quadric(FieldBatch& batch) const;
    void fill_parabolas_of(FieldBatch& batch) const;
    void add_constant(FieldBatch& batch) const;
    void count_idle(FieldBatch& batch) const;
    void fill_quadric_at_offsets(FieldBatch& batch) const;
    void add_kept_scalar_octaves(FieldBatch& batch, const KeptBatch& kept) const;
    void add_scalar_octaves(FieldBatch& batch, SlopeBatch* slopes,
                            const TexelOffsets* offsets) const;

    Quadric quadric_;
    OctaveStreams streams_;
    std::vector<ScalarOctave> scalar_octaves_;
    double constant_ = 0.0;
    std::size_t idle_octaves_ = 0;  ///< number of octaves of amplitude 0, which are left out
    bool band_limit_;
    Skips skips_;
};

}  // namespace burl
