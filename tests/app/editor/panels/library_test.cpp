// What the library shows: everything once, by category, search and favourites.
#include "app/editor/panels/library.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "app/recipe/material_notes.h"
#include "app/recipe/preset_notes.h"

namespace burl {
namespace {

std::vector<std::string> names(const LibraryView& view,
                               const std::set<std::string>& favourites = {}) {
    std::vector<std::string> names;
    for (const LibraryEntry& entry : library_entries(view, favourites)) names.push_back(entry.name);
    return names;
}

TEST(Library, HasEveryMaterialAndPresetOnceByCategory) {
    const std::vector<LibraryEntry> all = library_entries({}, {});
    EXPECT_EQ(all.size(), material_notes().size() + preset_notes().size());
    const std::vector<std::string> categories = library_categories();
    std::size_t in_categories = 0;
    for (const std::string& category : categories) {
        const std::vector<LibraryEntry> some = library_entries({"", category, false}, {});
        EXPECT_FALSE(some.empty()) << category;
        for (const LibraryEntry& entry : some) EXPECT_EQ(entry.category, category);
        in_categories += some.size();
    }
    EXPECT_EQ(in_categories, all.size());
    std::set<std::string> distinct;
    for (const LibraryEntry& entry : all) distinct.insert(entry.name);
    EXPECT_EQ(distinct.size(), all.size());
    std::vector<std::string> in_order;
    for (const LibraryEntry& entry : all) in_order.push_back(entry.category);
    in_order.erase(std::unique(in_order.begin(), in_order.end()), in_order.end());
    EXPECT_EQ(in_order, categories) << "each category in one piece";
}

TEST(Library, IsSearchedByNameSentenceAndCategory) {
    EXPECT_EQ(names({"ZONEplate", "", false}), std::vector<std::string>{"zoneplate"});
    EXPECT_TRUE(names({"no such thing", "", false}).empty());
    EXPECT_TRUE(names({"zoneplate", "wood", false}).empty());
    const std::vector<std::string> wood = names({"", "wood", false}), found = names({"wood"});
    for (const std::string& name : wood) EXPECT_TRUE(std::ranges::count(found, name)) << name;
    EXPECT_GE(wood.size(), 4u);
}

TEST(Library, ShowsFavouritesAlone) {
    const std::set<std::string> favourites{"oak", "marble", "gone-since"};
    EXPECT_EQ(names({"", "", true}, favourites), (std::vector<std::string>{"oak", "marble"}));
    EXPECT_EQ(names({"", classics, true}, favourites), std::vector<std::string>{"marble"});
    EXPECT_TRUE(names({"", "", true}).empty());
}

}  // namespace
}  // namespace burl
