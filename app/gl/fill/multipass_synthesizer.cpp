#include "app/gl/fill/multipass_synthesizer.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/gl/fill/multipass_synthesize.h"

namespace burl {

namespace {

using Json = nlohmann::ordered_json;

const char* name_of(PassPrecision precision) {
    switch (precision) {
        case PassPrecision::float16:
            return "16f";
        case PassPrecision::fixed8:
            return "8";
        case PassPrecision::float32:
            break;
    }
    return "32f";
}

const char* name_of(Randomizer randomizer) {
    switch (randomizer) {
        case Randomizer::table:
            return "table";
        case Randomizer::bits:
            return "bits";
        case Randomizer::hash:
            break;
    }
    return "hash";
}

class GlMultipassSynthesizer final : public TextureSynthesizer {
  public:
    GlMultipassSynthesizer(std::unique_ptr<GlContext> context, const MultipassOptions& options)
        : context_(std::move(context)), textures_(*context_, options) {}

    std::string problem(const Recipe& recipe) const override {
        if (recipe.precision.kind.value_or(PrecisionKind::float32) != PrecisionKind::float32)
            return "--gl-precision says what the passes compute in, and the recipe has another "
                   "precision";
        if (recipe.filter.kind != FilterKind::none || recipe.filter.band_limit)
            return "the papers' passes have no filters";
        const Texture* texture = plain_texture(recipe.texture);
        return texture ? textures_.problem(*texture)
                       : "the papers' passes make no other textures than a color_map over a field";
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

}  // namespace

std::unique_ptr<TextureSynthesizer> make_multipass_synthesizer(std::unique_ptr<GlContext> context,
                                                               const MultipassOptions& options) {
    return std::make_unique<GlMultipassSynthesizer>(std::move(context), options);
}

std::unique_ptr<TextureSynthesizer> choose_multipass(const MultipassOptions& options,
                                                     const std::string& platform,
                                                     std::span<const Recipe> recipes) {
    auto synthesizer = make_multipass_synthesizer(create_gl_context(platform), options);
    for (const Recipe& recipe : recipes)
        if (const std::string why = synthesizer->problem(recipe); !why.empty())
            throw Error(ExitCode::usage, fmt::format("--synth gl-multipass: {}", why));
    return synthesizer;
}

}  // namespace burl
