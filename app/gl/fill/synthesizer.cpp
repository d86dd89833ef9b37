#include "app/gl/fill/synthesizer.h"

#include <algorithm>
#include <chrono>
#include <optional>

#include <fmt/format.h>

#include "app/gl/fill/block_levels.h"
#include "app/gl/fill/multipass.h"
#include "app/pipeline/measure_synthesis.h"
#include "atlas/base/json.h"
#include "atlas/build/block_levels.h"

namespace burl {

namespace {

using Json = nlohmann::ordered_json;

class GlSynthesizer final : public TextureSynthesizer {
  public:
    explicit GlSynthesizer(std::unique_ptr<GlContext> context)
        : context_(std::move(context)), textures_(*context_) {}

    std::string problem(const Recipe& recipe) const override {
        if (recipe.precision.kind.value_or(PrecisionKind::float32) != PrecisionKind::float32)
            return "OpenGL computes in float32, and another precision is asked for";
        if (const Texture* texture = plain_texture(recipe.texture))
            return textures_.problem(*texture, recipe.filter);
        return textures_.problem(recipe.texture, recipe.filter);
    }

    void synthesize(const SolidAtlas& solid, const Recipe& recipe, int threads,
                    ImageToFill image) override {
        const Affine3 map = texture_from_solid(recipe);
        const Texture* texture = plain_texture(recipe.texture);
        std::visit(
            [&](auto* pixels) {
                if (texture)
                    textures_.synthesize(solid, *texture, map, threads, *pixels, recipe.filter);
                else
                    textures_.synthesize(solid, recipe.texture, map, threads, *pixels,
                                         recipe.filter);
            },
            image);
        sum_ += textures_.work();
    }

    std::vector<Image<RgbF>> levels(const MeshAtlas& atlas, const Image<RgbF>& texture,
                                    std::uint32_t count) override {
        // A level would need the whole texture at a time where tiles do not divide its side.
        if (texture.width() > std::size_t(largest_tile) &&
            texture.width() % std::size_t(largest_tile) != 0)
            return block_levels(atlas, texture, count);
        const auto start = std::chrono::steady_clock::now();
        context_->make_current();
        if (!levels_) levels_.emplace(*context_, atlas);
        std::vector<Image<RgbF>> result = (*levels_)(texture, count);
        sum_.passes += int(result.size());
        level_seconds_ +=
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        return result;
    }

    void forget_atlas() override {
        context_->make_current();
        textures_.forget_atlas();
        levels_.reset();
    }

    Json report() const override {
        return {{"by", context_->description()},
                {"passes", sum_.passes},
                {"maps", sum_.maps},
                {"seconds",
                 {{"compile", sum_.compile},
                  {"maps", sum_.map},
                  {"colors", sum_.colors},
                  {"draw", sum_.draw},
                  {"gpu", sum_.gpu},
                  {"transfer", sum_.transfer},
                  {"levels", level_seconds_}}}};
    }

  private:
    std::unique_ptr<GlContext> context_;
    GlSynthesis textures_;
    std::optional<GlBlockLevels> levels_;  ///< the levels of the current atlas
    GlWork sum_;
    double level_seconds_ = 0.0;  ///< compiling, drawing and transfer
};

const char* name_of(PassPrecision precision) {
    if (precision == PassPrecision::float16) return "16f";
    return precision == PassPrecision::fixed8 ? "8" : "32f";
}

const char* name_of(Randomizer randomizer) {
    if (randomizer == Randomizer::table) return "table";
    return randomizer == Randomizer::bits ? "bits" : "hash";
}

class GlMultipassSynthesizer final : public TextureSynthesizer {
  public:
    GlMultipassSynthesizer(std::unique_ptr<GlContext> context, const MultipassOptions& options)
        : context_(std::move(context)), textures_(*context_, options) {}

    std::string problem(const Recipe& recipe) const override {
        if (recipe.precision.kind.value_or(PrecisionKind::float32) != PrecisionKind::float32)
            return "--gl-precision says what the passes compute in, and the recipe has another "
                   "precision";
        const Texture* texture = plain_texture(recipe.texture);
        if (!texture)
            return "the papers' passes make no other textures than an opaque color_map over a "
                   "field";
        if (recipe.filter.kind != FilterKind::none || recipe.filter.band_limit)
            return "the papers' passes have no filters";
        return textures_.problem(*texture);
    }

