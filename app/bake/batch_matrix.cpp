#include "app/bake/batch_matrix.h"

#include <glob.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string_view>

#include <fmt/format.h>

#include "atlas/base/error.h"

namespace burl {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 3> input_keys{"mesh", "recipe", "pose"};
constexpr std::array<std::string_view, 3> output_keys{"output", "solid-map", "emit-glsl"};

template <class Keys>
bool is_among(const Keys& keys, const std::string& key) {
    return std::ranges::find(keys, key) != keys.end();
}

/// The paths that match a pattern with `*` and `?`, relative ones from the folder on.
std::vector<std::string> matches_of(const std::string& pattern, const std::string& folder) {
    std::string whole;
    for (const char c : (fs::path(folder) / pattern).string())
        whole += c == '[' ? "[[]" : std::string(1, c);  // stands for itself
    glob_t found{};
    const int failed = ::glob(whole.c_str(), GLOB_NOESCAPE, nullptr, &found);
    const std::unique_ptr<glob_t, decltype(&globfree)> release(&found, globfree);
    if (failed != 0)
        throw Error(ExitCode::invalid_file, fmt::format("no file has such a name: {}", pattern));
    std::vector<std::string> paths;
    for (std::size_t i = 0; i < found.gl_pathc; ++i)
        paths.push_back(fs::absolute(found.gl_pathv[i]).string());
    return paths;
}

/// The elements that the value of a key stands for; one, itself, where it is no list or pattern.
Json elements_of(const std::string& key, const Json& value, const MatrixKeys& keys) {
    Json elements = Json::array();
    const auto add = [&](const Json& one) {
        const bool text = one.is_string() && is_among(input_keys, key);
        const std::string pattern = text ? one.get<std::string>() : "";
        if (pattern.find_first_of("*?") == std::string::npos || !keys.names_file(key, pattern))
            return elements.push_back(one);
        for (std::string& path : matches_of(pattern, keys.folder)) elements.push_back(path);
    };
    if (!value.is_array() || !keys.takes_one(key))
        add(value);
    else
        for (const Json& one : value) add(one);
    if (elements.empty())
        throw Error(ExitCode::invalid_file, fmt::format("'{}' is an empty list", key));
    return elements;
}

/// The value of a key as a part of a file's name.
std::string in_name(const std::string& key, const Json& value, const MatrixKeys& keys) {
    if (!value.is_string()) return value.dump();
    auto text = value.get<std::string>();
    if (const std::size_t hash = text.find(".mtlx#"); hash != std::string::npos)
        return text.substr(hash + 6);
    if (text.starts_with("sample:")) return text.substr(7);
    if (!keys.names_file(key, text)) return text;
    const std::string stem = fs::path(text).stem().string();
    if (stem == "." || stem == "..")
        throw Error(ExitCode::invalid_file,
                    fmt::format("{}: \"{}\" would be a folder in the output's name", text, stem));
    return stem;
}

/// The template with every {KEY} replaced.
std::string filled(const std::string& name, const Json& entry, const MatrixKeys& keys) {
    std::string result;
    for (std::size_t at = 0; at < name.size();) {
        const std::size_t begin = name.find('{', at), end = name.find('}', begin);
        result += name.substr(at, begin - at);
        if (begin == std::string::npos || end == std::string::npos) {
            if (begin != std::string::npos) result += name.substr(begin);
            break;
        }
        const std::string key = name.substr(begin + 1, end - begin - 1);
        if (!entry.contains(key) || entry[key].is_structured())
            throw Error(
                ExitCode::invalid_file,
                fmt::format("{}: the bake has no one value '{}' to put into the name", name, key));
        result += in_name(key, entry[key], keys);
        at = end + 1;
    }
    return result;
}

void fill_names(Json& entry, const MatrixKeys& keys) {
    for (const std::string_view key : output_keys) {
        const auto found = entry.find(std::string(key));
        if (found != entry.end() && found->is_string())
            *found = filled(found->get<std::string>(), entry, keys);
    }
}

}  // namespace

Combinations::Combinations(const Json& entry, const MatrixKeys& keys) : keys_(keys) {
    for (const auto& item : entry.items()) {
        axes_.emplace_back(item.key(), elements_of(item.key(), item.value(), keys));
        if (axes_.back().second.size() > most_combinations / count_)
            throw Error(ExitCode::invalid_file,
                        "its lists stand for more than 10^12 bakes; make them shorter");
        count_ *= axes_.back().second.size();
    }
}

Json Combinations::operator[](std::size_t i) const {
    Json bake = Json::object();
    std::size_t slower = count_;
    for (const auto& [key, elements] : axes_) {
        slower /= elements.size();
        bake[key] = elements[i / slower % elements.size()];
    }
    fill_names(bake, keys_);
    return bake;
}

}  // namespace burl
