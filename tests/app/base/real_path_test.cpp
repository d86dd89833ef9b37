// Names of files that are there, that are not, and of links.
#include "atlas/base/real_path.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

TEST(RealPath, SpellingsOfAMissingFileAreOne) {
    const std::string here = std::filesystem::current_path().string();
    for (const char* spelling : {"nothing.png", "./nothing.png", "missing/../nothing.png"})
        EXPECT_EQ(real_path(spelling), real_path(here) + "/nothing.png") << spelling;
}

TEST(RealPath, FollowsLinksOfFolders) {
    const ScratchFolder folder;
    namespace fs = std::filesystem;
    const fs::path real = fs::path(folder.path()) / "real", link = fs::path(folder.path()) / "link";
    fs::create_directories(real);
    fs::remove(link);
    fs::create_directory_symlink(real, link);
    EXPECT_EQ(real_path((link / "new.png").string()), real_path((real / "new.png").string()));
    EXPECT_NE(real_path((link / "new.png").string()), real_path((real / "other.png").string()));
}

}  // namespace
}  // namespace burl
