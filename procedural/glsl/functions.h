#pragma once
// What stands before a shader's texture function, each once: octaves of noise, shapes, constant
// arrays, images, and whatever functions its parts add.
#include <set>
#include <span>
#include <utility>

#include "procedural/glsl/color_pieces.h"
#include "procedural/glsl/text.h"
#include "procedural/kernels/noise_sum.h"

namespace burl {

class GlslFunctions {
  public:
    explicit GlslFunctions(GlslReal real) : real_(real) {}

    GlslReal real() const { return real_; }
    std::string number(double value) const { return glsl_number(value, real_); }

    /// Text that the functions behind it may use.
    void add(const std::string& text) { text_ += text; }
    /// The same, and its table.
    void add(GlslColorPieces pieces);
    /// "STEM0", "STEM1" and so on.
    std::string new_name(std::string_view stem);

    /// The name of a function for octaves of that noise: glsl_split_noise where it has a kernel,
    /// else glsl_site_noise; `sloped`: glsl_split_sample or glsl_site_sample.
    std::string octave(const NoiseSpec& noise, bool sloped = false);
    /// The call that shapes an octave's value.
    std::string shaped(OctaveShape shape, const std::string& value);
    /// A number of octave k: an element of a constant array, or the number itself where there is
    /// one octave.
    std::string of_octave(const char* type, const std::vector<std::string>& values);
    std::string seed_of_octave(std::span<const SumOctave> octaves);
    /// The name of its sampler.
    std::string image(const std::shared_ptr<const MipImage>& pixels);

    /// Everything, the files it needs before it and `body` after it; `more` parts behind the files
    /// of values.
    GlslTexture texture(const std::string& body, std::span<const GlslPart> more) const;

  private:
    struct Octave {
        NoiseSpec noise;
        bool sloped = false;
        std::string name;
    };
    std::string array(const char* type, const std::vector<std::string>& values);

    GlslReal real_;
    std::string text_;
    std::size_t names_ = 0;
    std::vector<GlslImage> images_;
    std::vector<GlslTable> tables_;
    std::vector<Octave> octaves_;
    std::set<OctaveShape> shapes_;
    std::vector<std::pair<std::string, std::string>> arrays_;  ///< text and name
};

}  // namespace burl
