#pragma once
// The steps of a value program as GLSL: lines of the function that evaluates it, and functions that
// precede it.
#include "procedural/glsl/noise_sum.h"
#include "procedural/graph/value_program.h"

namespace burl {

/// A step as text. Constants need no line: their output is the number itself.
struct GlslStep {
    std::string lines;
    std::vector<std::string> outputs;  ///< expressions of type real
};

class GlslSteps {
  public:
    GlslSteps(const ValueProgram& program, GlslFunctions& functions);

    /// Writes a step; `inputs` are operands.
    GlslStep write(const ValueWork& work, const std::vector<std::string>& inputs);

  private:
    using Inputs = std::vector<std::string>;

    GlslStep step(const ValueOperation& operation, const Inputs& inputs);
    GlslStep step(const NoiseSum& sum, const Inputs& inputs);
    GlslStep step(const ColorPieces& pieces, const Inputs& inputs);
    GlslStep step(const DotsWeight& dots, const Inputs& inputs);
    GlslStep step(const ImageLookup& lookup, const Inputs& inputs);
    GlslStep step(const GraphSlope& slope, const Inputs& inputs);

    std::string number(double value) const { return functions_.number(value); }
    std::string expression(const ValueOperation& operation, const Inputs& in) const;
    /// The step "real vN = expression;".
    GlslStep value(const std::string& expression);
    /// The step "real3 colorN = expression;".
    GlslStep color(const std::string& expression);

    GlslFunctions& functions_;
    GlslNoiseSums sums_;
    bool has_angles_ = false;  ///< only angles depend on signs of zeros
    std::size_t values_ = 0;
    std::vector<std::pair<std::shared_ptr<const GraphEvaluator>, std::string>> graphs_;
};

}  // namespace burl
