#include "procedural/glsl/functions.h"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

#include "procedural/noise/names.h"

namespace burl {

namespace {

/// The lines of piece i of a function: "begin = ...;", "c0 = real3(...);" and so on.
std::string piece_lines(const ColorPieces& pieces, std::size_t i, GlslReal real) {
    const std::size_t coefficients = pieces.degree + 1;
    const double* piece = &pieces.table[i * pieces.stride()];
    const char* indent = i == 0 ? "    " : "        ";
    const auto number = [&](std::size_t k) { return glsl_number(piece[k], real); };
    std::string lines = fmt::format("{}{}begin = {};\n", indent, i == 0 ? "real " : "", number(0));
    for (std::size_t k = 0; k < coefficients; ++k)
        lines += fmt::format("{}{}c{} = real3({}, {}, {});\n", indent, i == 0 ? "real3 " : "", k,
                             number(1 + k), number(1 + coefficients + k),
                             number(1 + 2 * coefficients + k));
    return lines;
}

/// The lines that find the last piece that begins at or before t. (Comparisons are not nested:
/// llvmpipe fails where more than 80 are.)
std::string compared_lines(const ColorPieces& pieces, GlslReal real) {
    std::string text = piece_lines(pieces, 0, real);
    for (std::size_t i = 1; i < pieces.begins.size(); ++i)
        text += fmt::format("    if (t >= {}) {{\n{}    }}\n", glsl_number(pieces.begins[i], real),
                            piece_lines(pieces, i, real));
    return text;
}

/// The table of the pieces: the begins of all, then the numbers of each.
GlslTable piece_table(const std::string& name, const ColorPieces& pieces) {
    GlslTable table{name + "_pieces", pieces.begins};
    std::ranges::copy(pieces.table, std::back_inserter(table.numbers));
    return table;
}

/// The lines that look a piece up in the table by bisection.
std::string halved_lines(const std::string& table, const ColorPieces& pieces) {
    const std::size_t count = pieces.begins.size(), coefficients = pieces.degree + 1;
    std::string text = fmt::format(
        "    int piece = 0;\n"
        "    for (int jump = {0}; jump > 0; jump /= 2)\n"
        "        if (piece + jump < {1} && t >= {2}_at(min(piece + jump, {3}))) piece += jump;\n"
        "    int at = {1} + {4} * piece;\n"
        "    real begin = {2}_at(at);\n",
        std::bit_floor(count), count, table, count - 1, pieces.stride());
    for (std::size_t k = 0; k < coefficients; ++k)
        text += fmt::format(
            "    real3 c{0} = real3({1}_at(at + {2}), {1}_at(at + {3}), {1}_at(at + {4}));\n", k,
            table, 1 + k, 1 + coefficients + k, 1 + 2 * coefficients + k);
    return text;
}

}  // namespace

void GlslFunctions::need(const char* file) {
    if (std::ranges::find(files_, std::string_view(file)) == files_.end()) files_.push_back(file);
}

std::string GlslFunctions::new_name(std::string_view stem) {
    return fmt::format("{}{}", stem, names_++);
}

std::string GlslFunctions::color_map(const ColorPieces& pieces) {
    std::string name = new_name("color_map");
    std::string lines;
    if (pieces.begins.size() > most_compared_pieces) {
        tables_.push_back(piece_table(name, pieces));
        lines = halved_lines(tables_.back().name, pieces);
    } else {
        lines = compared_lines(pieces, real_);
    }
    const bool repeats = pieces.argument == ColorPieces::Argument::repeat;
    add(fmt::format("real3 {}(real x) {{\n    real t = {}(x);\n{}", name,
                    repeats ? "repeated_index" : "clamped_index", lines));
    add("    exact real u = t - begin;\n    exact real3 color = ");
    for (std::size_t k = 0; k < pieces.degree; ++k) add(fmt::format("c{} + u * (", k));
    add(fmt::format("c{}{};\n    return color;\n}}\n\n", pieces.degree,
                    std::string(pieces.degree, ')')));
    return name;
}

std::string GlslFunctions::octave(const NoiseSpec& noise, bool sloped) {
    for (const Octave& known : octaves_)
        if (known.noise == noise && known.sloped == sloped) return known.name;
    std::string name = sloped ? "sloped_octave_" : "octave_";
    for (const auto& kind : noise_kinds)
        if (kind.value == noise.kind) name += kind.name;
    const auto same_kind = std::ranges::count_if(octaves_, [&](const Octave& known) {
        return known.noise.kind == noise.kind && known.sloped == sloped;
    });
    if (same_kind > 0) name += fmt::format("_{}", same_kind + 1);
    if (has_point_kernel(noise))
        add(glsl_split_noise(noise, name, sloped));
    else
        add(glsl_site_noise(noise, name, sloped));
    add("\n");
    octaves_.push_back({noise, sloped, name});
    return name;
}

std::string GlslFunctions::shaped(OctaveShape shape, const std::string& value) {
    if (shape == OctaveShape::plain) return value;
    const std::string_view name = glsl_shape_name(shape);
    if (shapes_.insert(shape).second) add(glsl_octave_shape(shape, name) + "\n");
    return fmt::format("{}({})", name, value);
}

template <class Define>
std::string GlslFunctions::table(const std::string& key, const Define& define) {
    for (const auto& [text, name] : arrays_)
        if (text == key) return name;
    std::string name = fmt::format("table{}", arrays_.size());
    add(define(name));
    arrays_.emplace_back(key, name);
    return name;
}

std::string GlslFunctions::of_octave(const char* type, const std::vector<std::string>& values) {
    if (values.size() == 1) return glsl_operand(values[0]);
    const std::string list =
        fmt::format("{0}[{1}]({2})", type, values.size(), fmt::join(values, ", "));
    const auto define = [&](const std::string& name) {
        return fmt::format("const {} {}[{}] = {};\n\n", type, name, values.size(), list);
    };
    return table(list, define) + "[k]";
}

std::string GlslFunctions::real_of_octave(const std::vector<double>& values) {
    if (values.size() == 1) return glsl_operand(number(values[0]));
    const auto define = [&](const std::string& name) { return glsl_array(name, values, 1, real_); };
    return table(fmt::format("{}", fmt::join(values, ", ")), define) + "(k)";
}

std::string GlslFunctions::seed_of_octave(std::span<const SumOctave> octaves) {
    std::vector<std::string> seeds;
    bool follow = true;
    for (const SumOctave& octave : octaves) {
        follow = follow && octave.seed == octaves[0].seed + std::uint32_t(seeds.size());
        seeds.push_back(fmt::format("{}u", octave.seed));
    }
    if (seeds.size() == 1 || !follow) return of_octave("uint", seeds);
    return seeds[0] == "0u" ? "uint(k)" : seeds[0] + " + uint(k)";
}

std::string GlslFunctions::image(const std::shared_ptr<const MipImage>& pixels) {
    for (const GlslImage& known : images_)
        if (known.pixels == pixels) return known.uniform;
    images_.push_back({fmt::format("image{}", images_.size()), pixels});
    add(fmt::format("uniform sampler2D {};\n\n", images_.back().uniform));
    return images_.back().uniform;
}

GlslTexture GlslFunctions::texture(const std::string& body, std::span<const GlslPart> more) const {
    std::vector<NoiseSpec> noises, sloped;
    for (const Octave& octave : octaves_) {
        noises.push_back(octave.noise);
        if (octave.sloped) sloped.push_back(octave.noise);
    }
    GlslTexture texture{glsl_noise_parts(noises), images_, tables_};
    for (GlslPart& part : glsl_gradient_parts(sloped)) texture.parts.push_back(std::move(part));
    for (const char* file : {"numbers/elementary.glsl", "maps/level_size.glsl", "graph/graph.glsl"})
        texture.parts.push_back({file});
    texture.parts.insert(texture.parts.end(), more.begin(), more.end());
    for (const char* file : files_) texture.parts.push_back({file});
    texture.parts.push_back({"the graph", text_ + body});
    return texture;
}

}  // namespace burl
