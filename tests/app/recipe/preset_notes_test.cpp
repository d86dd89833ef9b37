// The gallery's list of presets: complete, in words, and found by them.
#include "app/recipe/preset_notes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "app/base/embedded.h"

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

TEST(PresetNotes, TextsAreSearchedInAnyCase) {
    EXPECT_TRUE(holds_text("zoneplate", "ZONE"));
    EXPECT_TRUE(holds_text("Copper with the dents of a hammer.", "copper"));
    EXPECT_TRUE(holds_text("", ""));
    EXPECT_FALSE(holds_text("wood", "woods"));
    EXPECT_FALSE(holds_text("", "a"));
}

}  // namespace
}  // namespace burl
