// Every shortcut of the program stands in the list of keys (F1) and in the manual.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>
#include <set>

#include "app/base/file_bytes.h"
#include "app/editor/panels/panels.h"
#include "tests/paths.h"

namespace burl {
namespace {

std::string text_of(const std::filesystem::path& path) {
    const auto bytes = read_file_bytes(path.string());
    return {bytes.begin(), bytes.end()};
}

/// The shortcuts that the program's source asks for, in the words of the table of keys. Another
/// way of typing plus is none of its own.
std::set<std::string> shortcuts() {
    static const std::regex asks(R"re((?:pressed|[^A-Za-z_]on)\("([A-Z0-9][A-Za-z0-9+]*)")re");
    std::set<std::string> found;
    for (const auto& file : std::filesystem::recursive_directory_iterator(
             std::filesystem::path(test::source_folder()) / "app/editor")) {
        if (file.path().extension() != ".cpp") continue;
        const std::string text = text_of(file.path());
        for (std::sregex_iterator i(text.begin(), text.end(), asks), end; i != end; ++i)
            found.insert((*i)[1]);
    }
    found.erase("Ctrl+Shift+Plus");
    return found;
}

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

/// The keys of a line, in lower case; "arrows" are four.
void add_keys(std::string line, std::set<std::string>& keys) {
    static const std::regex parts(R"([,;] )");
    line = lower(std::move(line));
    for (std::sregex_token_iterator i(line.begin(), line.end(), parts, -1), end; i != end; ++i) {
        keys.insert(*i);
        if (*i == "arrows") keys.insert({"up", "down", "left", "right"});
    }
}

TEST(EditKeys, AreAllInTheListOfKeys) {
    std::set<std::string> listed;
    for (const KeyLine& line : keys_listed())
        if (line.does) add_keys(line.keys, listed);
    const std::set<std::string> asked = shortcuts();
    EXPECT_GT(asked.size(), 40u) << "the source is not read";
    for (const std::string& key : asked) EXPECT_TRUE(listed.contains(lower(key))) << key;
}

TEST(EditKeys, AreAllInTheManual) {
    const std::string manual =
        text_of(std::filesystem::path(test::source_folder()) / "docs/reference/editor.md");
    std::set<std::string> told;
    static const std::regex code(R"(`([^`]+)`)");
    for (std::sregex_iterator i(manual.begin(), manual.end(), code), end; i != end; ++i)
        told.insert(lower((*i)[1]));
    if (manual.find("arrows") != std::string::npos) told.insert({"up", "down", "left", "right"});
    for (const std::string& key : shortcuts()) EXPECT_TRUE(told.contains(lower(key))) << key;
}

}  // namespace
}  // namespace burl
