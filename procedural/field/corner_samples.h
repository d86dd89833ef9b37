#pragma once
// The field at the corners of texels, whose differences give the second-order term that Hart et al.
// 1999's linear model of f leaves out. Neighbours in a row share corners, so a row of texels costs
// two rows of values.
#include <memory>
#include <vector>

#include "procedural/field/sampler.h"

namespace burl {

/// Scratch arrays of average_with_corners, one per thread.
struct CornerBuffers {
    std::unique_ptr<FieldBatch> batch = std::make_unique<FieldBatch>();
    /// Values at the corners above and below the texels: count + 1 for a piece of `count` texels.
    std::vector<double> upper, lower;
};

/// Replaces the values in batch.field, sampled at the texels' centres, by means over the texels, f
/// + (f_uu + f_vv) / 24, and fills batch.slopes with df/du and df/dv per texel. Both come from
/// differences of the values at the corners and are exact, but for rounding, for a quadratic f.
void average_with_corners(const FieldSampler& sampler, FieldBatch& batch, CornerBuffers& buffers);

}  // namespace burl
