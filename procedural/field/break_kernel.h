#pragma once
// Which texels of a batch a filter has work with, vectorised as in texel_batch.h: those whose
// values of f may reach a break of the map.
#include "procedural/kernels/slope_kernels.h"

namespace burl {

/// texels[0..result) = the numbers of those where not (|u| + |v|) / 2 < distances[entry], in order:
/// NaN counts among them. The product is rounded to float, so distances must be rounded down by
/// 2^-23. Works on whole vectors: entries beyond the last texel's must lie in the table, too.
std::size_t find_bent(const float* distances, const std::int32_t* entries, const SlopeBatch& slopes,
                      std::size_t count, std::uint32_t* texels);

}  // namespace burl
