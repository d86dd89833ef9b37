#include "procedural/graph/values.h"

#include "procedural/color/marble_spline.h"
#include "procedural/color/table.h"
#include "procedural/field/lattice_sums.h"
#include "procedural/graph/program.h"

namespace burl {

namespace {

// The weights of four neighbouring control points, by powers of u in [0, 1]: Bernstein's, and those
// of the uniform cubic B-spline.
constexpr double bezier[4][4] = {{1, -3, 3, -1}, {0, 3, -6, 3}, {0, 0, 3, -3}, {0, 0, 0, 1}};
constexpr double bspline[4][4] = {{1, -3, 3, -1}, {4, 0, -6, 3}, {1, 3, 3, -3}, {0, 0, 0, 1}};

ColorPieces pieces_of(const MarbleColors& marble) {
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
                    sum += (marble.smooth ? bspline[k][degree] / 6.0 : bezier[k][degree]) *
                           marble_colors[i + k][c];
                pieces.table.push_back(power * sum);
            }
        }
    }
    return pieces;
}

ColorPieces pieces_of(const MapColors& colors) {
    const PreparedColorMap map(colors.map());
    ColorPieces pieces;
    if (map.wrap() == Wrap::repeat) pieces.argument = ColorPieces::Argument::repeat;
    for (std::size_t i = 0; i < map.segments(); ++i) {
        const double begin = map.begin(i);
        const Vec3d color = map.color(i, begin), next = map.color(i, begin + 1.0);
        pieces.begins.push_back(begin);
        pieces.table.push_back(begin);
        for (int c = 0; c < 3; ++c)
            pieces.table.insert(pieces.table.end(), {color[c], next[c] - color[c]});
    }
    return pieces;
}

/// A value of the graph in the value program: an array, or, for the coordinates of a point that a
/// node makes, an affine combination of three arrays. A combination becomes an array where it is
/// read, so that affine maps of affine maps are multiplied out.
struct LoweredValue {
    bool affine = false;
    Register array = 0;
    std::array<Register, 3> base{};
    Vec3d weights{0.0};
    double offset = 0.0;
};

/// The lowering of a graph's steps to those of a value program. There is no footprint: means over
/// it are the functions themselves, and no octave fades.
class Lowering {
  public:
    Lowering(const TextureGraph& graph, ValueProgram& program) : graph_(graph), program_(program) {
        for (Register axis = 0; axis < 3; ++axis) values_.push_back({false, axis});
    }

    /// The arrays of the base colour's channels, or of all planes.
    std::vector<Register> operator()(GraphOutput output) {
        GraphProgram program = program_of(graph_);
        if (output == GraphOutput::planes) program.results = plane_registers(program);
        for (const GraphStep& step : program.steps) {
            program_.begin_node(step.node);
            inputs_ = step.inputs;
            node_ = step.node;
            outputs_ = step.outputs.size();
            std::visit([&](const auto& work) { lower(work); }, step.work);
        }
        std::vector<Register> results;
        for (const Register r : program.results) results.push_back(array(r));
        return results;
    }

  private:
    /// The array of a value of the graph.
    Register array(Register value) {
        const LoweredValue& x = values_[value];
        return x.affine ? sum(x.base, x.weights, x.offset) : x.array;
    }
    Register in(std::size_t k) { return array(inputs_[k]); }
    std::vector<Register> arrays() {
        std::vector<Register> all;
        for (const Register value : inputs_) all.push_back(array(value));
        return all;
    }

    /// The array of weights . base + offset, without the terms of weight 0.
    Register sum(const std::array<Register, 3>& base, const Vec3d& weights, double offset) {
        std::vector<Register> used;
        std::vector<double> factors;
        for (int i = 0; i < 3; ++i) {
            if (weights[i] == 0.0) continue;
            used.push_back(base[std::size_t(i)]);
            factors.push_back(weights[i]);
        }
        if (used.empty()) return program_.constant(offset);
        if (used.size() == 1) return linear(factors[0], used[0], offset);
        if (used.size() == 2)
            return program_.add(ValueOp::combine, used, {factors[0], factors[1], offset});
        return program_.add(ValueOp::affine, used, {weights.x, weights.y, weights.z, offset});
    }

