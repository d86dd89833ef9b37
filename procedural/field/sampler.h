#pragma once
// The texture's field f for batches of texels, with its change along the texel's two sides where a
// filter asks for it (Hart et al. 1999, eq. 10 to 12), or at places other than the texels' centres.
#include <memory>
#include <vector>

#include "procedural/field/batch.h"
#include "procedural/field/kept_noise.h"
#include "procedural/field/octave_streams.h"

namespace burl {

/// Every texel is computed from its own span's start and its distance from it, so the batches'
/// limits leave no trace.
class FieldSampler {
  public:
    /// With `band_limit` octaves that a texel cannot show are left out, their mean stays.
    FieldSampler(const Texture& texture, bool band_limit, Kernel kernel = Kernel::automatic,
                 const Skips& skips = {});

    /// batch.field = f at the centres of the texels of batch.pieces.
    void values(FieldBatch& batch) const;
    /// The same to the bit, but evaluates only octaves whose noise is not known, and keeps it, as
    /// it does a start that is to be kept (OctaveStreams::add_kept). Not with a band limit.
    void values(FieldBatch& batch, const KeptBatch& kept) const;
    /// Whether that needs pieces where the longest span has so many texels, or lines serve as well.
    bool needs_pieces(const KeptBatch& kept, double longest) const;
    /// What the kept noise depends on, octave by octave.
    std::vector<NoiseKey> noise_keys() const;
    FieldSum sum() const { return {quadric_, constant_, streams_.sum_groups()}; }
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
    void count_idle(FieldBatch& batch) const;
    void fill_quadric_at_offsets(FieldBatch& batch) const;
    void add_kept_scalar_octaves(FieldBatch& batch, const KeptBatch& kept) const;
    void add_scalar_octaves(FieldBatch& batch, SlopeBatch* slopes,
                            const TexelOffsets* offsets) const;

    Quadric quadric_;
    OctaveStreams streams_;
    std::vector<ScalarOctave> scalar_octaves_;
    double constant_ = 0.0;
    std::size_t idle_octaves_ = 0;  ///< left out, of no amplitude
    bool band_limit_;
    Skips skips_;
};

}  // namespace burl
