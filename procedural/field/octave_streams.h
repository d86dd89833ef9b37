#pragma once
// The octaves of a texture that have a vectorised kernel, added up group by group
// (octave_groups.h), each group by the kernel that is fastest for its pieces.
#include <algorithm>
#include <limits>
#include <vector>

#include "procedural/batch/economy.h"
#include "procedural/batch/kernel.h"
#include "procedural/field/kept_start.h"
#include "procedural/field/octave_groups.h"
#include "procedural/kernels/scanline_kernel.h"
#include "procedural/kernels/share_kernels.h"

namespace burl {

/// Sums of octaves over a batch, in units of stream_unit, with their gradients where slopes are
/// wanted.
struct OctaveSums {
    alignas(64) float values[batch_capacity + batch_padding];
    GradientSums gradients;

    /// Sets `count` sums and their padding to 0, and the gradients if `slopes`.
    void clear(std::size_t count, bool slopes) {
        std::fill_n(values, count + batch_padding, 0.0f);
        if (!slopes) return;
        for (float* along : gradients.along) std::fill_n(along, count + batch_padding, 0.0f);
    }
};

/// Scratch arrays of OctaveStreams, one per thread.
struct StreamBuffers {
    LatticeStream lattice;
    CellRuns runs;
    OctaveSums sums;
    OctaveSums part;  ///< one octave's sums, before they are weighted or cached
    /// Squared length of the texel's longer side in the lattice, one per piece.
    std::vector<double> squares;
    std::vector<ScanLine> lines;
    ScanSegments segments;
    SynthesisWork work;  ///< octaves evaluated and left out with these buffers
};

/// Sum of the octaves of a texture that have a kernel. Constant after construction: several threads
/// may use one object, each with its own buffers.
class OctaveStreams {
  public:
    /// Sums `octaves` by `kernel`; with `band_limit` every octave is weighted by band_weight of the
    /// texel's longer side; octaves of weight 0 are not evaluated where `skips` allows that.
    explicit OctaveStreams(std::span<const Octave> octaves, Kernel kernel = Kernel::automatic,
                           bool band_limit = false, const Skips& skips = {});

    /// values[j] += the octaves that have a kernel, without their constant offsets, at the centres
    /// of the pieces' texels, `count` in all, or at `offsets` from there. Within a group the sum is
    /// float32, from the finest octave to the coarsest; groups are added up in float64. The changes
    /// per texel along u and v are added to `slopes` if it is not null, which changes no bit of the
    /// values.
    void add(std::span<const Piece> pieces, std::size_t count, StreamBuffers& buffers,
             double* values, SlopeBatch* slopes = nullptr,
             const TexelOffsets* offsets = nullptr) const;

    /// The keys of the octaves' cached noise, in the order of KeptBatch::octaves.
    std::vector<NoiseKey> noise_keys() const;
    /// The summands of every group, in the order they are added.
    std::vector<FieldSum::Group> sum_groups() const;
    /// Adds the octaves with the bits of add() without slopes and offsets, but evaluates only
    /// octaves whose noise is not cached, and fills the caches of `kept` that are not yet known. If
    /// kept.start is known, its numbers replace the values and only the groups after it are added.
    /// `pieces` may be empty if all octaves are known, or if kept.lines is set and needs_pieces is
    /// false. Not allowed with a band limit.
    void add_kept(std::span<const Piece> pieces, std::size_t count, const KeptBatch& kept,
                  StreamBuffers& buffers, double* values) const;
    /// Whether add_kept needs pieces for a batch whose longest span has `longest` texels: if not,
    /// span lines do, since no octave that is still unknown goes by scan lines.
    bool needs_pieces(const KeptBatch& kept, double longest) const;

  private:
    /// Limit of scan-line polynomials: spans of at least `shortest` texels use them if the first
    /// octave crosses fewer than `most_crossings` lattice planes per texel.
    struct ScanLimit {
        double shortest = 0.0, most_crossings = 0.0;
    };
    /// Group of octaves with its kernels, and the limits of its scan-line polynomials, sorted by
    /// falling span length.
    struct Group : OctaveGroup {
        std::vector<ScanLimit> scans{};
        /// Length in texels of the shortest span that may be scanned; infinite: none may.
        double shortest_scan = std::numeric_limits<double>::infinity();
        /// Kernels without and with gradients; `sharing` ones are null for simplex noise.
        OctaveKernel direct[2] = {}, sharing[2] = {};
    };
    /// The kernels that add up a group's octaves.
    struct Plan {
        std::size_t shared = 0;  ///< number of the coarsest octaves, which share corners
        bool slopes = false;
        bool scanned = false;  ///< whether all octaves are scan-line polynomials

        OctaveKernel kernel(const Group& group, const StreamOctave& octave) const {
            const bool shares = std::size_t(octave.doublings) < shared;
            return shares ? group.sharing[slopes] : group.direct[slopes];
        }
    };
    /// Consecutive pieces that are added up in the same way: by scan-line polynomials (`scanned`)
    /// or by streams.
    struct Run {
        std::span<const Piece> pieces;
        std::size_t texels = 0;
        bool scanned = false;
    };
    std::vector<ScanLimit> scan_limits(const Group& group) const;
    bool scans(const Group& group, const Piece& piece) const;
    std::size_t sharing(const Group& group, double crossings, bool slopes) const;
    Run first_run(const Group& group, std::span<const Piece> pieces) const;
    void add_kept_octaves(const Group& group, const Plan& plan, std::size_t count,
                          const KeptBatch& kept, StreamBuffers& buffers) const;
    void add_kept_lines(const Group& group, const SpanLines& lines, const KeptBatch& kept,
                        StreamBuffers& buffers, double* values) const;
    void add_kept_pieces(const Group& group, std::span<const Piece> pieces, const KeptBatch& kept,
                         StreamBuffers& buffers, double* values) const;
    void add_scanned(const Group& group, const Run& run, StreamBuffers& buffers,
                     double* values) const;
    void add_streamed(const Group& group, const Run& run, StreamBuffers& buffers, double* values,
                      SlopeBatch* slopes, const TexelOffsets* offsets) const;
    void add_limited(const Group& group, const Plan& plan, std::span<const Piece> pieces,
                     std::size_t count, StreamBuffers& buffers) const;
    Plan prepare(const Group& group, std::span<const Piece> pieces, std::size_t count,
                 StreamBuffers& buffers, bool slopes, const TexelOffsets* offsets) const;
    Plan prepare_lines(const Group& group, const SpanLines& lines, StreamBuffers& buffers) const;
    Plan plan_of(const Group& group, double planes, std::size_t count, StreamBuffers& buffers,
                 bool slopes) const;

    std::vector<Group> groups_;
    Kernel kernel_;
    bool band_limit_;
    Skips skips_;
    bool wide_vectors_;
};

}  // namespace burl
