#pragma once
// The exact filters on a batch of texels: texels whose footprint holds a break of the colour map
// are selected and sorted by the kernel that suits them, the others need no filter.
#include <cstdint>
#include <optional>
#include <vector>

#include "procedural/color/map_filter.h"
#include "procedural/color/map_filter_kernels.h"
#include "procedural/color/map_pieces.h"
#include "procedural/kernels/slope_kernels.h"

namespace burl {

/// Scratch arrays of StreamFilter, one per thread.
struct FilterBuffers {
    /// Entry of every texel in the table of BreakDistance.
    alignas(64) std::int32_t entries[batch_capacity + batch_padding];
    /// Indices of the texels that find_bent selected.
    std::uint32_t bent[batch_capacity + 2 * batch_padding];
    std::vector<std::uint16_t> texels[4];  ///< indices of the batch's texels, sorted by kernel
    FootprintStream stream;
};

/// The exact filters of one colour map. Constant after construction: several threads may use one
/// object, each with its own buffers.
class StreamFilter {
  public:
    /// The filters are trapezoids if `both_axes`, else boxes of the trapezoids' variance.
    StreamFilter(const MapPieces& map, bool both_axes);

    /// Calls emit(texels, means) for groups of texels: means.color[c][i] is channel c of the mean
    /// colour, in linear light, of texel texels[i]. Texels over whose footprint the map is linear
    /// are in no group.
    template <class Emit>
    void operator()(const double* f, const SlopeBatch& slopes, std::size_t count,
                    FilterBuffers& buffers, const Emit& emit) const {
        sort(f, slopes, count, buffers);
        for (const Method method : {Method::narrow, Method::box, Method::trapezoid, Method::rare}) {
            const auto& texels = buffers.texels[int(method)];
            if (texels.empty()) continue;
            run(method, f, slopes, buffers);
            emit(texels, buffers.stream);
        }
    }

  private:
    /// The kernels: filter_narrow, filter_boxes, filter_trapezoids, and scalar code for rare
    /// widths.
    enum class Method { narrow, box, trapezoid, rare };
    FilterWidths widths(double f, float u, float v) const;
    static Method method_for(const FilterWidths& widths);
    void sort(const double* f, const SlopeBatch& slopes, std::size_t count,
              FilterBuffers& buffers) const;
    void pack(const std::vector<std::uint16_t>& texels, const double* f, const SlopeBatch& slopes,
              FootprintStream& stream) const;
    void run(Method method, const double* f, const SlopeBatch& slopes,
             FilterBuffers& buffers) const;

    MapPieces pieces_;
    MapBreaks breaks_;
    BreakDistance distance_;
    bool both_axes_;
};

}  // namespace burl
