#include "app/edit/marks.h"

#include <charconv>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "app/recipe/edit/controls.h"
#include "app/recipe/schema_check.h"
#include "app/recipe/spelling.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

constexpr const char* marks_key = "\x01";

/// The number of something that points at a place: an entry of a control, or a track of keys.
using Pointer = std::string;

Pointer pointer_of_entry(std::size_t control, std::size_t entry) {
    return fmt::format("c{}.{}", control, entry);
}
Pointer pointer_of_track(std::size_t track) {
    return fmt::format("t{}", track);
}

/// The item of an array or the value of an object; null where there is none.
Json* child_of(Json& json, const std::string& part) {
    if (json.is_object()) {
        const auto found = json.find(part);
        return found == json.end() ? nullptr : &*found;
    }
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), index);
    const bool is_index = error == std::errc() && end == part.data() + part.size();
    return json.is_array() && is_index && index < json.size() ? &json[index] : nullptr;
}

/// Marks the innermost object on a path with what points there, and the rest of the path; false
/// where there is none.
bool mark(Json& recipe, const std::string& path, const Pointer& pointer) {
    Json *at = &recipe, *object = nullptr;
    std::string rest;
    const auto parts = split_path(path);
    for (std::size_t i = 0; i < parts.size() && at; ++i) {
        at = child_of(*at, std::string(parts[i]));
        const bool part = i == 0 && parts[0] != "texture";  // "define", "material" or "bump"
        if (at && at->is_object() && !part) {
            object = at;
            rest.clear();
        } else {
            rest = join_path(rest, parts[i]);
        }
    }
    if (object) (*object)[marks_key].push_back({pointer, rest});
    return object != nullptr;
}

bool holds_graph(const std::string& key) {
    return key == "define" || key == "texture" || key == "material" || key == "bump";
}

/// The places of what is pointed at.
using Places = std::map<Pointer, std::vector<std::string>>;
using Before = std::map<Pointer, std::string>;

/// Takes the marks out of a value and all below it, and notes where they were.
void collect(Json& value, const std::string& path, Places& places) {
    if (value.is_object() && value.contains(marks_key)) {
        const Json marks = value[marks_key];
        value.erase(marks_key);
        for (const Json& one : marks) {
            const std::string rest = one[1].get<std::string>();
            places[one[0].get<std::string>()].push_back(rest.empty() ? path
                                                                     : join_path(path, rest));
        }
    }
    if (!value.is_structured()) return;
    for (auto& [key, item] : value.items()) collect(item, join_path(path, key), places);
}

/// Writes the constants below a value as bare numbers and colours, those of `nodes` alone excepted.
void contract(Json& value, bool nodes) {
    if (!value.is_structured()) return;
    for (auto& [key, item] : value.items()) {
        contract(item, false);
        if (!item.is_object() || !item.contains("node") || item["node"] != "constant") continue;
        const bool was_bare = item.erase(bare_key) > 0;
        if ((!nodes || was_bare) && item.contains("value")) item = Json(item["value"]);
    }
}

std::string name_of(const Json& control) {
    return control["name"].get<std::string>();
}

/// The paths that an entry of a control has now; those that lie in no graph are what they were.
std::vector<std::string> paths_now(const std::string& entry, const Pointer& pointer,
                                   const Before& before, const Places& now) {
    const auto [path, formula] = control_target(entry);
    if (!before.contains(pointer)) return {entry};
    const auto found = now.find(pointer);
    if (found == now.end()) return {};
    std::vector<std::string> entries;
    for (const std::string& place : found->second) {
        const bool same = place == before.at(pointer);
        entries.push_back(same              ? entry
                          : formula.empty() ? place
                                            : fmt::format("{} = {}", place, formula));
    }
    return entries;
}

void settle_controls(Json& recipe, const Before& before, const Places& now,
                     std::vector<std::string>& lost) {
    Json kept = Json::array();
    for (std::size_t i = 0; i < part_of(recipe, "controls").size(); ++i) {
        Json control = recipe["controls"][i];
        const Json old = std::exchange(control["sets"], Json::array());
        for (std::size_t k = 0; k < old.size(); ++k) {
            const auto paths = paths_now(old[k], pointer_of_entry(i, k), before, now);
            if (paths.empty() && k == 0) control["sets"] = nullptr;  // its own value is gone
            if (control["sets"].is_null()) break;
            for (const std::string& path : paths) control["sets"].push_back(path);
        }
        if (control["sets"].is_null())
            lost.push_back(fmt::format("the control \"{}\" went with its node", name_of(control)));
        else
            kept.push_back(std::move(control));
    }
    recipe.erase("controls");
    if (!kept.empty()) recipe["controls"] = std::move(kept);
}

