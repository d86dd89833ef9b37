#include "app/recipe/material_notes.h"

#include <algorithm>
#include <tuple>
#include <vector>

#include "app/base/json_text.h"
#include "app/recipe/presets.h"
#include "app/recipe/recipe.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

auto shown_order(const MaterialNote& note) {
    return std::tuple(std::ranges::find(material_groups, note.group), note.group, note.name);
}

std::vector<MaterialNote> make_notes() {
    std::vector<MaterialNote> all;
    for (const std::string_view material : material_names()) {
        const std::string name(material);
        const Json json = parse_json_text(recipe_text(name).json, name);
        all.push_back({name, json.value("group", ""), json.value("about", "")});
    }
    std::ranges::sort(all, {}, shown_order);
    return all;
}

}  // namespace

std::span<const MaterialNote> material_notes() {
    static const std::vector<MaterialNote> all = make_notes();
    return all;
}

}  // namespace burl
