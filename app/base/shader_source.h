#pragma once
// A shader put together from parts: hand-written files of shaders/ and generated text under one
// #version, so that functions stand once, and a compiler's complaint names the part and its own
// line. All of it is text and needs no OpenGL.
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "procedural/glsl/noise.h"

namespace burl {

/// The text of a file of shaders/. Throws Error(runtime) when the program holds none of that name.
std::string_view embedded_shader(std::string_view name);

/// Text in GLSL 3.30 core: extensions and macros first, whenever they are added, then the parts in
/// order.
class ShaderSource {
  public:
    /// `#extension NAME : require`.
    ShaderSource& extension(std::string_view name);
    /// `#define NAME VALUE`.
    ShaderSource& define(std::string_view name, std::string_view value);
    /// The macros real, real2, real3 and real4: double, dvec2, ... or float, vec2, ...;
    /// BURL_FLOAT64 is 1 or 0.
    ShaderSource& define_real(bool float64);
    /// A file of shaders/; its own #version, if any, does not count.
    ShaderSource& add(std::string_view embedded);
    /// `name` stands in messages.
    ShaderSource& add(std::string name, std::string_view text);

    std::string text() const;
    /// A compiler's log of text() with parts and their own lines for lines of the whole.
    std::string with_names(std::string_view log) const;

  private:
    struct Part {
        std::string name, text;
    };
    std::string place_of(std::size_t line) const;

    std::string head_ = "#version 330 core\n", macros_;
    std::vector<Part> parts_;
};

/// Adds them in order.
void add_parts(ShaderSource& source, std::span<const GlslPart> parts);

}  // namespace burl
