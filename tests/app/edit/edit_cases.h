#pragma once
// Recipes that tests of building begin with, and what they do with them.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/edit/graph_edit.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/presets.h"
#include "app/recipe/recipe.h"
#include "atlas/base/error.h"

namespace burl::test {

/// A recipe of these parts.
inline Recipe recipe_with(const std::string& parts) {
    return parse_recipe(R"({"burl": 1, "name": "test", )" + parts + "}", "test");
}

/// A material with nothing built yet.
inline Recipe empty_recipe() {
    return recipe_with(R"("texture": {"node": "constant", "value": "#808080"})");
}

/// The sentence that a step is refused with; empty where it is not.
template <class Step>
std::string refusal(const Step& step) {
    try {
        (void)step();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::usage);
        EXPECT_FALSE(std::string(error.what()).empty());
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        return error.what();
    }
    return "";
}

/// The presets and materials of the program.
inline std::vector<std::string> all_recipes() {
    std::vector<std::string> names;
    for (const std::string_view name : preset_names()) names.emplace_back(name);
    for (const std::string_view name : material_names()) names.emplace_back(name);
    return names;
}

}  // namespace burl::test
