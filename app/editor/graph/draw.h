#pragma once
// Where the wires of the graph's nodes end.
#include "app/editor/graph/model.h"

namespace burl {

/// The points of the plane at which a wire ends.
inline Vec2d input_point(const GraphModel& model, std::size_t node, std::size_t input) {
    const NodeBox& box = model.box(node);
    return model.place(node) + Vec2d(0.0, box.first_input + box.input_step * double(input));
}
inline Vec2d output_point(const GraphModel& model, std::size_t node) {
    return model.place(node) + Vec2d(model.box(node).width, model.box(node).output);
}

}  // namespace burl
