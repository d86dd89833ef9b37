// Counting sort: filling a row moves its entry of `begin` on to the row's end.
#include "app/surface/corners_by_point.h"

namespace burl {

CornersByPoint::CornersByPoint(const Mesh& mesh)
    : begin_(mesh.positions.size() + 2), corners_(3 * mesh.triangles.size()) {
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t p : t) ++begin_[p + 2];
    for (std::size_t p = 2; p < begin_.size(); ++p) begin_[p] += begin_[p - 1];
    std::uint32_t corner = 0;
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t p : t) corners_[begin_[p + 1]++] = corner++;
    begin_.pop_back();
}

}  // namespace burl
