#include "atlas/shape/curvature.h"

#include <algorithm>
#include <cmath>

#include "atlas/base/each_index.h"
#include "atlas/shape/disc_overlap.h"

namespace burl {

namespace {

/// Cosine of the angle from which on a triangle belongs to another sheet of the surface.
constexpr double other_sheet = -0.70710678118654752;

std::array<Vec3d, 3> corners_of(const ShapeScene& shape, std::uint32_t triangle) {
    const auto& [a, b, c] = shape.triangles()[triangle];
    return {shape.points()[a], shape.points()[b], shape.points()[c]};
}

/// Moments of the triangles `items`, of which those without area add nothing.
SurfaceMoments moments_of(const ShapeScene& shape, std::span<const std::uint32_t> items) {
    SurfaceMoments sum;
    Vec3d low(1.0), high(-1.0);
    for (const std::uint32_t t : items) {
        const double area = shape.areas()[t];
        if (area == 0.0) continue;
        const auto corners = corners_of(shape, t);
        sum.area += area;
        sum.moment += area / 3.0 * (corners[0] + corners[1] + corners[2]);
        sum.facing += area * shape.normals()[t];
        low = glm::min(low, shape.normals()[t]), high = glm::max(high, shape.normals()[t]);
    }
    sum.axis = 0.5 * (low + high);
    for (const std::uint32_t t : items)
        if (shape.areas()[t] > 0.0)
            sum.spread = std::max(sum.spread, glm::distance(sum.axis, shape.normals()[t]));
    return sum;
}

/// The surface within a ball: its area, its moment about the ball's centre, its mean normal times
/// its area.
class BallSurface {
  public:
    BallSurface(const CurvatureTree& tree, const ShapePoint& point, double radius)
        : tree_(tree),
          centre_(tree.shape().to_unit(point.position)),
          normal_(point.normal),
          radius_(radius) {
        if (!tree.tree().nodes.empty()) add_node(0);
    }

    /// Mean curvature times radius.
    double curvature() const {
        const double facing = glm::length(facing_);
        if (!(area_ > 0.0) || !(facing > 0.0)) return 0.0;
        return -4.0 * glm::dot(moment_ / area_, facing_ / facing) / radius_;
    }

  private:
    void add_node(std::uint32_t number) {
        const BoxNode& node = tree_.tree().nodes[number];
        if (square_distance(node.box, centre_) >= radius_ * radius_) return;
        const SurfaceMoments& sum = tree_.moments(number);
        const double cosine = glm::dot(sum.axis, normal_);
        if (cosine + sum.spread <= other_sheet) return;
        const bool within = farthest_square(node.box, centre_) <= radius_ * radius_;
        if (within && cosine - sum.spread > other_sheet)
            return add(sum.area, sum.moment - sum.area * centre_, sum.facing);
        if (node.second == 0) return add_leaf(node);
        add_node(number + 1);
        add_node(node.second);
    }

    void add_leaf(const BoxNode& node) {
        const ShapeScene& shape = tree_.shape();
        for (std::uint32_t i = node.begin; i < node.end; ++i) {
            const std::uint32_t t = tree_.tree().items[i];
            const Vec3d& normal = shape.normals()[t];
            if (shape.areas()[t] == 0.0 || glm::dot(normal, normal_) <= other_sheet) continue;
            std::array<Vec3d, 3> corners = corners_of(shape, t);
            if (square_distance(box_of(corners), centre_) >= radius_ * radius_) continue;
            for (Vec3d& corner : corners) corner -= centre_;
            const SurfacePiece piece = piece_in_ball(corners, normal, radius_);
            add(piece.area, piece.moment, piece.area * normal);
        }
    }

    void add(double area, const Vec3d& moment, const Vec3d& facing) {
        area_ += area, moment_ += moment, facing_ += facing;
    }

    const CurvatureTree& tree_;
    Vec3d centre_, normal_;
    double radius_;
    double area_ = 0.0;
    Vec3d moment_{0.0}, facing_{0.0};
};

}  // namespace

CurvatureTree::CurvatureTree(const ShapeScene& shape) : shape_(&shape) {
    std::vector<Box3> boxes(shape.triangles().size());
    for (std::uint32_t t = 0; t < boxes.size(); ++t) boxes[t] = box_of(corners_of(shape, t));
    tree_ = build_box_tree(boxes);
    moments_.resize(tree_.nodes.size());
    for (std::size_t i = 0; i < moments_.size(); ++i) {
        const BoxNode& node = tree_.nodes[i];
        moments_[i] =
            moments_of(shape, std::span(tree_.items).subspan(node.begin, node.end - node.begin));
    }
}

void curvature(const CurvatureTree& tree, std::span<const ShapePoint> points, double radius,
               std::span<float> values) {
    const double unit_radius = radius / tree.shape().diagonal();
    const auto work = [&](std::size_t i) {
        const bool asked = points[i].normal != Vec3d(0.0) && unit_radius > 0.0;
        const double k = asked ? BallSurface(tree, points[i], unit_radius).curvature() : 0.0;
        values[i] = float(std::clamp(k, -1.0, 1.0));
    };
    for_each_index(points.size(), work, points_at_a_time);
}

}  // namespace burl