void settle_tracks(Json& recipe, const Before& before, const Places& now,
                   std::vector<std::string>& lost) {
    if (!part_of(recipe, "animation").contains("tracks")) return;
    Json kept = Json::array();
    const Json tracks = recipe["animation"]["tracks"];
    for (std::size_t i = 0; i < tracks.size(); ++i) {
        const Pointer pointer = pointer_of_track(i);
        const auto found = now.find(pointer);
        if (!before.contains(pointer))
            kept.push_back(tracks[i]);
        else if (found == now.end())
            lost.push_back(fmt::format("the keys of {} went with its node",
                                       tracks[i]["path"].get<std::string>()));
        else
            for (const std::string& place : found->second) {
                kept.push_back(tracks[i]);
                kept.back()["path"] = place;
            }
    }
    recipe["animation"]["tracks"] = std::move(kept);
}

/// Calls point(path, pointer) for all paths of controls and keys that lie in graphs.
template <class Point>
void for_each_pointer(const Json& recipe, const Point& point) {
    const Json& controls = part_of(recipe, "controls");
    for (std::size_t i = 0; i < controls.size(); ++i)
        for (std::size_t k = 0; k < controls[i]["sets"].size(); ++k)
            point(respelled_path(control_target(controls[i]["sets"][k].get<std::string>()).path),
                  pointer_of_entry(i, k));
    const Json& animation = part_of(recipe, "animation");
    for (std::size_t i = 0; animation.contains("tracks") && i < animation["tracks"].size(); ++i)
        point(animation["tracks"][i]["path"].get<std::string>(), pointer_of_track(i));
}

/// The index after `front` in a path such as "controls.3.sets.1"; none where it begins otherwise.
std::optional<std::size_t> index_after(const std::string& path, const std::string& front) {
    if (!path.starts_with(front)) return {};
    std::size_t index = 0;
    const char* begin = path.data() + front.size();
    const auto [end, error] = std::from_chars(begin, path.data() + path.size(), index);
    if (error != std::errc()) return {};
    return index;
}

}  // namespace

PlaceMarks::PlaceMarks(Json& recipe) {
    for_each_pointer(recipe, [&](const std::string& path, const Pointer& pointer) {
        if (holds_graph(std::string(split_path(path)[0])) && mark(recipe, path, pointer))
            before_[pointer] = path;
    });
}

std::vector<std::string> PlaceMarks::settle(Json& recipe) const {
    Places now;
    for (auto& [key, part] : recipe.items()) {
        if (!holds_graph(key)) continue;
        collect(part, key, now);
        contract(part, key == "material");
        if (part.contains(bare_key)) part.erase(bare_key);
    }
    std::vector<std::string> lost;
    settle_controls(recipe, before_, now, lost);
    settle_tracks(recipe, before_, now, lost);
    return lost;
}

bool drop_misfit(Json& recipe, const std::string& path, std::vector<std::string>& lost) {
    if (const auto control = index_after(path, "controls.")) {
        Json& one = recipe["controls"][*control];
        const auto entry = index_after(path, fmt::format("controls.{}.sets.", *control));
        if (entry && *entry > 0) {
            lost.push_back(fmt::format("the control \"{}\" sets {} no more", name_of(one),
                                       one["sets"][*entry].get<std::string>()));
            one["sets"].erase(*entry);
        } else {
            lost.push_back(fmt::format("the control \"{}\" went with what it set", name_of(one)));
            recipe["controls"].erase(*control);
        }
        return true;
    }
    const auto track = index_after(path, "animation.tracks.");
    if (!track) return false;
    Json& tracks = recipe["animation"]["tracks"];
    lost.push_back(
        fmt::format("the keys of {} went with it", tracks[*track]["path"].get<std::string>()));
    tracks.erase(*track);
    return true;
}

void take_marks(Json& node, const Json& from) {
    if (from.contains(marks_key)) node[marks_key] = from[marks_key];
}

Json without_marks(Json node) {
    Places none;
    collect(node, "", none);
    contract(node, false);
    if (node.is_object()) node.erase(bare_key);
    return node;
}

}  // namespace burl
