#include "procedural/materialx/call.h"

#include "procedural/materialx/noise.h"
#include "procedural/materialx/vectors.h"

namespace burl {

namespace materialx {

namespace {

template <std::size_t N, class T>
std::array<T, N> noises_of(const MaterialXCall& call, const Numbers<T>& in) {
    const int axes = call.dimensions;
    switch (call.function) {
        case MaterialXFunction::noise:
            return noises<N>(axes, in.triple(0));
        case MaterialXFunction::fractal:
            return fractals<N>(axes, in.triple(0), Octaves<T>{in[3], in[4], in[5]});
        case MaterialXFunction::cell_noise:
            return cell_noises<N, T>(axes, values_of(in.triple(0)));
        default:
            return worley<N>(axes, in.triple(0), in[3], WorleyStyle(call.choice));
    }
}

template <class T>
std::array<T, 3> results_of(const MaterialXCall& call, const Numbers<T>& in) {
    if (call.function == MaterialXFunction::math)
        return {math(MathOp(call.choice), in[0], in[1], in[2])};
    if (call.function == MaterialXFunction::vector_math) {
        const Triple<T> v =
            vector_math(VectorOp(call.choice), in.triple(0), in.triple(3), in.triple(6));
        return {v.x, v.y, v.z};
    }
    if (call.results == 1) return {noises_of<1>(call, in).front()};
    return noises_of<3>(call, in);
}

}  // namespace

}  // namespace materialx

template <class T>
std::array<T, 3> materialx_value(const MaterialXCall& call, std::span<const T> inputs) {
    return materialx::results_of(call, numeric::Numbers<T>{inputs});
}

template std::array<double, 3> materialx_value(const MaterialXCall&, std::span<const double>);
template std::array<Dual, 3> materialx_value(const MaterialXCall&, std::span<const Dual>);

}  // namespace burl
