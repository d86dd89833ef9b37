#pragma once
// The definitions before a shader's texture function, each written once: octaves of noise, shapes,
// colour maps, constant arrays, images, and functions that its parts add.
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "procedural/glsl/text.h"
#include "procedural/graph/value_kernels.h"
#include "procedural/kernels/noise_sum.h"

namespace burl {

/// The largest number of pieces of a colour map that are found by comparisons, each of which costs
/// every texel time; more are found by bisection in a table.
inline constexpr std::size_t most_compared_pieces = 256;

class GlslFunctions {
  public:
    explicit GlslFunctions(GlslReal real) : real_(real) {}

    GlslReal real() const { return real_; }
    std::string number(double value) const { return glsl_number(value, real_); }

    /// Makes the shader contain a file, which follows all parts that texture() is given.
    void need(const char* file);
    /// Adds text that definitions after it may use.
    void add(const std::string& text) { text_ += text; }
    /// A new name: "STEM0", "STEM1" and so on.
    std::string new_name(std::string_view stem);
    /// The name of a function `real3 NAME(real x)`, added for piecewise polynomial colours.
    std::string color_map(const ColorPieces& pieces);

    /// The name of a function for octaves of a noise: glsl_split_noise where it has a kernel,
    /// otherwise glsl_site_noise.
    std::string octave(const NoiseSpec& noise, bool sloped = false);
    /// The expression that shapes an octave's value.
    std::string shaped(OctaveShape shape, const std::string& value);
    /// The expression of a number of octave k: an element of a constant array, or the number itself
    /// where there is one octave.
    std::string of_octave(const char* type, const std::vector<std::string>& values);
    /// The expression of a real number of octave k: a function of k, or the number itself.
    std::string real_of_octave(const std::vector<double>& values);
    /// The expression of the seed of octave k.
    std::string seed_of_octave(std::span<const SumOctave> octaves);
    /// The name of an image's sampler.
    std::string image(const std::shared_ptr<const MipImage>& pixels);

    /// The whole texture: the files that the definitions need, the parts `more`, the definitions,
    /// and `body`.
    GlslTexture texture(const std::string& body, std::span<const GlslPart> more) const;

  private:
    struct Octave {
        NoiseSpec noise;
        bool sloped = false;
        std::string name;
    };
    /// The name of a constant table, whose text define(name) is added where no other has its key.
    template <class Define>
    std::string table(const std::string& key, const Define& define);

    GlslReal real_;
    std::string text_;
    std::size_t names_ = 0;
    std::vector<const char*> files_;
    std::vector<GlslImage> images_;
    std::vector<GlslTable> tables_;
    std::vector<Octave> octaves_;
    std::set<OctaveShape> shapes_;
    std::vector<std::pair<std::string, std::string>> arrays_;  ///< pairs of text and name
};

}  // namespace burl
