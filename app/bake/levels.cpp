#include "app/bake/levels.h"

#include <algorithm>
#include <bit>
#include <charconv>

#include "app/base/messages.h"
#include "app/image/convert_image.h"
#include "atlas/base/error.h"
#include "atlas/build/block_levels.h"

namespace burl {

namespace {

/// Parses a number or "all" (`all` levels). Throws Error(usage).
std::uint32_t count_asked(const std::string& text, std::uint32_t all, ImageKind kind) {
    std::uint32_t count = all;
    if (text != "all") {
        const char* end = text.data() + text.size();
        const auto [stop, failure] = std::from_chars(text.data(), end, count);
        if (failure != std::errc() || stop != end)
            throw Error(
                ExitCode::usage,
                fmt::format("--levels {}: must be a number of MIP levels, all, average or direct",
                            text));
    }
    return kind == ImageKind::rgb_float && count > 0 ? all : std::min(count, all);
}

bool names_rule(const std::string& text) {
    return text == "average" || text.starts_with("direct");
}

}  // namespace

LevelsAsked levels_asked(const std::string& text, const std::string& rule, std::uint32_t size,
                         ImageKind kind) {
    if (text.empty()) return {};
    const std::uint32_t all = size == 0 ? 0u : std::uint32_t(std::bit_width(size)) - 1;
    LevelsAsked asked;
    asked.rule = level_rule_named(names_rule(text) ? text : rule.empty() ? "average" : rule);
    asked.count = names_rule(text) ? all : count_asked(text, all, kind);
    if (names_rule(text) && !rule.empty() && asked.rule != level_rule_named(rule))
        throw Error(ExitCode::usage, fmt::format("--levels {} and --level-rule {} are two rules, "
                                                 "give one of them",
                                                 text, rule));
    return asked;
}

BakedImage convert_to(Image<RgbF> image, ImageKind kind) {
    if (kind == ImageKind::rgb16) return to_rgb16(image);
    if (kind == ImageKind::rgb_float) return image;
    return to_rgb8(image);
}

std::uint32_t levels_there_are(Pipeline& pipeline, const LevelsAsked& asked, ImageKind kind) {
    const MeshAtlas& atlas = pipeline.mesh_atlas();
    const std::uint32_t last = last_level(atlas);
    if (asked.count <= last) return asked.count;
    const bool all = kind == ImageKind::rgb_float;
    warn(
        fmt::format("{}: MIP levels above {} of the {} atlas mix unrelated triangles and {}; "
                    "use --atlas quad or patch for more",
                    pipeline.mesh().name, last, to_string(atlas.atlas().options.kind),
                    all ? "are of little use" : "are left out"));
    return all ? asked.count : last;
}

std::vector<BakedImage> bake_levels(Pipeline& pipeline, const Image<RgbF>& texture,
                                    const LevelsAsked& asked, ImageKind kind) {
    const std::uint32_t count = levels_there_are(pipeline, asked, kind);
    return convert_to(pipeline.levels(texture, count, asked.rule), kind);
}

std::vector<BakedImage> convert_to(std::vector<Image<RgbF>> levels, ImageKind kind) {
    std::vector<BakedImage> result;
    for (Image<RgbF>& level : levels) {
        result.push_back(convert_to(std::move(level), kind));
        level = {};
    }
    return result;
}

}  // namespace burl
