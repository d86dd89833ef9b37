#include "app/bake/batch_manifest.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include <CLI/CLI.hpp>

#include "app/bake/batch_matrix.h"
#include "app/base/file_bytes.h"
#include "app/base/messages.h"
#include "app/recipe/presets.h"
#include "app/recipe/recipe.h"
#include "app/recipe/spelling.h"
#include "app/surface/sample_meshes.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "atlas/base/named_files.h"

namespace burl {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view entries_key = "bakes", defaults_key = "defaults";

/// The lines, counted from 1, of all objects and arrays in the root's array `entries_key`, in JSON
/// text that has been parsed before.
class EntryLines {
  public:
    explicit EntryLines(std::string_view text) {
        for (std::size_t i = 0; i < text.size(); ++i) {
            if (text[i] == '\n') ++line_;
            if (text[i] == '"')
                i = skip_string(text, i);
            else
                step(text[i]);
        }
    }
    const std::vector<std::size_t>& lines() const { return lines_; }

  private:
    /// The index of the quote that ends the string which begins at index `begin`.
    std::size_t skip_string(std::string_view text, std::size_t begin) {
        std::size_t end = begin + 1;
        while (text[end] != '"') end += text[end] == '\\' ? 2 : 1;
        if (depth_ == 1) last_string_ = text.substr(begin, end + 1 - begin);
        return end;
    }
    void step(char c) {
        // Keys are parsed, since they may be written with escapes.
        if (c == '[' && depth_ == 1)
            inside_ = Json::parse(last_string_).get<std::string>() == entries_key;
        if ((c == '{' || c == '[') && ++depth_ == 3 && inside_) lines_.push_back(line_);
        if (c == '}' || c == ']') --depth_;
        if (c == ']' && depth_ == 1) inside_ = false;
    }

    std::size_t line_ = 1;
    int depth_ = 0;
    bool inside_ = false;
    std::string_view last_string_;  // the last string at depth 1, with its quotes
    std::vector<std::size_t> lines_;
};

/// The folder that a manifest's paths start at, and where they may lead.
struct PathRule {
    fs::path folder{};
    NamedFiles named = NamedFiles::anywhere;

