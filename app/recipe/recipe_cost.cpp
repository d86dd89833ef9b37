#include "app/recipe/recipe_cost.h"

#include "procedural/graph/noise_count.h"

namespace burl {

double noises_per_point(const Recipe& recipe, bool bumps) {
    const double height =
        bumps && !recipe.bump.empty() ? graph_cost(recipe.bump.input, GraphOutput::color) : 0.0;
    return graph_cost(recipe.texture, GraphOutput::planes) + height;
}

double noises_per_texel(const Recipe& recipe, bool bumps) {
    const bool samples = recipe.filter.kind == FilterKind::supersample;
    return noises_per_point(recipe, bumps) * (samples ? double(recipe.filter.samples) : 1.0);
}

double noises_of_texture(const Recipe& recipe, bool bumps) {
    return double(recipe.atlas.columns()) * double(recipe.atlas.rows()) *
           noises_per_texel(recipe, bumps);
}

}  // namespace burl