    void synthesize(const SolidAtlas& solid, const Recipe& recipe, int threads,
                    ImageToFill image) override {
        std::visit(
            [&](auto* pixels) {
                textures_.synthesize(solid, *plain_texture(recipe.texture),
                                     texture_from_solid(recipe), threads, *pixels);
            },
            image);
        sum_ += textures_.work();
    }

    void forget_atlas() override {
        context_->make_current();
        textures_.forget_atlas();
    }

    Json report() const override {
        const MultipassOptions& options = textures_.options();
        return {{"by", context_->description()},
                {"precision", name_of(options.precision)},
                {"randomizer", name_of(options.randomizer)},
                {"equalized", options.equalize},
                {"passes", sum_.passes},
                {"octaves", octaves_json()},
                {"maps", sum_.maps},
                {"seconds",
                 {{"compile", sum_.compile},
                  {"maps", sum_.map},
                  {"draw", sum_.draw},
                  {"gpu", sum_.gpu},
                  {"transfer", sum_.transfer}}}};
    }

  private:
    /// The octaves of the last synthesis, finest first, in the order of their sum.
    Json octaves_json() const {
        const bool fixed = textures_.options().precision == PassPrecision::fixed8;
        Json octaves = Json::array();
        for (const MultipassOctave& octave : textures_.octaves()) {
            Json json = {{"seed", octave.seed},
                         {"passes", passes_of_octave(textures_.options(), octave)}};
            if (fixed)
                json["bits"] = fmt::format("{}.{}", octave.bits.integer, octave.bits.fraction());
            octaves.push_back(std::move(json));
        }
        return octaves;
    }

    std::unique_ptr<GlContext> context_;
    GlMultipassSynthesis textures_;
    GlWork sum_;
};

void check(const TextureSynthesizer& synthesizer, std::span<const Recipe> recipes) {
    for (const Recipe& recipe : recipes)
        if (const std::string why = synthesizer.problem(recipe); !why.empty())
            throw Error(ExitCode::unsupported,
                        fmt::format("--synth gl: {}; use --synth host", why));
}

bool all_possible(const TextureSynthesizer& synthesizer, std::span<const Recipe> recipes) {
    return std::ranges::all_of(
        recipes, [&](const Recipe& recipe) { return synthesizer.problem(recipe).empty(); });
}

}  // namespace

std::unique_ptr<TextureSynthesizer> make_gl_synthesizer(std::unique_ptr<GlContext> context) {
    return std::make_unique<GlSynthesizer>(std::move(context));
}

std::unique_ptr<TextureSynthesizer> choose_synthesizer(SynthesisChoice choice,
                                                       const std::string& platform,
                                                       std::span<const Recipe> recipes) {
    if (choice == SynthesisChoice::host) return nullptr;
    if (choice == SynthesisChoice::gl) {
        auto synthesizer = make_gl_synthesizer(create_gl_context(platform));
        check(*synthesizer, recipes);
        return synthesizer;
    }
    try {
        auto context = create_gl_context(platform);
        if (is_software(context->gl())) return nullptr;
        auto synthesizer = make_gl_synthesizer(std::move(context));
        if (recipes.empty() || !all_possible(*synthesizer, recipes)) return nullptr;
        const SynthesisSeconds seconds = measure_synthesis(*synthesizer, recipes[0]);
        return seconds.other < seconds.host ? std::move(synthesizer) : nullptr;
    } catch (const Error& error) {
        if (error.code() == ExitCode::usage) throw;
        return nullptr;  // OpenGL is not available
    }
}

std::unique_ptr<TextureSynthesizer> choose_multipass(const MultipassOptions& options,
                                                     const std::string& platform,
                                                     std::span<const Recipe> recipes) {
    auto synthesizer =
        std::make_unique<GlMultipassSynthesizer>(create_gl_context(platform), options);
    for (const Recipe& recipe : recipes)
        if (const std::string why = synthesizer->problem(recipe); !why.empty())
            throw Error(ExitCode::usage, fmt::format("--synth gl-multipass: {}", why));
    return synthesizer;
}

}  // namespace burl
