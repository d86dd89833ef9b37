// Preferences: what is read back, what of a damaged file is used, and two editors that write one
// file.
#include "app/editor/session/preferences.h"

#include <gtest/gtest.h>

#include "app/base/atomic_file.h"
#include "atlas/base/json.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

EditPreferences some() {
    EditPreferences some;
    some.theme = Theme::light;
    some.panes = {0.3, 0.25, 0.4};
    some.favourites = {"oak", "/home/me/ rock.json"};
    some.welcomed = true;
    some.up_axes = {{"/scan.ply", "z"}, {"/part.stl", "-z"}};
    return some;
}

TEST(EditPreferences, AreReadBackAsTheyWere) {
    EXPECT_EQ(preferences_from_json(to_json(some())), some());
    EXPECT_EQ(preferences_from_json(to_json(EditPreferences{})), EditPreferences{});
    EXPECT_TRUE(to_json(EditPreferences{}).empty()) << "nothing to say of a first start";
}

TEST(EditPreferences, WhatHasNoMeaningIsAsByDefault) {
    EXPECT_EQ(preferences_from_json(Json()), EditPreferences{});
    const Json damaged = Json::parse(R"({"theme": 7, "panes": {"side": "wide", "atlas": 12},
        "favourites": {"oak": true, "ash": "no"}, "welcomed": "yes", "up": {"a": "x", "b": "z"}})");
    EditPreferences expected;
    expected.panes.atlas = 0.95;  // within its limits
    expected.favourites = {"oak"};
    expected.up_axes = {{"b", "z"}};
    EXPECT_EQ(preferences_from_json(damaged), expected);
    EXPECT_EQ(preferences_from_json(Json::parse(R"({"favourites": [1], "up": 3, "panes": []})")),
              EditPreferences{});
}

TEST(PreferenceFile, KeepsThemForTheNextStart) {
    const ScratchFolder folder;
    PreferenceFile first(folder / "state/preferences.json");
    EXPECT_EQ(first.stored(), EditPreferences{});
    first.store(some());
    EXPECT_EQ(PreferenceFile(folder / "state/preferences.json").stored(), some());
}

TEST(PreferenceFile, TwoEditorsKeepEachOthersChanges) {
    const ScratchFolder folder;
    const std::string file = folder / "preferences.json";
    PreferenceFile(file).store(some());
    PreferenceFile one(file), other(file);
    EditPreferences ones = some(), others = some();
    ones.favourites.insert("slate");
    ones.theme = Theme::dark;
    one.store(ones);
    others.favourites.erase("oak");
    others.panes.side = 0.5;
    other.store(others);
    EditPreferences both = ones;
    both.favourites.erase("oak");
    both.panes.side = 0.5;
    EXPECT_EQ(PreferenceFile(file).stored(), both);
}

TEST(PreferenceFile, ADamagedOrMissingFileIsNoError) {
    const ScratchFolder folder;
    write_file(folder / "preferences.json", "{\"theme\": \"light\"");
    PreferenceFile damaged(folder / "preferences.json");
    EXPECT_EQ(damaged.stored(), EditPreferences{});
    damaged.store(some());
    EXPECT_EQ(PreferenceFile(folder / "preferences.json").stored(), some());
    write_file(folder / "a file", "");
    PreferenceFile unwritable(folder / "a file/preferences.json");
    unwritable.store(some());
    EXPECT_EQ(unwritable.stored(), some());
    PreferenceFile nameless("");
    nameless.store(some());
    EXPECT_EQ(nameless.stored(), some());
}

}  // namespace
}  // namespace burl
