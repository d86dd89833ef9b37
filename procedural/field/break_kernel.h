#pragma once
// Selection of a batch's texels whose footprint may reach a break of the colour map, vectorised as
// in texel_batch.h: the others need no filter.
#include "procedural/kernels/slope_kernels.h"

namespace burl {

/// texels[0..result) = indices, in ascending order, of the texels j for which (|u| + |v|) / 2 <
/// distances[entries[j]] does not hold; a NaN slope is thus selected. The sum is rounded to
/// float32, so distances must be rounded down by 2^-23. Whole vectors are read: the padding of
/// `entries` must hold valid indices of the table, too. The same texels are selected on every
/// instruction set.
std::size_t find_bent(const float* distances, const std::int32_t* entries, const SlopeBatch& slopes,
                      std::size_t count, std::uint32_t* texels);

}  // namespace burl
