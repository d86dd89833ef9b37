#include "app/bake/texture.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <chrono>
#include <utility>

#include "app/bake/shared_pictures.h"
#include "app/base/messages.h"
#include "app/base/stopwatch.h"
#include "app/export/formats.h"
#include "app/image/exr_io.h"
#include "app/image/image_io.h"
#include "app/pipeline/material.h"
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
                fmt::format("--levels {}: must be a number of MIP levels, all, average, sharp or "
                            "direct",
                            text));
    }
    return kind == ImageKind::rgb_float && count > 0 ? all : std::min(count, all);
}

BakedImage synthesize(Pipeline& pipeline, ImageKind kind) {
    if (kind == ImageKind::rgb16) return pipeline.synthesize<Rgb16>();
    if (kind == ImageKind::rgb_float) return pipeline.synthesize<RgbF>();
    return pipeline.synthesize<Rgb8>();
}

/// The texture and its levels, made in bands: the whole float texture is never in memory.
template <class Pixel>
BakedTexture bake_in_bands(Pipeline& pipeline, ImageKind kind, const LevelsAsked& levels,
                           Image<Pixel> (*converted)(const Image<RgbF>&)) {
    const std::size_t size = pipeline.recipe().atlas.size;
    auto image = Image<Pixel>::unset(size, size);
    const auto take = [&](std::size_t first, const Image<RgbF>& rows) {
        std::ranges::copy(converted(rows).pixels(), &image(0, first));
    };
    std::vector<BakedImage> coarser =
        convert_to(pipeline.levels_in_bands(levels.count, levels.rule, take), kind);
    return {std::move(image), std::move(coarser)};
}

/// Seconds that the stages of synthesis, paint and levels have taken so far.
double stage_seconds(const Pipeline& pipeline) {
    double sum = 0.0;
    for (const Stage stage : {Stage::synthesis, Stage::paint, Stage::levels})
        sum += pipeline.records()[stage].seconds;
    return sum;
}

AtomicFile write_texture(Pipeline& pipeline, const std::string& path, const LevelsAsked& levels,
                         ExrDepth depth) {
    const std::size_t size = pipeline.recipe().atlas.size;
    const auto rows_to = [](const RowSink& sink) {
        return [&sink](std::size_t, const Image<RgbF>& rows) { sink(rows); };
    };
    if (levels.count == 0)
        return write_exr_rows(
            path, size, size,
            [&](const RowSink& sink) { pipeline.synthesize_in_bands(rows_to(sink)); }, depth);
    return write_exr_levels(
        path, size, size,
        [&](const RowSink& sink) {
            return pipeline.levels_in_bands(levels.count, levels.rule, rows_to(sink));
        },
        depth);
}

}  // namespace

LevelsAsked levels_asked(const std::string& text, const std::string& rule, std::uint32_t size,
                         ImageKind kind) {
    if (text.empty()) return {};
    const bool names_rule = text == "average" || text == "sharp" || text.starts_with("direct");
    const std::uint32_t all = size == 0 ? 0u : std::uint32_t(std::bit_width(size)) - 1;
    LevelsAsked asked;
    asked.rule = level_rule_named(names_rule ? text : rule.empty() ? "average" : rule);
    asked.count = names_rule ? all : count_asked(text, all, kind);
    if (names_rule && !rule.empty() && asked.rule != level_rule_named(rule))
        throw Error(ExitCode::usage, fmt::format("--levels {} and --level-rule {} are two rules, "
                                                 "give one of them",
                                                 text, rule));
    return asked;
}

LevelsAsked levels_there_are(Pipeline& pipeline, const LevelsAsked& asked, ImageKind kind) {
    const MeshAtlas& atlas = pipeline.mesh_atlas();
    const std::uint32_t last = last_level(atlas);
    if (asked.count <= last) return asked;
    const bool all = kind == ImageKind::rgb_float;
    warn(
        fmt::format("{}: MIP levels above {} of the {} atlas mix unrelated triangles and {}; "
                    "use --atlas chart, patch or quad for more",
                    pipeline.mesh().name, last, to_string(atlas.atlas().options.kind),
                    all ? "are of little use" : "are left out"));
    return {all ? asked.count : last, asked.rule};
}

