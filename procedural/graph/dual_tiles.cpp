// The steps of cells and scattered shapes with gradients.
#include "procedural/graph/duals.h"

namespace burl {

DualFunction dual_function(const CellNumber& work, const DualSettings&) {
    return for_each_point([seed = work.seed](const DualCall& call, std::size_t i) {
        const auto axis = [&](std::size_t k) {
            return call.inputs[k] ? call.inputs[k]->value[i] : 0.0;
        };
        return Dual(cell_number({axis(0), axis(1), axis(2)}, seed));
    });
}

DualFunction dual_function(const CellFeature& work, const DualSettings&) {
    return for_each_point([work](const DualCall& call, std::size_t i) {
        const DualPoint p = call.point(i);
        const auto n = cell_feature({p.x.value, p.y.value, p.z.value}, work.points, work.gives);
        return Dual(n.value, n.gradient[0] * p.x.slope + n.gradient[1] * p.y.slope +
                                 n.gradient[2] * p.z.slope);
    });
}

DualFunction dual_function(const ScatteredShapes& work, const DualSettings&) {
    return for_each_point([work](const DualCall& call, std::size_t i) {
        const Dual x = call.in(0, i), y = call.in(1, i);
        const ShapeSample n = scattered_at(work, x.value, y.value);
        return Dual(n.value, n.gx * x.slope + n.gy * y.slope);
    });
}

}  // namespace burl
