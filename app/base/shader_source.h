#pragma once
// Shader sources assembled from parts: hand-written files of shaders/ and generated text under one
// #version line. Every function is written once, and compilers' messages name the part and the line
// within it. Text only, without OpenGL.
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "procedural/glsl/noise.h"

namespace burl {

/// The text of a file of shaders/. Throws Error(runtime) where the program embeds none of that
/// name.
std::string_view embedded_shader(std::string_view name);

/// GLSL 3.30 core: the #version line, extensions, macros, then the parts in the order they were
/// added.
class ShaderSource {
  public:
    /// Adds `#extension NAME : require`.
    ShaderSource& extension(std::string_view name);
    /// Adds `#define NAME VALUE`.
    ShaderSource& define(std::string_view name, std::string_view value);
    /// Defines the macros real, real2, real3 and real4 as double, dvec2, ... or float, vec2, ...,
    /// and BURL_FLOAT64 as 1 or 0.
    ShaderSource& define_real(bool float64);
    /// Adds a file of shaders/; a #version line at its beginning becomes an empty line.
    ShaderSource& add(std::string_view embedded);
    /// Adds text that messages call `name`.
    ShaderSource& add(std::string name, std::string_view text);

    /// Replaces the floating-point numbers of generated parts, which must be in float32, by
    /// elements of the uniform `vec4 generated_numbers[]`, and returns their values, so that
    /// shaders which differ in numbers alone have one text. More than `most` stay where they are.
    std::vector<float> take_numbers(std::size_t most);

    std::string text() const;
    /// A compiler's log of text() in which each line number of the whole is replaced by the part's
    /// name and the line within it.
    std::string with_names(std::string_view log) const;

  private:
    struct Part {
        std::string name, text;
        bool generated = true;
    };
    std::string place_of(std::size_t line) const;

    std::string head_ = "#version 330 core\n", macros_;
    std::vector<Part> parts_;
};

/// Adds generated parts in order; a part without text is a file of shaders/ by its name.
void add_parts(ShaderSource& source, std::span<const GlslPart> parts);

}  // namespace burl
