// The irregular textures as sums of octaves and arithmetic; noise.cpp has the same nodes with
// gradients. There is no footprint, so no octave fades.
#include <cmath>

#include "procedural/color/marble_spline.h"
#include "procedural/field/lattice_sums.h"
#include "procedural/graph/lowering.h"
#include "procedural/graph/node_noise.h"

namespace burl {

namespace {

/// The sum sum_k gain^k shape(n_{seed+k}(scale lacunarity^k p)).
NoiseSum octave_sum(const LoweringCall& call, OctaveShape shape, double octaves, double scale) {
    NoiseSum sum{noise_of(call), shape, {}, 0.0};
    std::uint32_t seed = sum.noise.seed;
    double weight = 1.0, frequency = 1.0;
    for (double k = 0.0; k < octaves && weight != 0.0; ++k, ++seed) {
        sum.octaves.push_back({seed, scale * frequency, weight});
        weight *= call.parameter("gain");
        frequency *= call.parameter("lacunarity");
    }
    sum.noise.seed = 0;
    return sum;
}

Register sum_at(const LoweringCall& call, NoiseSum sum, const std::vector<Register>& point) {
    return call.program->add(std::move(sum), point).front();
}

Register octaves_at_point(const LoweringCall& call, OctaveShape shape) {
    return sum_at(call, octave_sum(call, shape, call.parameter("octaves"), 1.0), call.point());
}

LoweredNode fbm(const LoweringCall& call) {
    return call.number(octaves_at_point(call, OctaveShape::plain));
}

LoweredNode wrinkled(const LoweringCall& call) {
    return call.number(octaves_at_point(call, OctaveShape::absolute));
}

LoweredNode windy(const LoweringCall& call) {
    const Register wind =
        sum_at(call, octave_sum(call, OctaveShape::plain, 3.0, 0.1), call.point());
    return call.number(call.multiply(call.program->add(ValueOp::absolute, {wind}),
                                     octaves_at_point(call, OctaveShape::plain)));
}

/// Weights of four neighbouring control points, one row each, as coefficients of powers of u in [0,
/// 1]: Bernstein's, and six times those of the uniform cubic B-spline.
constexpr double bezier[4][4] = {{1, -3, 3, -1}, {0, 3, -6, 3}, {0, 0, 3, -3}, {0, 0, 0, 1}};
constexpr double bspline[4][4] = {{1, -3, 3, -1}, {4, 0, -6, 3}, {1, 3, 3, -3}, {0, 0, 0, 1}};

/// The marble spline as polynomials of t in [0, 1].
ColorPieces marble_spline(bool smooth) {
    ColorPieces pieces;
    pieces.degree = 3;
    constexpr double segments = double(marble_segments);
    for (std::size_t i = 0; i < marble_segments; ++i) {
        pieces.begins.push_back(double(i) / segments);
        pieces.table.push_back(pieces.begins.back());
        for (std::size_t c = 0; c < 3; ++c) {
            double power = marble_brightness;
            for (std::size_t degree = 0; degree < 4; ++degree, power *= segments) {
                double sum = 0.0;
                for (std::size_t k = 0; k < 4; ++k)
                    sum += (smooth ? bspline[k][degree] / 6.0 : bezier[k][degree]) *
                           marble_colors[i + k][c];
                pieces.table.push_back(power * sum);
            }
        }
    }
    return pieces;
}

LoweredNode marble(const LoweringCall& call) {
    ValueProgram& program = *call.program;
    const double scale = call.parameter("scale");
    const Register noise = sum_at(
        call, octave_sum(call, OctaveShape::plain, call.parameter("octaves"), scale), call.point());
    const Register vein = program.add(ValueOp::combine, {call.axis(1), noise},
                                      {scale, call.parameter("variation"), 0.0});
    const Register t = call.linear(0.5, program.add(ValueOp::sine, {vein}), 0.5);
    LoweredNode result{program.add(marble_spline(call.parameter("spline") == 1.0), {t}, 3), {}};
    result.channels.push_back(program.constant(1.0));
    return result;
}

LoweredNode bumps(const LoweringCall& call) {
    NoiseSum sum{noise_of(call), OctaveShape::plain, {}, 0.0};
    sum.octaves = {{sum.noise.seed, 1.0, 1.0}};
    sum.noise.seed = 0;
    const double threshold = call.parameter("threshold");
    const Vec3d frequency = call.vector("frequency");
    std::vector<Register> point;
    for (int i = 0; i < 3; ++i) {
        Vec3d d(0.0);
        d[i] = frequency[i];
        point.push_back(call.along(d));
    }
    const bool distance = is_distance(sum.noise.kind);
    const Register n = sum_at(call, std::move(sum), point);
    const Register above =
        distance ? call.linear(1.0, n, -threshold) : call.linear(0.5, n, 0.5 - threshold);
    return call.blend(call.program->add(ValueOp::at_least, {above}, {0.0}));
}

LoweredNode dots(const LoweringCall& call) {
    const auto whole = [&](const char* key) { return std::uint32_t(call.parameter(key)); };
    const DotsWeight weight{whole("seed"), whole("period_u"), whole("period_v"),
                            call.parameter("radius")};
    return call.blend(call.program->add(weight, {call.axis(0), call.axis(1)}).front());
}

LoweredNode warp(const LoweringCall& call) {
    const NoiseSum sum = octave_sum(call, OctaveShape::plain, call.parameter("octaves"), 1.0);
    LoweredNode result;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        NoiseSum move = sum;
        for (SumOctave& octave : move.octaves) octave.seed += std::uint32_t(axis) << 16;
        result.place.base[axis] = call.program->add(
            ValueOp::combine, {call.axis(int(axis)), sum_at(call, std::move(move), call.point())},
            {1.0, call.parameter("strength"), 0.0});
    }
    return result;
}

/// The quadric at the place plus `constant`; without a quadratic part it is one affine operation.
Register quadric_at(const LoweringCall& call, const Quadric& q, double constant) {
    const Register ends = call.along(2.0 * Vec3d(q.d, q.g, q.i), q.j + constant);
    if (q.a == 0 && q.b == 0 && q.c == 0 && q.e == 0 && q.f == 0 && q.h == 0) return ends;
    ValueProgram& program = *call.program;
    const Register hx = call.along({q.a, q.b, q.c}), hy = call.along({q.b, q.e, q.f}),
                   hz = call.along({q.c, q.f, q.h});
    const Register xy = program.add(ValueOp::products, {call.axis(0), hx, call.axis(1), hy});
    const Register z =
        program.add(ValueOp::products, {call.axis(2), hz, program.constant(1.0), ends});
    return call.add(xy, z);
}

LoweredNode field(const LoweringCall& call) {
    const Texture& texture = call.graph->textures[call.node->texture];
    const std::vector<Octave> octaves = expand_octaves(texture);
    double constant = 0.0;
    for (const Octave& octave : octaves) constant += octave.offset;
    Register total = quadric_at(call, texture.quadric, constant);
    for (LatticeSum& part : lattice_sums(octaves)) {
        LoweringCall inner = call;
        inner.place.map = part.lattice.after(call.place.map);
        total = call.add(total, sum_at(call, std::move(part.sum), inner.point()));
    }
    return call.number(total);
}

constexpr std::array noise_table{NamedLowering{"field", field},       NamedLowering{"fbm", fbm},
                                 NamedLowering{"wrinkled", wrinkled}, NamedLowering{"windy", windy},
                                 NamedLowering{"marble", marble},     NamedLowering{"bumps", bumps},
                                 NamedLowering{"dots", dots},         NamedLowering{"warp", warp}};

}  // namespace

std::span<const NamedLowering> noise_lowerings() {
    return noise_table;
}

}  // namespace burl
