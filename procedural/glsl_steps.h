#pragma once
// The steps of a value program as GLSL: lines of the function that evaluates it, functions and
// uniforms that stand before it.
#include <map>
#include <set>
#include <span>

#include "procedural/glsl_text.h"
#include "procedural/value_program.h"

namespace burl {

/// What a step became. Constants need no line: their output is the number itself.
struct GlslStep {
    std::string lines;
    std::vector<std::string> outputs;  ///< expressions of type real
};

class GlslSteps {
  public:
    GlslSteps(const ValueProgram& program, GlslReal real);

    /// `inputs` are operands.
    GlslStep write(const ValueWork& work, const std::vector<std::string>& inputs);

    /// Everything that the written steps need, and `body` after it.
    GlslTexture texture(std::string body) const;

  private:
    using Inputs = std::vector<std::string>;

    GlslStep step(const ValueOperation& operation, const Inputs& inputs);
    GlslStep step(const NoiseSum& sum, const Inputs& inputs);
    GlslStep step(const ColorPieces& pieces, const Inputs& inputs);
    GlslStep step(const DotsWeight& dots, const Inputs& inputs);
    GlslStep step(const ImageLookup& lookup, const Inputs& inputs);
    GlslStep step(const GraphSlope& slope, const Inputs& inputs);

    std::string number(double value) const { return glsl_number(value, real_); }
    std::string expression(const ValueOperation& operation, const Inputs& in) const;
    /// "real vN = expression;"
    GlslStep value(const std::string& expression);
    GlslStep color(const std::string& expression);

    // glsl_noise_sum.cpp
    GlslStep split_sum(const NoiseSum& sum, const Inputs& inputs);
    GlslStep site_sum(const NoiseSum& sum, const Inputs& inputs);
    std::string doubling_lines(const NoiseSum& sum, std::span<const SumOctave> octaves,
                               const Inputs& inputs, const std::string& total);
    std::string apart_lines(const NoiseSum& sum, const Inputs& inputs, const std::string& total);
    std::string of_octave(const char* type, const std::vector<std::string>& values);
    std::string seed_of_octave(std::span<const SumOctave> octaves);
    std::string octave_noise(const NoiseSpec& noise);
    std::string shaped(OctaveShape shape, const std::string& value);
    std::string array(const char* type, const std::vector<std::string>& values);

    GlslReal real_;
    bool has_angles_ = false;  ///< which alone tell signs of zeros apart
    std::size_t values_ = 0;
    std::string functions_;
    std::vector<GlslImage> images_;
    std::vector<NoiseSpec> noises_;
    std::vector<std::string> noise_names_;
    std::set<OctaveShape> shapes_;
    std::map<std::string, std::string> splits_;  ///< variables of split points, by what they split
    std::map<std::string, std::string> tables_;  ///< names of constant arrays, by their text
};

}  // namespace burl
