#include "tests/fuzz/target.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include <fmt/format.h>

#include "atlas/base/error.h"
#include "tests/paths.h"

namespace burl::fuzz {
namespace {

namespace fs = std::filesystem;

/// A folder that is removed at the program's end.
class ScratchFolder {
  public:
    ScratchFolder() {
        std::string name = (fs::temp_directory_path() / "burl-fuzz-XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::runtime_error("no folder for scratch files");
        path_ = name;
    }
    ~ScratchFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

std::string content_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void add_contents(const fs::path& path, std::vector<std::string>& contents) {
    if (fs::is_regular_file(path)) contents.push_back(content_of(path));
    if (!fs::is_directory(path)) return;
    std::vector<fs::path> inside(fs::directory_iterator(path), {});
    std::ranges::sort(inside);
    for (const fs::path& one : inside)
        if (fs::is_regular_file(one)) contents.push_back(content_of(one));
}

}  // namespace

std::vector<Target> all_targets() {
    std::vector<Target> all;
    for (const auto& some :
         {mesh_targets, gltf_targets, recipe_targets, picture_targets, text_targets, soup_targets})
        std::ranges::move(some(), std::back_inserter(all));
    return all;
}

Target find_target(std::string_view name) {
    std::string names;
    for (const Target& target : all_targets()) {
        if (target.name == name) return target;
        names += fmt::format(" {}", target.name);
    }
    throw std::runtime_error(fmt::format("no target '{}'; there are{}", name, names));
}

void run(const Target& target, const std::string& bytes) {
    try {
        target.read(bytes);
    } catch (const Error&) {
    }
}

std::vector<std::string> first_inputs(const Target& target) {
    std::vector<std::string> contents;
    for (const std::string& seed : target.seeds)
        add_contents(fs::path(test::source_folder()) / seed, contents);
    add_contents(fs::path(test::source_folder()) / "tests/fuzz/corpus" / target.name, contents);
    if (target.made) std::ranges::move(target.made(), std::back_inserter(contents));
    std::erase_if(contents, [&](const auto& one) { return one.size() > target.most_bytes; });
    std::ranges::stable_sort(contents, {}, &std::string::size);
    return contents;
}

void require(bool holds, std::string_view sentence) {
    if (holds) return;
    fmt::print(stderr, "requirement not met: {}\n", sentence);
    std::abort();
}

std::string scratch_file(const std::string& name, const std::string& content) {
    static const ScratchFolder folder;
    const std::string path = (folder.path() / name).string();
    std::ofstream stream(path, std::ios::binary);
    stream.write(content.data(), std::streamsize(content.size()));
    stream.close();
    if (!stream) throw std::runtime_error("no room for scratch files");
    return path;
}

}  // namespace burl::fuzz