NormalSpace normals_asked(const std::string& text, const Recipe& recipe,
                          const std::string& out_path) {
    if (text == "none") return NormalSpace::none;
    if (recipe.bump.empty()) {
        if (text.empty()) return NormalSpace::none;
        throw Error(
            ExitCode::usage,
            fmt::format("--normals {}: the recipe has no \"bump\" to make normals of; give it "
                        "one, such as --set 'bump.input={{\"node\": \"fbm\"}}'",
                        text));
    }
    if (text != "object") return NormalSpace::tangent;
    if (is_gltf(out_path))
        throw Error(ExitCode::usage,
                    fmt::format("{}: glTF knows normals in tangent space only; use --normals "
                                "tangent, or write a .png, .exr or .obj",
                                out_path));
    return NormalSpace::object;
}

BakedTexture bake_texture(Pipeline& pipeline, ImageKind kind, const LevelsAsked& levels) {
    if (levels.count == 0) return {synthesize(pipeline, kind)};
    const LevelsAsked known = levels_there_are(pipeline, levels, kind);
    const bool wanted = known.count > 0 && kind != ImageKind::rgb_float;
    if (wanted && comes_in_bands(pipeline, known))
        return kind == ImageKind::rgb8 ? bake_in_bands<Rgb8>(pipeline, kind, known, to_rgb8)
                                       : bake_in_bands<Rgb16>(pipeline, kind, known, to_rgb16);
    Image<RgbF> texture = pipeline.synthesize<RgbF>();
    std::vector<BakedImage> coarser =
        convert_to(pipeline.levels(texture, known.count, known.rule), kind);
    return {convert_to(std::move(texture), kind), std::move(coarser)};
}

std::optional<NormalMap> bake_normals(Pipeline& pipeline, NormalSpace space, int depth,
                                      double crease_degrees, std::span<const Recipe> recipes) {
    if (space == NormalSpace::none) return std::nullopt;
    const bool tangent = space == NormalSpace::tangent;
    const auto all = recipes.empty() ? std::span(&pipeline.recipe(), 1) : recipes;
    if (depth == 16)
        return NormalMap{shared_normals<Rgb16>(pipeline, all, crease_degrees, tangent), tangent};
    return NormalMap{shared_normals<Rgb8>(pipeline, all, crease_degrees, tangent), tangent};
}

void add_levels(NormalMap& map, const std::vector<Image<RgbF>>& levels) {
    for (const Image<RgbF>& level : levels) {
        if (std::holds_alternative<Image<Rgb16>>(map.image))
            map.levels.emplace_back(normal_codes16(level));
        else
            map.levels.emplace_back(normal_codes8(level));
    }
}

void encode_normals(const NormalMap& map, const PictureCoding& coding, const ByteSink& sink) {
    std::visit([&](const auto& image) { encode_picture(image, sink, coding, PngContent::data); },
               map.image);
}

void turn_green(NormalMap& map) {
    const auto turn = [](auto& image) {
        for (std::size_t y = 0; y < image.height(); ++y)
            for (auto& pixel : image.row(y)) pixel.g = static_cast<decltype(pixel.g)>(~pixel.g);
    };
    std::visit(turn, map.image);
    for (auto& level : map.levels) std::visit(turn, level);
}

BakedAtlas compressed_bake(const Atlas& atlas, BakedImage image,
                           const std::optional<double>& most_error) {
    if (!most_error) return {std::nullopt, std::move(image), std::nullopt};
    return std::visit(
        [&]<class Pixel>(const Image<Pixel>& picture) -> BakedAtlas {
            if constexpr (requires { Pixel::a; }) {
                throw Error(ExitCode::usage, "--compress: blocks with alpha are not compared yet");
            } else {
                auto result = compress_blocks(atlas, picture, *most_error);
                return {std::move(result.atlas), std::move(result.image), result.notes};
            }
        },
        image);
}

bool comes_in_bands(Pipeline& pipeline, const LevelsAsked& levels) {
    return pipeline.has_bands() && (levels.count == 0 || halves_in_bands(pipeline.mesh_atlas()));
}

BandsWritten write_exr_in_bands(Pipeline& pipeline, const std::string& path,
                                const LevelsAsked& asked, ExrDepth depth) {
    const LevelsAsked levels =
        asked.count > 0 ? levels_there_are(pipeline, asked, ImageKind::rgb_float) : asked;
    pipeline.solid();
    const auto start = std::chrono::steady_clock::now();
    const double before = stage_seconds(pipeline);
    AtomicFile file = write_texture(pipeline, path, levels, depth);
    const double stages = stage_seconds(pipeline) - before;
    return {levels.count, std::move(file), seconds_since(start) - stages};
}

}  // namespace burl