    /// The path from the folder on. Throws Error(invalid_file) for one that may not be.
    std::string operator()(const std::string& path) const {
        if (!may_name(named, (folder / "").string(), path))
            throw Error(ExitCode::invalid_file, fmt::format("{} {}", path, outside_rule));
        return (folder / path).string();
    }
};

/// Whether the value of `key` is a path, not a preset or a sample mesh.
bool names_file(const std::string& key, const std::string& value) {
    if (key == "mesh") return !is_sample_mesh(value);
    if (key == "pose") return is_pose_file(value) && !is_sample_mesh(value);
    if (key == "recipe") return !names_preset(value);
    return key == "output" || key == "solid-map" || key == "emit-glsl";
}

Error wrong_value(const std::string& key) {
    return Error(ExitCode::invalid_file,
                 fmt::format("'{}' must be a text, a number, true, false or a list of these", key));
}

/// The value as text of the command line, with paths by the rule. Throws Error(invalid_file) if the
/// value is no text or number, or a path that may not be.
std::string text_of(const std::string& key, const Json& value, const PathRule& rule) {
    if (value.is_number()) return value.dump();
    if (!value.is_string()) throw wrong_value(key);
    const auto text = value.get<std::string>();
    const std::size_t at = key == "assign" ? text.find('=') + 1 : 0;
    const std::string path = text.substr(at);
    return names_file(at > 0 ? "recipe" : key, path) ? text.substr(0, at) + rule(path) : text;
}

/// Whether `key` is an option of `burl batch` itself that `burl bake` has, too.
bool is_of_batch(const std::string& key) {
    CLI::App options;
    BakeCommand command;
    add_run_options(options, command);
    add_report_options(options, command);
    return options.get_option_no_throw("--" + key) != nullptr;
}

/// Throws Error(invalid_file) if `burl bake` has no option `key` for one bake among several.
void check_key(const CLI::App& options, const std::string& key) {
    if (key == "mesh" || options.get_option_no_throw("--" + key)) return;
    if (is_of_batch(key))
        throw Error(ExitCode::invalid_file,
                    fmt::format("'{0}' is asked of the whole batch: burl batch --{0}", key));
    std::vector<std::string> names;
    for (const CLI::Option* option : options.get_options())
        names.push_back(option->get_single_name());
    const std::string_view near = nearest_word(key, names);
    throw Error(ExitCode::invalid_file,
                fmt::format("there is no option '{}'{}", key,
                            near.empty() ? "" : fmt::format("; did you mean '{}'?", near)));
}

/// Adds the option `key` with its value, or one option for each element of a list.
void add_argument(const std::string& key, const Json& value, const PathRule& rule,
                  std::vector<std::string>& arguments) {
    if (value.is_array()) {
        for (const Json& one : value) {
            if (one.is_structured() || one.is_null()) throw wrong_value(key);
            add_argument(key, one, rule, arguments);
        }
    } else if (value.is_boolean()) {
        if (value.get<bool>()) arguments.push_back("--" + key);
    } else if (key == "mesh") {
        arguments.push_back(text_of(key, value, rule));
    } else {
        arguments.push_back(fmt::format("--{}={}", key, text_of(key, value, rule)));
    }
}

/// How the keys of entries are to be understood.
MatrixKeys matrix_keys(const fs::path& folder) {
    const auto options = std::make_shared<CLI::App>();
    const auto command = std::make_shared<BakeCommand>();
    add_bake_options(*options, *command);
    const auto takes_one = [options, command](const std::string& key) {
        const CLI::Option* option = options->get_option_no_throw("--" + key);
        return key == "mesh" || (option && option->get_expected_max() <= 1);
    };
    return {takes_one, names_file, folder.string()};
}

/// Parses the entry as arguments of `burl bake`. Throws Error(invalid_file) or CLI::ParseError.
void parse_entry(const Json& entry, const PathRule& rule, BatchEntry& result) {
    CLI::App options;
    options.set_help_flag();
    add_bake_options(options, result.command);
    std::vector<std::string> arguments;
    for (const auto& item : entry.items()) {
        check_key(options, item.key());
        add_argument(item.key(), item.value(), rule, arguments);
    }
    std::ranges::reverse(arguments);  // CLI11 takes arguments in reverse order
    options.parse(std::move(arguments));
    result.settings = bake_settings(options);
}

/// The edits of the recipe (`set`): those of the defaults whose path the entry does not set, then
/// the entry's.
Json joined_edits(const Json& defaults, const Json& entry) {
    const auto list = [](const Json& value) { return value.is_array() ? value : Json{value}; };
    const Json own = list(entry);
    const auto path = [](const Json& edit) {
        const std::string text = edit.is_string() ? edit.get<std::string>() : "";
        return respelled_path(text.substr(0, text.find('=')));
    };
    Json edits = Json::array();
    for (const Json& edit : list(defaults))
        if (std::ranges::find(own, path(edit), path) == own.end()) edits.push_back(edit);
    edits.insert(edits.end(), own.begin(), own.end());
    return edits;
}

/// The defaults, overridden by the entry's values; edits of the recipe (`set`) are joined, and the
/// value null removes a default.
Json with_defaults(const Json& defaults, const Json& entry) {
    Json merged = defaults;
    for (const auto& item : entry.items()) {
        if (item.value().is_null())
            merged.erase(item.key());
        else if (item.key() == "set" && merged.contains("set"))
            merged["set"] = joined_edits(merged["set"], item.value());
        else
            merged[item.key()] = item.value();
    }
    return merged;
}

/// One bake with its place in the manifest; errors are stored in it.
BatchEntry read_bake(const Json& bake, const PathRule& rule, const std::string& place) {
    BatchEntry result;
    result.where = place;
    if (bake.contains("output") && bake["output"].is_string())
        result.where += fmt::format(" ({})", bake["output"].get<std::string>());
    try {
        parse_entry(bake, rule, result);
    } catch (const Error& error) {
        result.wrong = error.what();
    } catch (const CLI::ParseError& error) {
        result.wrong = error.what();
    }
    return result;
}

/// An entry of the manifest with its place; without combinations it is wrong.
struct ManifestEntry {
    std::string where;
    std::optional<Combinations> bakes{};
    std::string wrong{};

