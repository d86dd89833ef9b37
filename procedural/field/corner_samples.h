#pragma once
// The field at the corners of texels, which tells by how much it bends over each: the second order
// of Hart et al. 1999's linear model of f. Neighbours share corners, so that they cost two rows of
// values.
#include <memory>
#include <vector>

#include "procedural/field/sampler.h"

namespace burl {

/// A thread's arrays.
struct CornerBuffers {
    std::unique_ptr<FieldBatch> batch = std::make_unique<FieldBatch>();
    std::vector<double> upper, lower;  ///< of every piece one more than it has texels
};

/// Replaces the values in batch.field, those at the texels' centres, by means over the texels, f +
/// (f_uu + f_vv) / 24, and fills batch.slopes, all from differences of the values at the corners:
/// exact for a quadratic f.
void average_with_corners(const FieldSampler& sampler, FieldBatch& batch, CornerBuffers& buffers);

}  // namespace burl
