// The gallery's list of presets: complete, in words, and found by them.
#include "app/recipe/preset_notes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "app/base/embedded.h"
#include "app/recipe/material_notes.h"

namespace burl {
namespace {

TEST(PresetNotes, TellOfEveryPresetOnce) {
    std::multiset<std::string> told, there;
    for (const PresetNote& note : preset_notes()) {
        told.emplace(note.name);
        EXPECT_TRUE(note.about.size() > 20 && note.about.ends_with(".")) << note.name;
    }
    for (const EmbeddedFile& file : embedded_recipes())
        there.emplace(file.name.substr(0, file.name.rfind('.')));
    EXPECT_EQ(told, there);
}

TEST(PresetNotes, AreFoundByNameAndSentenceInAnyCase) {
    EXPECT_EQ(presets_with("").size(), preset_notes().size() + material_notes().size());
    EXPECT_EQ(presets_with("").back().name, material_notes().back().name);
    EXPECT_TRUE(presets_with("no such thing").empty());
    const auto names = [](std::string_view text) {
        std::vector<std::string_view> found;
        for (const PresetNote& note : presets_with(text))
            if (std::ranges::count(preset_notes(), note.name, &PresetNote::name))
                found.push_back(note.name);
        return found;
    };
    EXPECT_EQ(names("ZONE"), std::vector<std::string_view>{"zoneplate"});
    EXPECT_EQ(names("copper"), std::vector<std::string_view>{"hammered"});
    EXPECT_GE(names("wood").size(), 4u);
}

}  // namespace
}  // namespace burl
