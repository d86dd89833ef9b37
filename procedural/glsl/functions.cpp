#include "procedural/glsl/functions.h"

#include <algorithm>

#include <fmt/format.h>

#include "procedural/noise/names.h"

namespace burl {

void GlslFunctions::add(GlslColorPieces pieces) {
    add(pieces.text);
    if (pieces.table) tables_.push_back(std::move(*pieces.table));
}

std::string GlslFunctions::new_name(std::string_view stem) {
    return fmt::format("{}{}", stem, names_++);
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
        add(sloped ? glsl_split_sample(noise, name) : glsl_split_noise(noise, name));
    else
        add(sloped ? glsl_site_sample(noise, name) : glsl_site_noise(noise, name));
    add("\n");
    octaves_.push_back({noise, sloped, name});
    return name;
}

std::string GlslFunctions::shaped(OctaveShape shape, const std::string& value) {
    if (shape == OctaveShape::plain) return value;
    const std::string name = shape == OctaveShape::absolute ? "absolute" : "ridged";
    if (shapes_.insert(shape).second) add(glsl_octave_shape(shape, name) + "\n");
    return fmt::format("{}({})", name, value);
}

std::string GlslFunctions::array(const char* type, const std::vector<std::string>& values) {
    const std::string list =
        fmt::format("{0}[{1}]({2})", type, values.size(), fmt::join(values, ", "));
    for (const auto& [text, name] : arrays_)
        if (text == list) return name;
    const std::string name = fmt::format("table{}", arrays_.size());
    add(fmt::format("const {} {}[{}] = {};\n\n", type, name, values.size(), list));
    arrays_.emplace_back(list, name);
    return name;
}

std::string GlslFunctions::of_octave(const char* type, const std::vector<std::string>& values) {
    return values.size() > 1 ? array(type, values) + "[k]" : glsl_operand(values[0]);
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
    texture.parts.push_back({"the graph", text_ + body});
    return texture;
}

}  // namespace burl
