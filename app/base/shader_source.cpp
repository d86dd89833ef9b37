// Logs come in three forms: Mesa's "0:12(3): error", NVIDIA's "0(12) : error" and "ERROR: 0:12:" of
// most others. 12 is a line of the whole text: Mesa ignores the source number of #line.
#include "app/base/shader_source.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include <fmt/format.h>

#include "app/base/embedded.h"
#include "app/base/shader_numbers.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

/// The part's text ending with a newline. Its own #version line becomes empty, since the whole has
/// one at its beginning, and line numbers stay.
std::string part_text(std::string_view text) {
    if (text.starts_with("#version")) text.remove_prefix(std::min(text.find('\n'), text.size()));
    std::string result(text);
    if (!result.ends_with('\n')) result += '\n';
    return result;
}

/// The place in a log's line that refers to a line of the source.
struct LogPlace {
    std::size_t begin = 0, end = 0;  ///< the range of "0:12" or "0(12)" in the log's line
    std::size_t line = 0;            ///< the source's line, 12; 0 where the log names none
};

LogPlace log_place(std::string_view line) {
    LogPlace place;
    for (const std::string_view lead : {"ERROR: ", "WARNING: "})
        if (line.starts_with(lead)) place.begin = lead.size();
    const std::string_view rest = line.substr(place.begin);
    if (!rest.starts_with("0:") && !rest.starts_with("0(")) return place;
    const char* const end = line.data() + line.size();
    const auto [stop, failure] = std::from_chars(rest.data() + 2, end, place.line);
    if (failure != std::errc()) return {};
    place.end = std::size_t(stop - line.data());
    if (rest[1] == '(') place.end = std::min(place.end + 1, line.size());
    return place;
}

std::size_t line_count(std::string_view text) {
    return std::size_t(std::ranges::count(text, '\n'));
}

}  // namespace

std::string_view embedded_shader(std::string_view name) {
    for (const EmbeddedFile& file : embedded_shaders()) {
        if (file.name == name) return file.content;
    }
    throw Error(ExitCode::runtime, fmt::format("the shader {} is not in this program", name));
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
    add(std::string(embedded), embedded_shader(embedded));
    parts_.back().generated = false;
    return *this;
}

ShaderSource& ShaderSource::add(std::string name, std::string_view text) {
    parts_.push_back({std::move(name), part_text(text)});
    return *this;
}

std::vector<float> ShaderSource::take_numbers(std::size_t most) {
    std::vector<float> values;
    std::vector<Part> parts = parts_;
    for (Part& part : parts) {
        if (!part.generated) continue;
        const ShaderNumbers cut = shader_numbers(part.text);
        std::vector<std::string> elements;
        for (const ShaderNumber& number : cut.numbers) {
            elements.push_back(fmt::format("generated_numbers[{}].{}", values.size() / 4,
                                           "xyzw"[values.size() % 4]));
            values.push_back(float(number.value));
        }
        part.text = with_expressions(cut, elements);
    }
    if (values.empty() || values.size() > most) return {};
    const auto first = std::ranges::find(parts, true, &Part::generated);
    parts.insert(
        first,
        {"numbers", fmt::format("uniform vec4 generated_numbers[{}];\n", (values.size() + 3) / 4),
         false});
    parts_ = std::move(parts);
    return values;
}

std::string ShaderSource::text() const {
    std::string result = head_ + macros_;
    for (const Part& part : parts_) result += part.text;
    return result;
}

std::string ShaderSource::place_of(std::size_t line) const {
    std::string name = "(macros)";
    std::size_t begin = 0, end = line_count(head_) + line_count(macros_);
    for (const Part& part : parts_) {
        if (line <= end) break;
        name = part.name;
        begin = end;
        end += line_count(part.text);
    }
    return fmt::format("{}:{}", name, line - begin);
}

std::string ShaderSource::with_names(std::string_view log) const {
    std::string result;
    while (!log.empty()) {
        const std::size_t length = std::min(log.find('\n'), log.size() - 1) + 1;
        const std::string_view line = log.substr(0, length);
        log.remove_prefix(length);
        const LogPlace place = log_place(line);
        if (place.line == 0)
            result += line;
        else
            result += fmt::format("{}{}{}", line.substr(0, place.begin), place_of(place.line),
                                  line.substr(place.end));
    }
    return result;
}

void add_parts(ShaderSource& source, std::span<const GlslPart> parts) {
    for (const GlslPart& part : parts)
        if (part.text.empty())
            source.add(part.name);
        else
            source.add(part.name, part.text);
}

}  // namespace burl
