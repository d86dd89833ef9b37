#include "app/editor/session/script.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "atlas/base/error.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

using Kind = ScriptStep::Kind;
using Frame = ScriptPlayer::Frame;

// The names of the ScriptStep::Kinds, in order.
constexpr std::array<std::string_view, 12> step_names{
    "events", "click", "double_click", "drag", "wheel",  "key",
    "type",   "drop",  "resize",       "wait", "settle", "screenshot"};

bool names_item(Kind kind) {
    return kind == Kind::click || kind == Kind::double_click || kind == Kind::drag ||
           kind == Kind::wheel;
}

Json step_json(const ScriptStep& step) {
    const std::string key(step_names[std::size_t(step.kind)]);
    Json json = Json::object();
    if (names_item(step.kind)) {
        json[key] = step.item;
    } else if (step.kind == Kind::events) {
        json[key] = Json::array();
        for (const InputEvent& event : step.events) json[key].push_back(to_json(event));
    } else if (step.kind == Kind::drop) {
        json[key] = step.files;
    } else if (step.kind == Kind::resize) {
        json[key] = Json::array({step.by.x, step.by.y});
    } else if (step.kind == Kind::wait) {
        json[key] = step.frames;
    } else if (step.kind == Kind::settle) {
        json[key] = true;
    } else {
        json[key] = step.text;
    }
    if (step.kind == Kind::drag && !step.to.empty())
        json["to"] = step.to;
    else if (step.kind == Kind::drag || step.kind == Kind::wheel)
        json["by"] = Json::array({step.by.x, step.by.y});
    if (step.kind == Kind::drag) json["frames"] = step.frames;
    if (step.kind == Kind::click && !step.text.empty()) json["button"] = step.text;
    return json;
}

/// Parses the size of a window, 64 to 8192 in each direction.
glm::dvec2 size_from(const Json& json, const std::string& key, const std::string& place) {
    const glm::dvec2 size = input_pair(json, place, key);
    if (glm::any(glm::lessThan(size, glm::dvec2(64.0))) ||
        glm::any(glm::greaterThan(size, glm::dvec2(8192.0))))
        refuse_input(place, key, "two numbers from 64 to 8192");
    return size;
}

int frames_from(const Json& json, const std::string& key, const std::string& place) {
    if (!json.is_number_integer() || json < 1 || json > 100000)
        refuse_input(place, key, "a number of frames from 1 to 100000");
    return json.get<int>();
}

ScriptStep step_of(Kind kind, const Json& json, const std::string& place) {
    const std::string key(step_names[std::size_t(kind)]);
    const Json& value = json[key];
    ScriptStep step{kind};
    if (names_item(kind)) step.item = input_text(value, place, key);
    if (kind == Kind::key || kind == Kind::type || kind == Kind::screenshot)
        step.text = input_text(value, place, key);
    if (kind == Kind::click && json.contains("button"))
        step.text = input_text(json["button"], place, "button");
    if (kind == Kind::resize) step.by = size_from(value, key, place);
    if (kind == Kind::wait) step.frames = frames_from(value, key, place);
    if (kind == Kind::drag && json.contains("to")) {
        step.to = input_text(json["to"], place, "to");
    } else if (kind == Kind::drag || kind == Kind::wheel) {
        if (!json.contains("by")) refuse_input(place, "by", "given: two numbers");
        step.by = input_pair(json["by"], place, "by");
    }
    if (kind == Kind::drag)
        step.frames = json.contains("frames") ? frames_from(json["frames"], "frames", place) : 8;
    const bool list = kind == Kind::events || kind == Kind::drop;
    if (list && !value.is_array()) refuse_input(place, key, "a list");
    if (kind == Kind::events)
        for (const Json& event : value) step.events.push_back(input_from_json(event, place));
    if (kind == Kind::drop)
        for (const Json& file : value) step.files.push_back(input_text(file, place, key));
    return step;
}

ScriptStep step_from_json(const Json& json, const std::string& place) {
    for (std::size_t k = 0; k < step_names.size(); ++k)
        if (json.is_object() && json.contains(step_names[k])) return step_of(Kind(k), json, place);
    throw invalid_file(
        place, 0, fmt::format("a step must have one of the keys {}", fmt::join(step_names, ", ")));
}

InputEvent move_to(const glm::dvec2& at) {
    return {InputKind::move, at};
}
InputEvent button(int number, bool down) {
    InputEvent event{InputKind::button};
    event.button = number;
    event.down = down;
    return event;
}
InputEvent key(const std::string& name, bool down) {
    InputEvent event{InputKind::key};
    event.text = name;
    event.down = down;
    return event;
}

/// Returns the frames of a click: the pointer arrives a frame before the button goes down, as
/// widgets must see it first.
std::vector<Frame> click_frames(const glm::dvec2& at, int number, int times) {
    std::vector<Frame> frames{{{move_to(at)}}};
    for (int i = 0; i < times; ++i) {
        frames.push_back({{button(number, true)}});
        frames.push_back({{button(number, false)}});
    }
    return frames;
}