    /// The value d . p + offset; the coordinates of p are the step's inputs.
    LoweredValue along(const Vec3d& d, double offset) {
        const LoweredValue &x = values_[inputs_[0]], &y = values_[inputs_[1]],
                           &z = values_[inputs_[2]];
        const bool composes =
            x.affine && y.affine && z.affine && x.base == y.base && x.base == z.base;
        if (!composes) return {true, 0, {in(0), in(1), in(2)}, d, offset};
        const Mat3d map = glm::transpose(Mat3d(x.weights, y.weights, z.weights));
        return {true, 0, x.base, d * map, glm::dot(d, {x.offset, y.offset, z.offset}) + offset};
    }
    Register array_along(const Vec3d& d, double offset = 0.0) {
        const LoweredValue x = along(d, offset);
        return sum(x.base, x.weights, x.offset);
    }

    // Constant folding.

    /// The array of p a + q.
    Register linear(double p, Register a, double q = 0.0) {
        if (p == 1.0 && q == 0.0) return a;
        return program_.add(ValueOp::linear, {a}, {p, q});
    }
    Register add(Register a, Register b) {
        if (const double* x = program_.constant_of(a)) return linear(1.0, b, *x);
        if (const double* x = program_.constant_of(b)) return linear(1.0, a, *x);
        return program_.add(ValueOp::add, {a, b});
    }
    Register multiply(Register a, Register b) {
        if (const double* x = program_.constant_of(a)) return linear(*x, b);
        if (const double* x = program_.constant_of(b)) return linear(*x, a);
        return program_.add(ValueOp::multiply, {a, b});
    }
    Register lerp(Register w, Register a, Register b) {
        if (program_.same(a, b)) return a;
        const double *low = program_.constant_of(a), *high = program_.constant_of(b);
        if (low && high) return linear(*high - *low, w, *low);
        return program_.add(ValueOp::lerp, {w, a, b});
    }

    void give(Register r) { values_.push_back({false, r}); }
    /// Gives the results of `work` on the step's inputs.
    void give(ValueWork work, std::size_t count = 1) {
        for (const Register r : program_.add(std::move(work), arrays(), count)) give(r);
    }

    void give_sum(const Vec3d& d, double offset) {
        if (graph_.nodes[node_].wire == Wire::point)
            values_.push_back(along(d, offset));
        else
            give(array_along(d, offset));
    }

    void lower(const ValueOperation& work) {
        const auto [p, q, r, s] = work.parameters;
        switch (work.op) {
            case ValueOp::affine:
                return give_sum({p, q, r}, s);
            case ValueOp::linear:
                return give(linear(p, in(0), q));
            case ValueOp::add:
                return give(add(in(0), in(1)));
            case ValueOp::multiply:
                return give(multiply(in(0), in(1)));
            case ValueOp::lerp:
                return give(lerp(in(0), in(1), in(2)));
            default:
                return give(work);
        }
    }

    void lower(const BoxMean& mean) { give(ValueOperation{mean.function, {}}); }

    void lower(const BoxPulse& pulse) {
        const Register part = program_.add(ValueOp::fract, {in(0)});
        give(program_.add(ValueOp::at_least, {part}, {pulse.threshold}));
    }

    void lower(const BoxStep& step) {
        const Register above = linear(step.factor, in(0), step.offset - step.threshold);
        give(program_.add(ValueOp::at_least, {above}, {0.0}));
    }

    void lower(const PositiveTurn&) {
        const Register turn = in(0), positive = program_.add(ValueOp::at_least, {turn}, {0.0});
        give(program_.add(ValueOp::combine, {turn, positive}, {1.0, -1.0, 1.0}));
    }

    /// The input's derivative is left to an evaluator: it is the only gradient that values need.
    void lower(const SlopeAlong& slope) {
        TextureGraph input = graph_;
        input.result = graph_.nodes[node_].inputs[0];
        input.nodes.resize(input.result + 1);
        input.channels.clear();
        const auto graph =
            std::make_shared<GraphEvaluator>(input, Filter{}, PrecisionKind::float32);
        give(program_.add(GraphSlope{graph, slope.direction}, {0, 1, 2}).front());
    }

