#include "procedural/graph/duals.h"

#include "procedural/graph/box_means.h"

namespace burl {

namespace {

Dual times(double p, const Dual& x) {
    return {p * x.value, p * x.slope};
}

/// The function of a step that gives `function` of its input.
template <class Function>
DualFunction of_one(const Function& function) {
    return for_each_point(
        [function](const DualCall& call, std::size_t i) { return Dual(function(call.in(0, i))); });
}

/// The function of a step that gives `function` of its two inputs.
template <class Function>
DualFunction of_two(const Function& function) {
    return for_each_point([function](const DualCall& call, std::size_t i) {
        return Dual(function(call.in(0, i), call.in(1, i)));
    });
}

template <auto function>
DualFunction unary() {
    return of_one([](const Dual& a) { return function(a); });
}

template <auto function>
DualFunction binary() {
    return of_two([](const Dual& a, const Dual& b) { return function(a, b); });
}

/// The function of a step that gives p a + q b + r c + s, without the terms of weight 0 where two
/// or three are.
DualFunction affine(double p, double q, double r, double s) {
    const std::array weights{p, q, r};
    const auto idle = std::ranges::count(weights, 0.0);
    if (idle == 3) return for_each_point([s](const DualCall&, std::size_t) { return Dual(s); });
    if (idle < 2)
        return for_each_point([=](const DualCall& call, std::size_t i) {
            return times(p, call.in(0, i)) + times(q, call.in(1, i)) + times(r, call.in(2, i)) + s;
        });
    const std::size_t k = p != 0.0 ? 0 : q != 0.0 ? 1 : 2;
    return for_each_point([=, weight = weights[k]](const DualCall& call, std::size_t i) {
        return times(weight, call.in(k, i)) + s;
    });
}

/// The ratio a / b, or 0 where b is not above 0.
Dual ratio(const Dual& a, const Dual& b) {
    if (!(b.value > 0.0)) return 0.0;
    return a * chain(b, 1.0 / b.value, -1.0 / (b.value * b.value));
}

/// The function of a step that gives `mean` of its input over the footprint's box.
template <auto mean>
DualFunction over_box() {
    return for_each_point([](const DualCall& call, std::size_t i) {
        const Dual x = call.in(0, i);
        return mean(x, call.box_width(x, i));
    });
}

}  // namespace

DualFunction dual_function(const ValueOperation& work, const DualSettings&) {
    const double p = work.parameters[0], q = work.parameters[1], r = work.parameters[2],
                 s = work.parameters[3];
    switch (work.op) {
        case ValueOp::constant:
            return affine(0.0, 0.0, 0.0, p);
        case ValueOp::affine:
            return affine(p, q, r, s);
        case ValueOp::linear:
            return of_one([=](const Dual& a) { return times(p, a) + q; });
        case ValueOp::combine:
            return of_two([=](const Dual& a, const Dual& b) { return times(p, a) + times(q, b); });
        case ValueOp::add:
            return of_two([](const Dual& a, const Dual& b) { return a + b; });
        case ValueOp::multiply:
            return of_two([](const Dual& a, const Dual& b) { return a * b; });
        case ValueOp::products:
            return for_each_point([](const DualCall& call, std::size_t i) {
                return call.in(0, i) * call.in(1, i) + call.in(2, i) * call.in(3, i);
            });
        case ValueOp::ratio:
            return binary<ratio>();
        case ValueOp::minimum:
            return binary<dual_min>();
        case ValueOp::maximum:
            return binary<dual_max>();
        case ValueOp::absolute:
            return unary<dual_abs>();
        case ValueOp::floor:
            return unary<dual_floor>();
        case ValueOp::fract:
            return unary<dual_fract>();
        case ValueOp::odd:
            return of_one([](const Dual& a) { return odd_cell(a.value); });
        case ValueOp::at_least:
            return of_one([=](const Dual& a) { return a.value >= p ? 1.0 : 0.0; });
        case ValueOp::smoothstep:
            return of_one([=](const Dual& a) { return dual_smoothstep(p, q, a); });
        case ValueOp::lerp:
            return for_each_point([](const DualCall& call, std::size_t i) {
                return dual_lerp(call.in(0, i), call.in(1, i), call.in(2, i));
            });
        case ValueOp::length:
            return binary<dual_length>();
        case ValueOp::power:
            return of_one([=](const Dual& a) { return dual_power(a, p); });
        case ValueOp::sine:
            return unary<dual_sin>();
        case ValueOp::angle:
            return binary<dual_angle>();
    }
    return {};
}

DualFunction dual_function(const BoxMean& work, const DualSettings&) {
    if (work.function == ValueOp::odd) return over_box<box_odd>();
    if (work.function == ValueOp::fract) return over_box<box_fract>();
    return over_box<box_sin>();
}

DualFunction dual_function(const BoxStep& work, const DualSettings&) {
    return for_each_point([=](const DualCall& call, std::size_t i) {
        const Dual above = times(work.factor, call.in(0, i)) + work.offset - work.threshold;
        return box_step(above, call.box_width(above, i), work.mean, work.widest);
    });
}

DualFunction dual_function(const BoxPulse& work, const DualSettings&) {
    return for_each_point([=](const DualCall& call, std::size_t i) {
        const Dual x = call.in(0, i);
        return box_pulse(x, call.box_width(x, i), work.threshold);
    });
}

DualFunction dual_function(const PositiveTurn&, const DualSettings&) {
    return of_one([](const Dual& turn) { return turn.value < 0.0 ? turn + 1.0 : turn; });
}

DualFunction dual_function(const MaskRead& work, const DualSettings&) {
    return for_each_point(
        [=](const DualCall& call, std::size_t i) { return call.mask(work.mask, i); });
}

DualFunction dual_function(const PointFunction& work, const DualSettings&) {
    return [work](const DualCall& call) {
        const std::size_t count = std::ranges::find(call.inputs, nullptr) - call.inputs.begin();
        std::array<Dual, most_step_inputs> in;
        for (std::size_t i = 0; i < call.count(); ++i) {
            for (std::size_t k = 0; k < count; ++k) in[k] = call.in(k, i);
            const auto out = point_value<Dual>(work, {in.data(), count});
            for (std::size_t c = 0; c < 3 && call.outputs[c]; ++c) call.outputs[c]->set(i, out[c]);
        }
    };
}

DualFunction dual_function(const SlopeAlong& work, const DualSettings&) {
    return of_one([d = work.direction](const Dual& x) { return glm::dot(d, x.slope); });
}

}  // namespace burl