std::vector<Frame> drag_frames(const glm::dvec2& from, const glm::dvec2& by, int count) {
    std::vector<Frame> frames{{{move_to(from)}}, {{button(0, true)}}};
    for (int i = 1; i <= count; ++i) frames.push_back({{move_to(from + by * (double(i) / count))}});
    frames.push_back({{button(0, false)}});
    return frames;
}

/// Returns the frames of a key combination such as "Ctrl+Shift+Z": all keys go down in one frame
/// and up in the next.
std::vector<Frame> key_frames(const std::string& keys) {
    Frame down, up;
    for (std::size_t begin = 0; begin <= keys.size();) {
        const std::size_t end = std::min(keys.find('+', begin + 1), keys.size());
        const std::string name = keys.substr(begin, end - begin);
        down.events.push_back(key(name, true));
        up.events.push_back(key(name, false));
        begin = end + 1;
    }
    return {down, up};
}

}  // namespace

void append_frame(InputScript& script, const std::vector<InputEvent>& events) {
    ScriptStep step;
    step.kind = events.empty() ? Kind::settle : Kind::events;
    step.events = events;
    if (events.empty() && !script.steps.empty() && script.steps.back() == step) return;
    script.steps.push_back(std::move(step));
}

std::string script_text(const InputScript& script) {
    Json steps = Json::array();
    for (const ScriptStep& step : script.steps) steps.push_back(step_json(step));
    return print_json(
        {{"burl_input", 1}, {"size", {script.size.x, script.size.y}}, {"steps", steps}});
}

InputScript parse_script(const std::string& text, const std::string& origin) {
    const Json json = parse_json_text(text, origin);
    if (!json.is_object() || !json.contains("burl_input") || json["burl_input"] != 1)
        refuse_input(origin, "burl_input", "1");
    InputScript script;
    if (json.contains("size")) script.size = glm::ivec2(size_from(json["size"], "size", origin));
    if (!json.contains("steps") || !json["steps"].is_array())
        refuse_input(origin, "steps", "a list of steps");
    for (std::size_t i = 0; i < json["steps"].size(); ++i)
        script.steps.push_back(
            step_from_json(json["steps"][i], fmt::format("{}: steps.{}", origin, i)));
    return script;
}

ScriptPlayer::ScriptPlayer(InputScript script) : script_(std::move(script)) {}

glm::dvec2 ScriptPlayer::middle_of(const std::string& item, const FindItem& find) const {
    const std::optional<ItemRect> rect = find(item);
    if (!rect)
        throw invalid_file(fmt::format("steps.{}", next_), 0,
                           fmt::format("\"{}\" is not on screen", item));
    return rect->middle();
}

std::vector<Frame> ScriptPlayer::frames_of_drag(const ScriptStep& step,
                                                const FindItem& find) const {
    const glm::dvec2 from = middle_of(step.item, find);
    const glm::dvec2 by = step.to.empty() ? step.by : middle_of(step.to, find) - from;
    return drag_frames(from, by, step.frames);
}

std::vector<Frame> ScriptPlayer::frames_of(const ScriptStep& step, const FindItem& find) const {
    switch (step.kind) {
        case Kind::events:
            return {{step.events}};
        case Kind::click: {
            const int number = step.text == "right" ? 1 : step.text == "middle" ? 2 : 0;
            return click_frames(middle_of(step.item, find), number, 1);
        }
        case Kind::double_click:
            return click_frames(middle_of(step.item, find), 0, 2);
        case Kind::drag:
            return frames_of_drag(step, find);
        case Kind::wheel:
            return {{{move_to(middle_of(step.item, find))}}, {{{InputKind::wheel, step.by}}}};
        case Kind::key:
            return key_frames(step.text);
        case Kind::type: {
            InputEvent typed{InputKind::text};
            typed.text = step.text;
            return {{{typed}}};
        }
        case Kind::drop: {
            InputEvent dropped{InputKind::drop};
            dropped.files = step.files;
            return {{{dropped}}};
        }
        case Kind::resize:
            return {{{{InputKind::resize, step.by}}}};
        case Kind::wait:
            return std::vector<Frame>(std::size_t(step.frames));
        case Kind::settle:
            return {{{}, "", true}};
        case Kind::screenshot:
            return {{{}, step.text}};
    }
    return {};
}

Frame ScriptPlayer::next(const FindItem& find) {
    while (pending_.empty() && next_ < script_.steps.size()) {
        pending_ = frames_of(script_.steps[next_], find);
        std::ranges::reverse(pending_);
        ++next_;
    }
    if (pending_.empty()) return {};
    Frame frame = std::move(pending_.back());
    pending_.pop_back();
    return frame;
}

}  // namespace burl
