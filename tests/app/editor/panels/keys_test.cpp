// Every shortcut of the program stands in the list of keys (F1) and in the manual.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>

#include "app/base/file_bytes.h"
#include "app/editor/panels/panels.h"
#include "tests/paths.h"

namespace burl {
namespace {

std::string text_of(const std::filesystem::path& path) {
    const auto bytes = read_file_bytes(path.string());
    return {bytes.begin(), bytes.end()};
}

bool is_letter(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Adds the keys of calls such as pressed("Ctrl+S") and on("Ctrl+S") in a source.
void add_asked(const std::string& text, std::set<std::string>& keys) {
    for (const std::string_view call : {"pressed(\"", "on(\""})
        for (auto at = text.find(call); at != std::string::npos; at = text.find(call, at + 1)) {
            if (call.starts_with("on") && at > 0 && is_letter(text[at - 1])) continue;
            const std::size_t from = at + call.size(), to = text.find('"', from);
            const std::string key = text.substr(from, to - from);
            const bool is_key = std::ranges::all_of(
                key, [](unsigned char c) { return std::isalnum(c) != 0 || c == '+'; });
            if (!key.empty() && is_key && std::islower(static_cast<unsigned char>(key[0])) == 0)
                keys.insert(key);
        }
}

/// The shortcuts that the program's source asks for, in the words of the table of keys. Another
/// way of typing plus is none of its own.
std::set<std::string> shortcuts() {
    std::set<std::string> found;
    for (const auto& file : std::filesystem::recursive_directory_iterator(
             std::filesystem::path(test::source_folder()) / "app/editor")) {
        if (file.path().extension() != ".cpp") continue;
        add_asked(text_of(file.path()), found);
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
    line = lower(std::move(line)) + ", ";
    for (std::size_t from = 0, to = 0; from < line.size(); from = to + 2) {
        to = std::min(line.find(", ", from), line.find("; ", from));
        const std::string key = line.substr(from, to - from);
        keys.insert(key);
        if (key == "arrows") keys.insert({"up", "down", "left", "right"});
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
    for (auto at = manual.find('`'); at != std::string::npos;) {
        const std::size_t end = manual.find('`', at + 1);
        if (end == std::string::npos) break;
        told.insert(lower(manual.substr(at + 1, end - at - 1)));
        at = manual.find('`', end + 1);
    }
    if (manual.find("arrows") != std::string::npos) told.insert({"up", "down", "left", "right"});
    for (const std::string& key : shortcuts()) EXPECT_TRUE(told.contains(lower(key))) << key;
}

}  // namespace
}  // namespace burl
