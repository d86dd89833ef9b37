#pragma once
// The steps of a value program (graph/value_program.h) as GLSL for one point: one variable of type
// real for each number, with the same operations in the same order.
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "procedural/glsl/duals.h"
#include "procedural/glsl/functions.h"
#include "procedural/glsl/noise_sum.h"
#include "procedural/graph/value_program.h"

namespace burl {

/// A step as text. Constants need no line: their output is the number itself.
struct GlslStep {
    std::string lines;
    std::vector<std::string> outputs;  ///< expressions of type real
};

/// The steps of a value program as GLSL: lines of the function that evaluates it, and functions
/// that precede it.
class GlslSteps {
  public:
    /// Takes the program, whose steps are written in their order; functions and colour maps with
    /// gradients are added to `functions` and `maps`, which must outlive this object.
    GlslSteps(const ValueProgram& program, GlslFunctions& functions, GlslMapTables& maps);

    /// Writes a step; `inputs` are operands.
    GlslStep write(const ValueWork& work, const std::vector<std::string>& inputs);

  private:
    using Inputs = std::vector<std::string>;

    GlslStep step(const ValueOperation& operation, const Inputs& inputs);
    GlslStep step(const NoiseSum& sum, const Inputs& inputs);
    GlslStep step(const SimplexOctaves& octaves, const Inputs& inputs);
    GlslStep step(const CurlOctaves& octaves, const Inputs& inputs);
    GlslStep step(const ColorPieces& pieces, const Inputs& inputs);
    GlslStep step(const DotsWeight& dots, const Inputs& inputs);
    GlslStep step(const CellNumber& cell, const Inputs& inputs);
    GlslStep step(const CellFeature& feature, const Inputs& inputs);
    GlslStep step(const ScatteredShapes& shapes, const Inputs& inputs);
    GlslStep step(const ImageLookup& lookup, const Inputs& inputs);
    GlslStep step(const GraphSlope& slope, const Inputs& inputs);
    GlslStep step(const MaskRead& read, const Inputs& inputs);
    GlslStep step(const PointFunction& function, const Inputs& inputs);

    std::string number(double value) const { return functions_.number(value); }
    std::string expression(const ValueOperation& operation, const Inputs& in) const;
    /// The step "real vN = expression;".
    GlslStep value(const std::string& expression);
    /// The step "real3 colorN = expression;".
    GlslStep color(const std::string& expression);

    GlslFunctions& functions_;
    GlslNoiseSums sums_;
    GlslMapTables& maps_;
    bool has_angles_ = false;  ///< only angles depend on signs of zeros
    std::size_t values_ = 0;
    std::vector<std::pair<std::shared_ptr<const GraphEvaluator>, std::string>> graphs_;
};

}  // namespace burl
