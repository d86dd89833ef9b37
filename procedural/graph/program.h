#pragma once
// The program of a texture graph: a straight list of steps on numbered registers, which hold a
// number per point. The nodes' definitions (node_ops.h) add the steps. Three back ends execute or
// write them: values alone (values.h), values with gradients (duals.h, evaluator.h), and GLSL with
// gradients (glsl/duals.h). A mean over the footprint is, of a point sample, the function itself.
#include <algorithm>
#include <limits>
#include <memory>
#include <variant>
#include <vector>

#include "procedural/graph/graph.h"
#include "procedural/graph/point_function.h"
#include "procedural/graph/scattered_shapes.h"
#include "procedural/graph/step_registers.h"
#include "procedural/graph/value_kernels.h"
#include "procedural/kernels/noise_sum.h"
#include "procedural/noise/cell_features.h"
#include "procedural/noise/simplex_signal.h"

namespace burl {

/// The mean over the footprint of `function`, which is odd, fract or sine, exact where the input is
/// linear across it (box_means.h).
struct BoxMean {
    ValueOp function = ValueOp::odd;
};

/// The share of the footprint where fract(x) is at least the threshold, exact where the input is
/// linear across it (box_means.h).
struct BoxPulse {
    double threshold = 0.0;
};

/// The share of the footprint where factor x + offset is at least the threshold. Between half of
/// `widest` and `widest`, a width in units of the result, it fades to `mean`: what is told by a
/// distance to the nearest border is wrong where the footprint holds several.
struct BoxStep {
    double factor = 1.0, offset = 0.0, threshold = 0.0;
    double mean = 0.5, widest = std::numeric_limits<double>::infinity();
};

/// The turn x, or x + 1 where x is below 0: from (-1/2, 1/2] to [0, 1).
struct PositiveTurn {};

/// The derivative of the input along a direction of solid space; its own gradient counts as 0.
struct SlopeAlong {
    Vec3d direction{0.0};
};

/// The method by which a checkerboard averages over the footprint (docs/reference/nodes.md).
enum class Antialiasing { none, closed_form, supersample, trapezoid };

/// The share of odd cells around a point in a board of unit squares (2 axes) or unit cubes (3).
struct Checkerboard {
    Antialiasing antialiasing = Antialiasing::none;
    std::size_t axes = 2;
};

/// The sum of octaves sum_k gain^k shape(n_{seed+k}(scale lacunarity^k p)) at a point p.
struct OctaveSum {
    NoiseSpec noise;
    double octaves = 1.0, lacunarity = 2.0, gain = 0.5;
    OctaveShape shape = OctaveShape::plain;  ///< plain or absolute
    double scale = 1.0;
    bool fades = true;  ///< whether octaves that the footprint does not show fade

    /// The mean of shape(n), which replaces octaves that have faded.
    double mean() const;
    /// The octaves before the first of weight 0, their frequencies times `factor`.
    NoiseSum sum(double factor = 1.0) const;
};

/// How octaves follow one another: octave k has seed + k, frequency lacunarity^k and weight gain^k.
struct OctaveLadder {
    std::uint32_t seed = 0;
    double octaves = 1.0, lacunarity = 2.0, gain = 0.5;
    bool operator==(const OctaveLadder&) const = default;
};

/// The sum of octaves of a simplex noise at the first `noise.dimensions` inputs, of which the first
/// three are the point, whose frequency rises; the others are the same in every octave.
struct SimplexOctaves {
    SimplexNoise noise;
    OctaveLadder octaves;
    bool operator==(const SimplexOctaves&) const = default;
};

/// The three components of a sum of octaves of a random field without divergence
/// (noise/simplex_curl.h) at a point.
struct CurlOctaves {
    std::optional<double> time;  ///< the same in every octave
    OctaveLadder octaves;
    bool operator==(const CurlOctaves&) const = default;
};

/// The field f of a texture of the 1999 model at a point (Hart et al. 1999, equation 1).
struct FieldAt {
    const Texture* texture = nullptr;
};

/// The mean over the footprint of a colour map at a number: red, green and blue, linear light times
/// alpha; or its alpha, three times.
struct MapColors {
    const ColorMap* colors = nullptr;
    bool alpha = false;

    /// The map whose colours these are.
    ColorMap map() const { return alpha ? alpha_map(*colors) : *colors; }
};

/// The colour of pbrt's marble at a number in [0, 1], red, green and blue, linear light: a spline
/// of four neighbouring control points.
struct MarbleColors {
    bool smooth = false;  ///< the uniform cubic B-spline instead of Bernstein's polynomials
};

/// The weight of `inside` in the node `dots`, 1 within a disk, at a point's first two coordinates.
struct DotsWeight {
    std::uint32_t seed = 0, period_u = 0, period_v = 0;
    double radius = 0.0;
    bool operator==(const DotsWeight&) const = default;
};

/// The random number in [0, 1), in steps of 2^-24, of the unit cell that holds a point of one to
/// three coordinates.
struct CellNumber {
    std::uint32_t seed = 0;
    bool operator==(const CellNumber&) const = default;
};

/// The distance, edge or id of the cell around a point, without regard to the footprint.
struct CellFeature {
    CellPoints points;
    CellGives gives = CellGives::distance;
    bool operator==(const CellFeature&) const = default;
};

/// The mean over the footprint of an image at a point's first two coordinates: red, green and blue,
/// linear light times alpha. Of an image's alpha it is that of the map MipImage::alpha.
struct ImageColors {
    std::shared_ptr<const MipImage> pixels;
    bool ewa = false;         ///< elliptically weighted average instead of trilinear lookup
    double anisotropy = 8.0;  ///< largest ratio of an ellipse's axes
};

/// The value of a mask of the graph (masks.h) at the texel that is being filled, with the gradient
/// that comes with it.
struct MaskRead {
    std::size_t mask = 0;
    bool operator==(const MaskRead&) const = default;
};

/// The work of a step.
using GraphWork = std::variant<ValueOperation, BoxMean, BoxPulse, BoxStep, PositiveTurn, SlopeAlong,
                               Checkerboard, OctaveSum, SimplexOctaves, CurlOctaves, FieldAt,
                               MapColors, MarbleColors, DotsWeight, CellNumber, CellFeature,
                               ScatteredShapes, ImageColors, MaskRead, PointFunction>;

/// The largest number of registers that a step reads.
inline constexpr std::size_t most_step_inputs =
    std::max(most_simplex_dimensions, most_point_inputs);

/// A step of a program: work with the registers that it reads and fills.
struct GraphStep {
    GraphWork work;
    std::vector<Register> inputs, outputs;
    std::uint32_t node = 0;  ///< node of the graph that added the step
};

/// The steps of a graph, each behind those that fill its inputs.
struct GraphProgram {
    std::vector<GraphStep> steps;
    std::vector<Register> results;  ///< channels of the base colour's node
    /// The registers of the other channels, in the order of TextureGraph::channels: one of a
    /// number; red, green, blue of a colour.
    std::vector<std::vector<Register>> channels;
    std::size_t registers = 3;  ///< number of registers
};

/// The program of all nodes of a graph, in their order. The graph must be valid and not empty, and
/// must outlive the program, which points into it.
GraphProgram program_of(const TextureGraph& graph);

}  // namespace burl
