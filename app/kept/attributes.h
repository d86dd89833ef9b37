#pragma once
// Attributes of a carved primitive's vertices: the file's bytes where a vertex is the file's, the
// mean where it lies half-way between two.
#include <span>
#include <string>
#include <vector>

#include "app/kept/document.h"
#include "app/kept/vertices.h"

namespace burl {

/// Elements for all vertices. A vertex of the file has its bytes; a middle has the mean of its two
/// ends, of unit length for `NORMAL` and `TANGENT` (whose w is that of the first end), rounded to
/// the file's encoding.
Elements extended(const std::string& name, const Elements& source,
                  std::span<const KeptVertex> vertices);

/// Joints and weights of all sets of a primitive.
struct SkinSets {
    std::vector<Elements> joints, weights;
    /// Largest share of a middle's weights that its file's sets have no room for, 0 to 1.
    double left_out = 0.0;
};

/// The sets for all vertices. A middle follows the joints of both ends by half their weights; where
/// these are more than four a set, the largest are kept and brought to the sum 1.
SkinSets extended(const SkinSets& source, std::span<const KeptVertex> vertices);

}  // namespace burl
