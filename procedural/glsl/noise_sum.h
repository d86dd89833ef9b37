#pragma once
// Sums of octaves as GLSL, of values or with gradients: where coordinates are split once for
// several octaves, as noise_sum.h does where it has a kernel, and octave by octave elsewhere.
#include <array>
#include <map>

#include "procedural/glsl/functions.h"

namespace burl {

/// Lines of a function's body and what they give.
struct GlslSum {
    std::string lines;
    std::string result;  ///< an expression
};

/// The sums of one function's body.
class GlslNoiseSums {
  public:
    /// Coordinates of a point, operands of type `real`.
    using Point = std::vector<std::string>;

    explicit GlslNoiseSums(GlslFunctions& functions) : functions_(functions) {}

    /// add_up: of type `real`. `total` is the name of a variable that the lines may define. The sum
    /// has an octave at least.
    GlslSum values(const NoiseSum& sum, const Point& point, const std::string& total);

    /// add_up_slopes: a vec4 of the sum and its derivatives along the point's coordinates. `kept`
    /// names a float, how many octaves show; empty: all. The offset is left out.
    GlslSum slopes(const NoiseSum& sum, const Point& point, const std::string& kept, double mean,
                   const std::string& total);

  private:
    struct Octaves;
    std::string doubling_lines(const Octaves& octaves, const Point& point,
                               const std::string& total);
    std::string apart_lines(const Octaves& octaves, const Point& point, const std::string& total);
    std::string sum_line(const Octaves& octaves, const std::string& split,
                         const std::string& total);
    std::string split_lines(const Octaves& all, const Point& point, const std::string& total);
    std::string site_noise(const NoiseSum& sum, const Point& point, bool sloped);

    GlslFunctions& functions_;
    std::map<std::string, std::string> splits_;  ///< variables of split points, by what they split
};

}  // namespace burl
