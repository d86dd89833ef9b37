#pragma once
// The exact filters on a batch of texels: those whose footprint holds a break of the map are picked
// out and sorted by the kernel that suits them, the others need no filter.
#include <cstdint>
#include <optional>
#include <vector>

#include "procedural/color/break_distance.h"
#include "procedural/color/map_filter.h"
#include "procedural/color/map_filter_kernels.h"
#include "procedural/kernels/slope_kernels.h"

namespace burl {

/// A thread's arrays.
struct FilterBuffers {
    alignas(64) std::int32_t entries[batch_capacity + batch_padding];
    std::uint32_t bent[batch_capacity + 2 * batch_padding];
    std::vector<std::uint16_t> texels[4];  ///< of the batch, per kernel
    FootprintStream stream;
};

class StreamFilter {
  public:
    /// `both_axes`: trapezoids; else boxes of the same variance.
    StreamFilter(const MapPieces& map, bool both_axes);

    /// Calls emit(texels, means) for groups of texels, means.color[c][i] in linear light being that
    /// of texel texels[i]; texels over which the map is straight are in none.
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