    /// The share of odd cells is 1/2 - 1/2 prod (1 - 2 odd).
    void lower(const Checkerboard& board) {
        Register sign = program_.constant(1.0);
        for (std::size_t i = 0; i < board.axes; ++i) {
            const Register odd = program_.add(ValueOp::odd, {in(i)});
            sign = multiply(sign, linear(-2.0, odd, 1.0));
        }
        give(linear(-0.5, sign, 0.5));
    }

    void lower(const OctaveSum& octaves) { give(octaves.sum(octaves.scale)); }

    void lower(const SimplexOctaves& octaves) { give(octaves); }
    void lower(const CurlOctaves& octaves) { give(octaves, 3); }

    /// The array of the quadric plus a constant: the quadratic part by Horner's rule, if there is
    /// one.
    Register quadric(const Quadric& q, double constant) {
        const Register ends = array_along(2.0 * Vec3d(q.d, q.g, q.i), q.j + constant);
        if (q.a == 0 && q.b == 0 && q.c == 0 && q.e == 0 && q.f == 0 && q.h == 0) return ends;
        const Register hx = array_along({q.a, q.b, q.c}), hy = array_along({q.b, q.e, q.f}),
                       hz = array_along({q.c, q.f, q.h});
        const Register xy = program_.add(ValueOp::products, {in(0), hx, in(1), hy});
        const Register z =
            program_.add(ValueOp::products, {in(2), hz, program_.constant(1.0), ends});
        return add(xy, z);
    }

    void lower(const FieldAt& field) {
        const std::vector<Octave> octaves = expand_octaves(*field.texture);
        double constant = 0.0;
        for (const Octave& octave : octaves) constant += octave.offset;
        Register total = quadric(field.texture->quadric, constant);
        for (LatticeSum& part : lattice_sums(octaves)) {
            const Mat3d rows = glm::transpose(part.lattice.linear);
            std::vector<Register> point;
            for (int i = 0; i < 3; ++i)
                point.push_back(array_along(rows[i], part.lattice.offset[i]));
            total = add(total, program_.add(std::move(part.sum), point).front());
        }
        give(total);
    }

    void lower(const MapColors& colors) { give(pieces_of(colors), 3); }
    void lower(const MarbleColors& colors) { give(pieces_of(colors), 3); }
    void lower(const DotsWeight& dots) { give(dots); }
    void lower(const CellNumber& number) { give(number); }
    void lower(const CellFeature& feature) { give(feature); }
    void lower(const ScatteredShapes& shapes) { give(shapes); }
    void lower(const ImageColors& image) {
        give(ImageLookup{image.pixels, image.pixels->wrap()}, 3);
    }

    void lower(const MaskRead& read) { give(read); }
    void lower(const PointFunction& function) { give(function, outputs_); }

    const TextureGraph& graph_;
    ValueProgram& program_;
    std::vector<LoweredValue> values_;  ///< values of the graph, by register
    std::vector<Register> inputs_;      ///< inputs of the step that is being lowered
    std::size_t outputs_ = 0;           ///< number of its results
    std::uint32_t node_ = 0;
};

}  // namespace

GraphValues::GraphValues(const TextureGraph& graph, const Skips* skips, GraphOutput output)
    : program_(skips) {
    std::vector<Register> results = Lowering(graph, program_)(output);
    if (results.size() == 1) results.resize(3, results.front());
    if (output == GraphOutput::color) results.resize(3);  // over black
    results_ = program_.finish(results);
}

std::array<const double*, 3> GraphValues::operator()(std::size_t count, Scratch& scratch) const {
    program_.run(count, scratch);
    return {scratch[results_[0]], scratch[results_[1]], scratch[results_[2]]};
}

Vec3d GraphValues::operator()(const Vec3d& point, Scratch& scratch) const {
    for (int axis = 0; axis < 3; ++axis) scratch[Register(axis)][0] = point[axis];
    const auto color = (*this)(1, scratch);
    return {*color[0], *color[1], *color[2]};
}

}  // namespace burl
