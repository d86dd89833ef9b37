#include "app/editor/session/preferences.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

#include "app/base/atomic_file.h"
#include "app/base/file_bytes.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"

namespace burl {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::string_view, 2> themes{"dark", "light"};
constexpr double least_share = 0.05, largest_share = 0.95;

const Json& member(const Json& json, const std::string& key) {
    static const Json none;
    const bool has = json.is_object() && json.contains(key);
    return has ? json.at(key) : none;
}

/// Reads a share within its limits, or 0 where that is `automatic`; else leaves it.
void read_share(const Json& json, const std::string& key, double& share) {
    const Json& value = member(json, key);
    if (value.is_number()) share = std::clamp(value.get<double>(), least_share, largest_share);
}

/// Makes `file` what it is after the changes from `before` to `after`: keys that are the same in
/// both stay as they are.
void merge_changes(Json& file, const Json& before, const Json& after) {
    if (!file.is_object()) file = Json::object();
    for (const auto& [key, value] : before.items())
        if (!after.contains(key)) file.erase(key);
    for (const auto& [key, value] : after.items()) {
        const Json& old = member(before, key);
        if (value == old) continue;
        if (value.is_object())
            merge_changes(file[key], old.is_object() ? old : Json::object(), value);
        else
            file[key] = value;
    }
}

}  // namespace

Json to_json(const EditPreferences& preferences) {
    const EditPreferences usual;
    Json json = Json::object();
    if (preferences.theme != usual.theme) json["theme"] = themes[std::size_t(preferences.theme)];
    const auto share = [&](const char* key, double value, double normal) {
        if (value != normal) json["panes"][key] = value;
    };
    share("side", preferences.panes.side, usual.panes.side);
    share("atlas", preferences.panes.atlas, usual.panes.atlas);
    share("timeline", preferences.panes.timeline, usual.panes.timeline);
    share("graph", preferences.panes.graph, usual.panes.graph);
    for (const std::string& name : preferences.favourites) json["favourites"][name] = true;
    if (preferences.welcomed) json["welcomed"] = true;
    for (const auto& [mesh, axis] : preferences.up_axes) json["up"][mesh] = axis;
    return json;
}

EditPreferences preferences_from_json(const Json& json) {
    EditPreferences read;
    if (member(json, "theme") == themes[1]) read.theme = Theme::light;
    read_share(member(json, "panes"), "side", read.panes.side);
    read_share(member(json, "panes"), "atlas", read.panes.atlas);
    read_share(member(json, "panes"), "timeline", read.panes.timeline);
    read_share(member(json, "panes"), "graph", read.panes.graph);
    for (const auto& [name, on] : member(json, "favourites").items())
        if (on == true) read.favourites.insert(name);
    read.welcomed = member(json, "welcomed") == true;
    for (const auto& [mesh, axis] : member(json, "up").items())
        if (axis == "z" || axis == "-z") read.up_axes[mesh] = axis.get<std::string>();
    return read;
}

PreferenceFile::PreferenceFile(std::string file)
    : file_(std::move(file)), stored_(preferences_from_json(read())) {}

Json PreferenceFile::read() const {
    std::error_code unknown;
    if (file_.empty() || !fs::is_regular_file(file_, unknown)) return {};
    try {
        const auto bytes = read_file_bytes(file_);
        const Json json = parse_json_value(std::string(bytes.begin(), bytes.end()));
        return json.is_object() ? json : Json();
    } catch (const Error&) {  // it is unreadable, or was just removed
        return {};
    }
}

void PreferenceFile::store(const EditPreferences& now) {
    if (now == stored_) return;
    const EditPreferences before = std::exchange(stored_, now);
    if (file_.empty()) return;
    Json file = read();
    merge_changes(file, to_json(before), to_json(now));
    try {
        fs::create_directories(fs::path(file_).parent_path());
        write_file(file_, print_json(file));
    } catch (const std::exception&) {
        file_.clear();
    }
}

}  // namespace burl
