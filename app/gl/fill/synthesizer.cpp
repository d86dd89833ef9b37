#include "app/gl/fill/synthesizer.h"

#include <algorithm>
#include <chrono>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/gl/device/facts.h"
#include "app/gl/fill/block_levels.h"
#include "app/gl/fill/graph.h"
#include "app/pipeline/measure_synthesis.h"
#include "atlas/build/block_levels.h"

namespace burl {

namespace {

class GlSynthesizer final : public TextureSynthesizer {
  public:
    explicit GlSynthesizer(std::unique_ptr<GlContext> context)
        : context_(std::move(context)), textures_(*context_), graphs_(*context_) {}

    std::string problem(const Recipe& recipe) const override {
        if (recipe.precision.kind.value_or(PrecisionKind::float32) != PrecisionKind::float32)
            return "OpenGL computes in float32, and another precision is asked for";
        if (const Texture* texture = plain_texture(recipe.texture))
            return textures_.problem(*texture, recipe.filter);
        return graphs_.problem(recipe.texture, recipe.filter);
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
                    graphs_.synthesize(solid, recipe.texture, map, threads, *pixels, recipe.filter);
            },
            image);
        sum_ += texture ? textures_.work() : graphs_.work();
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
        graphs_.forget_atlas();
        levels_.reset();
    }

    nlohmann::ordered_json report() const override {
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
    GlGraphSynthesis graphs_;
    std::optional<GlBlockLevels> levels_;  ///< the levels of the current atlas
    GlWork sum_;
    double level_seconds_ = 0.0;  ///< compiling, drawing and transfer
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

}  // namespace burl
