// Every preset that is a graph, baked in float32 and in float64.
#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "app/base/embedded.h"
#include "app/bench/meshes.h"
#include "app/pipeline/pipeline.h"
#include "app/recipe/edit/recipe_json.h"

namespace burl {
namespace {

/// Over the texels that show the mesh, in linear light.
struct NearestErrors {
    double max = 0.0, rms = 0.0;
    int jumps = 0;  ///< texels more than 1e-3 apart, which do not count in the others
};

NearestErrors error_of(const SolidAtlas& solid, const Image<RgbF>& a, const Image<RgbF>& b) {
    NearestErrors error;
    double squares = 0.0, texels = 0.0;
    for (std::size_t y = 0; y < solid.size; ++y)
        for (const Span& span : solid.row(y))
            for (std::size_t x = span.x; x < span.x + span.count; ++x) {
                const RgbF &p = a(x, y), &q = b(x, y);
                const double away = std::max({std::abs(double(p.r) - double(q.r)),
                                              std::abs(double(p.g) - double(q.g)),
                                              std::abs(double(p.b) - double(q.b))});
                texels += 1.0;
                if (away > 1e-3) {
                    ++error.jumps;
                    continue;
                }
                error.max = std::max(error.max, away);
                squares += away * away;
            }
    error.rms = std::sqrt(squares / texels);
    return error;
}

TEST(GraphPresets, BakeInFloat32WhatTheyAreInFloat64) {
    Pipeline pipeline(torus(300));
    std::map<std::string, NearestErrors> errors;
    for (const EmbeddedFile& preset : embedded_recipes()) {
        const std::string name(preset.name.substr(0, preset.name.rfind('.')));
        const auto load = [&](const char* precision) {
            return load_recipe(name, {"atlas.size=96", "atlas.kind=area",
                                      std::string("precision.kind=") + precision});
        };
        const Recipe recipe = load("float32");
        if (plain_texture(recipe.texture)) continue;
        pipeline.set_recipe(recipe);
        const Image<RgbF> fast = pipeline.synthesize<RgbF>();
        pipeline.set_recipe(load("float64"));
        errors[name] = error_of(pipeline.solid(), fast, pipeline.synthesize<RgbF>());
    }
    EXPECT_GE(errors.size(), 15u);
    for (const auto& [name, error] : errors) {
        // Steep colours over quick noise; and where bumps and coasts jump, a texel may.
        const bool steep = name == "windy" || name == "sine-marble" || name == "cloudy-planet";
        EXPECT_LT(error.max, steep ? 2e-5 : 5e-6) << name;
        EXPECT_LT(error.rms, 1e-6) << name;
        // The torus touches the planes of the floor's checks, where rounding decides.
        EXPECT_LE(error.jumps, name == "checker-floor" ? 40 : 1) << name;
    }
}

}  // namespace
}  // namespace burl
