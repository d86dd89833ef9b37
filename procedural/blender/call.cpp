#include "procedural/blender/call.h"

#include "procedural/blender/color.h"
#include "procedural/blender/patterns.h"
#include "procedural/blender/voronoi.h"

namespace burl {

namespace {

using namespace blender;

/// A call with its numbers.
template <class T>
struct CallInputs : Numbers<T> {
    const BlenderCall& call;

    int setting(std::size_t i) const { return int(call.settings[i]); }
};

template <class T>
using Results = std::array<T, 3>;

template <class T>
Results<T> results(const Triple<T>& a) {
    return {a.x, a.y, a.z};
}

template <class T>
Results<T> musgrave_of(const CallInputs<T>& in) {
    const MusgraveSum<T> sum{in[3], in[4], in[5], in[6], in[7]};
    return {musgrave(MusgraveKind(in.setting(0)), in.triple(0), sum)};
}

template <class T>
Results<T> voronoi_of(const CallInputs<T>& in) {
    const VoronoiShape<T> shape{VoronoiFeature(in.setting(0)), VoronoiMetric(in.setting(1)), in[3],
                                in[4], in[5]};
    const VoronoiSample<T> sample = voronoi(in.triple(0), shape);
    if (in.setting(2) == 0) return {sample.distance};
    return results(in.setting(2) == 1 ? sample.color : sample.position);
}

template <class T>
Results<T> wave_of(const CallInputs<T>& in) {
    const WaveShape<T> shape{
        in.setting(0) == 1, in.setting(1), in.setting(2), in[3], in[4], in[5], in[6], in[7]};
    return {wave(in.triple(0), shape)};
}

template <class T>
Results<T> brick_of(const CallInputs<T>& in) {
    const BrickShape<T> shape{
        in[3],         in[4],        in[5], in[6], in[7], in.call.settings[0], in.call.settings[2],
        in.setting(1), in.setting(3)};
    const std::array<T, 2> shares = brick(in.triple(0), shape);
    return {shares[0], shares[1]};
}

template <class T>
Results<T> each_channel(const CallInputs<T>& in, T (*function)(const T&, const T&, const T&)) {
    return {function(in[0], in[3], in[4]), function(in[1], in[3], in[4]),
            function(in[2], in[3], in[4])};
}

template <class T>
Results<T> texture_of(const CallInputs<T>& in) {
    switch (in.call.function) {
        case BlenderFunction::noise:
            return results(noise_texture(in.triple(0), in[3], in[4], in[5], in.setting(0) == 1));
        case BlenderFunction::musgrave:
            return musgrave_of(in);
        case BlenderFunction::voronoi:
            return voronoi_of(in);
        case BlenderFunction::wave:
            return wave_of(in);
        case BlenderFunction::magic:
            return results(magic(in.triple(0), in.setting(0), in[3]));
        case BlenderFunction::gradient:
            return {gradient(GradientKind(in.setting(0)), in.triple(0))};
        case BlenderFunction::brick:
            return brick_of(in);
        case BlenderFunction::checker:
            return {checker(in.triple(0))};
        default:
            return results(constants<T>(random_triple(values_of(in.triple(0)))));
    }
}

template <class T>
Results<T> arithmetic_of(const CallInputs<T>& in) {
    switch (in.call.function) {
        case BlenderFunction::math:
            return {math(MathOp(in.setting(0)), in[0], in[1], in[2])};
        case BlenderFunction::vector_math:
            return results(vector_math(VectorOp(in.setting(0)), in.triple(0), in.triple(3),
                                       in.triple(6), in[9]));
        case BlenderFunction::map_range:
            return {mapped(RangeCurve(in.setting(0)), in[0],
                           Range<T>{in[1], in[2], in[3], in[4], in[5]})};
        case BlenderFunction::mix:
            return results(mixed(BlendMode(in.setting(0)), in[0], in.triple(1), in.triple(4)));
        case BlenderFunction::correct_hsv:
            return results(corrected_hsv(in.triple(0), in[3], in[4], in[5], in[6]));
        case BlenderFunction::to_hsv:
            return results(hsv_of(in.triple(0)));
        case BlenderFunction::from_hsv:
            return results(from_hsv(in.triple(0)));
        case BlenderFunction::contrast:
            return each_channel<T>(in, [](const T& c, const T& bright, const T& contrast) {
                return brightened(c, bright, contrast);
            });
        default:
            return each_channel<T>(
                in, [](const T& c, const T& gamma, const T&) { return gamma_of(c, gamma); });
    }
}

}  // namespace

template <class T>
std::array<T, 3> blender_value(const BlenderCall& call, std::span<const T> inputs) {
    const CallInputs<T> in{{inputs}, call};
    return call.function < BlenderFunction::math ? texture_of(in) : arithmetic_of(in);
}

template std::array<double, 3> blender_value(const BlenderCall&, std::span<const double>);
template std::array<Dual, 3> blender_value(const BlenderCall&, std::span<const Dual>);

}  // namespace burl