    std::size_t count() const { return bakes ? bakes->count() : 1; }
};

/// An entry with its place `where`; its own error is stored in it.
ManifestEntry manifest_entry(const Json& entry, const Json& defaults, const MatrixKeys& keys,
                             std::string where) {
    ManifestEntry result{std::move(where)};
    try {
        if (!entry.is_object())
            throw Error(ExitCode::invalid_file,
                        "an entry must be an object such as "
                        R"({"mesh": "a.obj", "output": "a.png"})");
        result.bakes.emplace(with_defaults(defaults, entry), keys);
    } catch (const Error& error) {
        result.wrong = error.what();
    }
    return result;
}

/// The bake number i of an entry.
BatchEntry bake_of(const ManifestEntry& entry, std::size_t i, const PathRule& rule,
                   const std::string& place) {
    try {
        if (entry.bakes) return read_bake((*entry.bakes)[i], rule, place);
        return {place, {}, {}, entry.wrong};
    } catch (const Error& error) {
        return {place, {}, {}, error.what()};
    }
}

/// The most bakes of one command: each takes some 6 kB before it begins.
constexpr std::size_t most_bakes = 100'000;

/// The bakes of the entries that are in the shard, up to the wrong one number most_wrong_bakes.
/// Throws Error(unsupported) for too many.
std::vector<BatchEntry> bakes_of(const std::vector<ManifestEntry>& entries, const PathRule& rule,
                                 const BatchShard& shard) {
    std::size_t count = 0;
    for (const ManifestEntry& entry : entries) count += entry.count();
    if (shard.last(count) - shard.first(count) > most_bakes)
        throw Error(ExitCode::unsupported,
                    fmt::format("that are {} bakes, and {} are the most at a time; share them out "
                                "with --shard",
                                shard.last(count) - shard.first(count), most_bakes));
    std::vector<BatchEntry> bakes;
    std::size_t begin = 0, wrong = 0;  // of the entry's bakes among all; of those so far
    for (const ManifestEntry& entry : entries) {
        const std::size_t first = std::max(begin, shard.first(count)),
                          last = std::min(begin + entry.count(), shard.last(count));
        for (std::size_t i = first; i < last && wrong < most_wrong_bakes; ++i) {
            bakes.push_back(
                bake_of(entry, i - begin, rule, fmt::format("{}: bake {}", entry.where, i + 1)));
            wrong += !bakes.back().wrong.empty();
        }
        begin += entry.count();
    }
    return bakes;
}

std::vector<std::uint8_t> read_stdin() {
    return {std::istreambuf_iterator<char>(std::cin), {}};
}

/// Throws Error(invalid_file) if the manifest is not an object with a list of bakes.
void check_manifest(const Json& manifest, const std::string& path) {
    const auto fail = [&](const std::string& message) { throw invalid_file(path, 1, message); };
    if (!manifest.is_object() || !manifest.contains(entries_key))
        fail(R"(a manifest is an object with a list "bakes")");
    for (const auto& item : manifest.items())
        if (item.key() != entries_key && item.key() != defaults_key)
            fail(fmt::format(R"(unknown key "{}"; there are "defaults" and "bakes")", item.key()));
    if (!manifest[std::string(entries_key)].is_array()) fail(R"("bakes" must be a list)");
    if (manifest[std::string(entries_key)].empty()) fail(R"("bakes" is empty)");
    if (!manifest.value(defaults_key, Json::object()).is_object())
        fail(R"("defaults" must be an object)");
}

}  // namespace

BatchShard batch_shard(const std::string& text) {
    if (text.empty()) return {};
    std::size_t part = 0, parts = 0;
    const char *begin = text.data(), *end = begin + text.size();
    const auto [slash, first] = std::from_chars(begin, end, part);
    const bool has_slash = first == std::errc() && slash != end && *slash == '/';
    const auto [stop, second] = std::from_chars(has_slash ? slash + 1 : end, end, parts);
    if (!has_slash || second != std::errc() || stop != end || part < 1 || part > parts)
        throw Error(ExitCode::usage,
                    fmt::format("--shard {}: must be I/N, part I of N, as 1/10", text));
    return {part - 1, parts};
}

std::vector<BatchEntry> read_manifest(const std::string& path, const BatchShard& shard,
                                      NamedFiles named) {
    const std::vector<std::uint8_t> bytes = path == "-" ? read_stdin() : read_file_bytes(path);
    const std::string text(bytes.begin(), bytes.end());
    const Json manifest = parse_json_text(text, path);
    check_manifest(manifest, path);
    const Json defaults = manifest.value(defaults_key, Json::object());
    const EntryLines entries(text);
    const MatrixKeys keys = matrix_keys(fs::path(path).parent_path());
    std::vector<ManifestEntry> result;
    // An entry that is neither object nor array has the line of the last one that is.
    std::size_t objects = 0, line = 1;
    for (const Json& entry : manifest[std::string(entries_key)]) {
        if (entry.is_structured()) line = entries.lines()[objects++];
        result.push_back(manifest_entry(entry, defaults, keys, fmt::format("{}:{}", path, line)));
    }
    // What comes on stdin is the caller's own word, as a command line is.
    const NamedFiles leads = path == "-" ? NamedFiles::anywhere : named;
    return bakes_of(result, {keys.folder, leads}, shard);
}

std::vector<BatchEntry> matrix_of_options(const std::vector<std::string>& meshes,
                                          const std::vector<std::string>& options,
                                          const BatchShard& shard) {
    Json entry = Json::object();
    entry["mesh"] = meshes;
    for (const std::string& option : options) {
        const std::size_t at = option.find('=');
        Json& values = entry[option.substr(0, at)];
        values.push_back(at == std::string::npos ? Json(true) : Json(option.substr(at + 1)));
    }
    const MatrixKeys keys = matrix_keys({});
    for (auto& [key, values] : entry.items())  // templates are of texts
        if (values.is_array() && values.size() == 1) values = Json(values[0]);
    std::vector<ManifestEntry> entries;
    entries.push_back(manifest_entry(entry, Json::object(), keys, "command line"));
    return bakes_of(entries, {keys.folder}, shard);
}

}  // namespace burl
