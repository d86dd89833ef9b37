// Logs are of three kinds: Mesa's "1:2(3): error", NVIDIA's "1(2) : error" and "ERROR: 1:2:" of
// most others, 1 being the number that #line gave the part and 2 the line.
#include "app/gl_source.h"

#include <algorithm>
#include <cctype>
#include <charconv>

#include "app/embedded.h"
#include "atlas/error.h"

namespace burl {

namespace {

bool is_digit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// A version must come first, so a part's own line of it becomes an empty one.
std::string without_version(std::string_view text) {
    std::string result(text);
    if (!text.starts_with("#version")) return result;
    return result.substr(std::min(result.find('\n'), result.size()));
}

/// Where a line of a log has the number of a part, or past its end.
std::size_t number_place(std::string_view line) {
    for (const std::string_view lead : {"ERROR: ", "WARNING: "})
        if (line.starts_with(lead)) return lead.size();
    return 0;
}

}  // namespace

std::string_view embedded_shader(std::string_view name) {
    for (const EmbeddedFile& file : embedded_shaders()) {
        if (file.name == name) return file.content;
    }
    throw Error(ExitCode::runtime, fmt::format("the shader {} is not in this program", name));
}

bool has_float64(const GladGLContext& gl) {
    GLint major = 0, count = 0;
    gl.GetIntegerv(GL_MAJOR_VERSION, &major);
    if (major >= 4) return true;
    gl.GetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i) {
        const auto* name = reinterpret_cast<const char*>(gl.GetStringi(GL_EXTENSIONS, GLuint(i)));
        if (std::string_view(name) == "GL_ARB_gpu_shader_fp64") return true;
    }
    return false;
}

ShaderSource& ShaderSource::extension(std::string_view name) {
    head_ += fmt::format("#extension {} : require\n", name);
    return *this;
}

ShaderSource& ShaderSource::define(std::string_view name, std::string_view value) {
    macros_ += fmt::format("#define {} {}\n", name, value);
    return *this;
}

ShaderSource& ShaderSource::define_real(bool float64) {
    if (float64) extension("GL_ARB_gpu_shader_fp64");
    define("BURL_FLOAT64", float64 ? "1" : "0").define("real", float64 ? "double" : "float");
    for (const int n : {2, 3, 4})
        define(fmt::format("real{}", n), fmt::format("{}vec{}", float64 ? "d" : "", n));
    return *this;
}

ShaderSource& ShaderSource::add(std::string_view embedded) {
    return add(std::string(embedded), embedded_shader(embedded));
}

ShaderSource& ShaderSource::add(std::string name, std::string_view text) {
    parts_.push_back({std::move(name), without_version(text)});
    return *this;
}

std::string ShaderSource::text() const {
    std::string result = head_ + macros_;
    for (std::size_t i = 0; i < parts_.size(); ++i)
        result += fmt::format("#line 1 {}\n{}\n", i + 1, parts_[i].text);
    return result;
}

std::string ShaderSource::with_names(std::string_view log) const {
    std::string result;
    while (!log.empty()) {
        const std::size_t end = std::min(log.find('\n'), log.size() - 1) + 1;
        std::string_view line = log.substr(0, end);
        log.remove_prefix(end);
        const std::size_t place = number_place(line);
        std::size_t number = 0;
        const auto [stop, failure] =
            std::from_chars(line.data() + place, line.data() + line.size(), number);
        const std::string_view rest = line.substr(std::size_t(stop - line.data()));
        const bool named = failure == std::errc() && number <= parts_.size() && rest.size() > 1 &&
                           (rest[0] == ':' || rest[0] == '(') && is_digit(rest[1]);
        if (!named) {
            result += line;
            continue;
        }
        result += line.substr(0, place);
        result += number == 0 ? "(macros)" : parts_[number - 1].name;
        result += rest;
    }
    return result;
}

GlProgram make_program(const GladGLContext& gl, const std::string& name, const ShaderSource& vertex,
                       const ShaderSource& fragment) {
    return GlProgram::from_source(
        gl, name, vertex.text(), fragment.text(), [&](GLenum kind, std::string_view log) {
            return (kind == GL_VERTEX_SHADER ? vertex : fragment).with_names(log);
        });
}

GlProgram make_full_screen_program(const GladGLContext& gl, const std::string& name,
                                   const ShaderSource& fragment) {
    return make_program(gl, name, ShaderSource().add("full_screen.vert"), fragment);
}

}  // namespace burl
