#pragma once
// A material like oak, built from nothing in fourteen steps.
#include <string>
#include <utility>

#include "app/edit/lists.h"
#include "app/edit/steps.h"

namespace burl::test {

struct BuiltRecipe {
    Recipe recipe;
    int steps = 0;
};

/// The steps of docs/images/editor-oak.json, which plays them by pointer and keys.
inline BuiltRecipe built_oak(const Recipe& like) {
    BuiltRecipe oak{new_recipe(like)};
    const auto take = [&](GraphEdit edit) {
        oak.recipe = std::move(edit.recipe);
        ++oak.steps;
    };
    const auto add = [&](const std::string& place, const std::string& text) {
        take(add_node(oak.recipe, place, text));
    };
    add("texture", R"(color_map stops=[[0,"#a47747"],[0.42,"#c69d69"],[1,"#a37746"]])");
    add("texture.input", "fract");
    add("texture.input.input", "add");
    add("texture.input.input.a", "multiply b=18");
    add("texture.input.input.a.a", "distance weights=[1,1,0]");
    add("texture.input.input.b", "transform scale=[2.4,2.4,0.3]");
    add("texture.input.input.b.input", "fbm octaves=3 seed=6");
    take(add_layer(oak.recipe, "texture", "multiply"));
    add("texture.mask", "smoothstep low=0.1 high=0.4");
    add("texture.mask.input", "fibre length=0.2 width=0.01 octaves=2 seed=41");
    take(name_node(oak.recipe, "texture.mask", "pores"));
    take(add_channel(oak.recipe, "roughness"));
    add("material.roughness", "mix a=0.4 b=0.8");
    take(connect(oak.recipe, "define.pores", "material.roughness.amount"));
    return oak;
}

}  // namespace burl::test
