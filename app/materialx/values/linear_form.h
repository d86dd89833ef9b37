#pragma once
// Nodes that are linear maps of the texture coordinates or of the point: where images are looked
// up, since a recipe moves an image by a matrix.
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "app/materialx/values/builder.h"

namespace burl::materialx {

/// A sum of weights times u, v (upwards), x, y and z, plus an offset.
struct LinearForm {
    std::array<double, 5> weights{};
    double offset = 0.0;

    bool uses_texture_coordinates() const { return weights[0] != 0.0 || weights[1] != 0.0; }
    bool uses_point() const { return weights[2] != 0.0 || weights[3] != 0.0 || weights[4] != 0.0; }
    bool is_constant() const { return !uses_texture_coordinates() && !uses_point(); }
};

/// Finds the linear forms of nodes.
class LinearForms {
  public:
    explicit LinearForms(const NodeBuilder& nodes) : nodes_(nodes) {}

    /// The form of a channel of a colour, or of a number; none where the node is no linear map.
    std::optional<LinearForm> of(NodeRef ref, std::size_t channel);

  private:
    std::optional<LinearForm> found(NodeRef ref, std::size_t channel);
    std::optional<LinearForm> of_operation(const std::string& operation, const BuiltNode& node,
                                           std::size_t channel);

    const NodeBuilder& nodes_;
    std::map<std::pair<NodeRef, std::size_t>, std::optional<LinearForm>> known_;
};

}  // namespace burl::materialx
