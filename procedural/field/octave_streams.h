#pragma once
// The octaves of a texture that vectorised kernels know, added up group by group
// (octave_groups.h), each in the way that is fastest for its pieces.
#include <algorithm>
#include <limits>
#include <vector>

#include "procedural/batch/economy.h"
#include "procedural/batch/kernel.h"
#include "procedural/field/kept_start.h"
#include "procedural/field/octave_groups.h"
#include "procedural/kernels/offset_kernel.h"
#include "procedural/kernels/scanline_kernel.h"
#include "procedural/kernels/share_kernels.h"

namespace burl {

/// Sums of octaves, their gradients where wanted.
struct OctaveSums {
    alignas(64) float values[batch_capacity + batch_padding];
    GradientSums gradients;

    void clear(std::size_t count, bool slopes) {
        std::fill_n(values, count + batch_padding, 0.0f);
        if (!slopes) return;
        for (float* along : gradients.along) std::fill_n(along, count + batch_padding, 0.0f);
    }
};

/// What a thread works with.
struct StreamBuffers {
    LatticeStream lattice;
    CellRuns runs;
    OctaveSums sums;
    OctaveSums part;  ///< an octave that some pieces show in part only
    std::vector<double> squares;
    std::vector<ScanLine> lines;
    ScanSegments segments;
    SynthesisWork work;  ///< octaves evaluated and left out with these buffers
};

class OctaveStreams {
  public:
    /// With `band_limit` octaves that a texel cannot show are left out of the sum, and not
    /// evaluated either where `skips` allows that.
    explicit OctaveStreams(std::span<const Octave> octaves, Kernel kernel = Kernel::automatic,
                           bool band_limit = false, const Skips& skips = {});

    /// values[j] += the octaves that have a kernel, without their offsets, at the centres of the
    /// pieces' texels, `count` in all, or at their `offsets`. Within a group the sum is float32,
    /// from the finest octave to the coarsest; groups are added up in float64. `slopes`, if wanted,
    /// += their changes; that leaves no trace in the values.
    void add(std::span<const Piece> pieces, std::size_t count, StreamBuffers& buffers,
             double* values, SlopeBatch* slopes = nullptr,
             const TexelOffsets* offsets = nullptr) const;

    /// What the numbers depend on that add_kept keeps, in its order.
    std::vector<NoiseKey> noise_keys() const;
    /// What sums are made of, group by group.
    std::vector<FieldSum::Group> sum_groups() const;
    /// As add() without slopes and offsets, to the bit, but evaluates only octaves whose noise is
    /// not known, and keeps it, as it does the start that is to be kept; a known one is in the
    /// values already. Where all are known it needs no pieces. Not with a band limit. Of a start
    /// that is known the values take the numbers.
    void add_kept(std::span<const Piece> pieces, std::size_t count, const KeptBatch& kept,
                  StreamBuffers& buffers, double* values) const;
    /// Whether a batch needs pieces whose longest span has so many texels, or the kept lines of its
    /// spans do.
    bool needs_pieces(const KeptBatch& kept, double longest) const;

  private:
    /// Spans this long are added up by scan-line polynomials where the first octave crosses fewer
    /// planes per texel.
    struct ScanLimit {
        double shortest = 0.0, most_crossings = 0.0;
    };
    struct Group : OctaveGroup {
        std::vector<ScanLimit> scans{};
        double shortest_scan = std::numeric_limits<double>::infinity();  ///< of those it may scan
    };
    /// How a group's octaves are added up.
    struct Plan {
        std::size_t shared = 0;  ///< number of its coarsest octaves that share corners
        bool slopes = false;
        bool scanned = false;  ///< instead
    };
    std::vector<ScanLimit> scan_limits(const Group& group) const;
    bool scans(const Group& group, const Piece& piece) const;
    std::size_t sharing(const Group& group, double crossings, bool slopes) const;
    template <class Visit>
    void for_each_way(const Group& group, std::span<const Piece> pieces, Visit&& visit) const;
    void add_kept_octaves(const Group& group, const Plan& plan, std::size_t count,
                          const KeptBatch& kept, StreamBuffers& buffers) const;
    void add_kept_lines(const Group& group, const SpanLines& lines, const KeptBatch& kept,
                        StreamBuffers& buffers, double* values) const;
    void add_kept_pieces(const Group& group, std::span<const Piece> pieces, const KeptBatch& kept,
                         StreamBuffers& buffers, double* values) const;
    void add_values(const Group& group, std::span<const Piece> pieces, StreamBuffers& buffers,
                    double* values) const;
    void add_scanned(const Group& group, std::span<const Piece> pieces, std::size_t count,
                     StreamBuffers& buffers, double* values) const;
    void add_streamed(const Group& group, std::span<const Piece> pieces, std::size_t count,
                      StreamBuffers& buffers, double* values, SlopeBatch* slopes,
                      const TexelOffsets* offsets) const;
    void add_limited(const Group& group, const Plan& plan, std::span<const Piece> pieces,
                     std::size_t count, StreamBuffers& buffers) const;
    Plan prepare(const Group& group, std::span<const Piece> pieces, std::size_t count,
                 StreamBuffers& buffers, bool slopes, const TexelOffsets* offsets) const;
    Plan prepare_lines(const Group& group, const SpanLines& lines, StreamBuffers& buffers) const;
    Plan plan_of(const Group& group, double planes, std::size_t count, StreamBuffers& buffers,
                 bool slopes) const;
    static void add_octave(const Group& group, const StreamOctave& octave, const Plan& plan,
                           std::size_t count, const StreamBuffers& buffers, OctaveSums& sums);

    std::vector<Group> groups_;
    Kernel kernel_;
    bool band_limit_;
    Skips skips_;
    bool wide_vectors_;
};

/// Calls visit(pieces, their number of texels, whether they are scanned) for pieces that follow one
/// another and are added up in the same way.
template <class Visit>
void OctaveStreams::for_each_way(const Group& group, std::span<const Piece> pieces,
                                 Visit&& visit) const {
    bool next = !pieces.empty() && scans(group, pieces.front());
    for (std::size_t begin = 0, end = 0; begin < pieces.size(); begin = end) {
        const bool scanned = next;
        std::size_t count = 0;
        do {
            count += pieces[end].solid.count;
            next = ++end < pieces.size() && scans(group, pieces[end]);
        } while (end < pieces.size() && next == scanned);
        visit(pieces.subspan(begin, end - begin), count, scanned);
    }
}

}  // namespace burl
