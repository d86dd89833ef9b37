#include "app/editor/session/input.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "atlas/base/error.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

// The names of the InputKinds, in order.
constexpr std::array<std::string_view, 8> event_names{"move", "button", "wheel",  "key",
                                                      "text", "drop",   "resize", "close"};

Json pair_json(const glm::dvec2& v) {
    return Json::array({v.x, v.y});
}

bool down_from(const Json& json, const std::string& place) {
    if (!json.contains("down") || !json["down"].is_boolean())
        refuse_input(place, "down", "true or false");
    return json["down"].get<bool>();
}

std::vector<std::string> files_from(const Json& json, const std::string& place) {
    if (!json.is_array()) refuse_input(place, "drop", "a list of files");
    std::vector<std::string> files;
    for (const Json& file : json) files.push_back(input_text(file, place, "drop"));
    return files;
}

bool is_modifier(const std::string& key) {
    return key == "Ctrl" || key == "Shift" || key == "Alt";
}

/// Whether `next` may be in the same frame as `first`, an earlier event.
bool go_together(const InputEvent& first, const InputEvent& next) {
    switch (next.kind) {
        case InputKind::move:
        case InputKind::wheel:
            return first.kind != InputKind::button;
        case InputKind::button:
            return first.kind != InputKind::button && first.kind != InputKind::move;
        case InputKind::key:
            return first.kind != InputKind::button &&
                   !(first.kind == InputKind::key &&
                     (first.text == next.text ||
                      (is_modifier(next.text) && first.down && !is_modifier(first.text))));
        case InputKind::text:
        case InputKind::drop:
        case InputKind::resize:
        case InputKind::close:
            break;
    }
    return true;
}

}  // namespace

void refuse_input(const std::string& place, const std::string& key, const char* wanted) {
    throw invalid_file(place, 0, fmt::format("\"{}\" must be {}", key, wanted));
}

glm::dvec2 input_pair(const Json& json, const std::string& place, const std::string& key) {
    if (!json.is_array() || json.size() != 2 || !json[0].is_number() || !json[1].is_number())
        refuse_input(place, key, "two numbers");
    return {json[0].get<double>(), json[1].get<double>()};
}

std::string input_text(const Json& json, const std::string& place, const std::string& key) {
    if (!json.is_string()) refuse_input(place, key, "a string");
    return json.get<std::string>();
}

Json to_json(const InputEvent& event) {
    const std::string key(event_names[std::size_t(event.kind)]);
    switch (event.kind) {
        case InputKind::move:
        case InputKind::wheel:
        case InputKind::resize:
            return {{key, pair_json(event.at)}};
        case InputKind::button:
            return {{key, event.button}, {"down", event.down}};
        case InputKind::key:
            return {{key, event.text}, {"down", event.down}};
        case InputKind::text:
            return {{key, event.text}};
        case InputKind::drop:
            return {{key, event.files}};
        case InputKind::close:
            break;
    }
    return {{key, true}};
}

InputEvent input_from_json(const Json& json, const std::string& place) {
    for (std::size_t k = 0; k < event_names.size(); ++k) {
        const std::string key(event_names[k]);
        if (!json.is_object() || !json.contains(key)) continue;
        const Json& value = json[key];
        InputEvent event{InputKind(k)};
        switch (event.kind) {
            case InputKind::move:
            case InputKind::wheel:
            case InputKind::resize:
                event.at = input_pair(value, place, key);
                break;
            case InputKind::button:
                if (!value.is_number_integer() || value < 0 || value > 2)
                    refuse_input(place, key, "0, 1 or 2");
                event.button = value.get<int>();
                event.down = down_from(json, place);
                break;
            case InputKind::key:
                event.text = input_text(value, place, key);
                event.down = down_from(json, place);
                break;
            case InputKind::text:
                event.text = input_text(value, place, key);
                break;
            case InputKind::drop:
                event.files = files_from(value, place);
                break;
            case InputKind::close:
                break;
        }
        return event;
    }
    throw invalid_file(
        place, 0,
        fmt::format("an event must have one of the keys {}", fmt::join(event_names, ", ")));
}

std::vector<std::vector<InputEvent>> in_frames(const std::vector<InputEvent>& events) {
    std::vector<std::vector<InputEvent>> frames(1);
    for (const InputEvent& event : events) {
        const auto fits = [&](const InputEvent& first) { return go_together(first, event); };
        if (!std::ranges::all_of(frames.back(), fits)) frames.emplace_back();
        frames.back().push_back(event);
    }
    return frames;
}

}  // namespace burl
