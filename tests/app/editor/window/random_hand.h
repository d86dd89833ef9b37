#pragma once
// A hand that does anything in the editor, the same for every run of a seed.
#include <array>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "app/editor/session/input.h"
#include "app/editor/widgets/items.h"

namespace burl {

using Events = std::vector<InputEvent>;

inline InputEvent pointer_to(const glm::dvec2& at) {
    return {InputKind::move, at};
}

inline InputEvent button_event(int number, bool down) {
    InputEvent event{InputKind::button};
    event.button = number;
    event.down = down;
    return event;
}

inline InputEvent key_event(const std::string& name, bool down) {
    InputEvent event{InputKind::key};
    event.text = name;
    event.down = down;
    return event;
}

/// Frames of events, from what is on the screen.
class RandomHand {
  public:
    RandomHand(unsigned seed, std::vector<std::string> files)
        : random_(seed), files_(std::move(files)) {}

    unsigned below(std::size_t count) { return unsigned(random_() % count); }
    bool chance(unsigned percent) { return below(100) < percent; }

    std::vector<Events> next(const EditItems& items, const glm::ivec2& size) {
        size_ = glm::dvec2(size);
        if (!held_.empty() && chance(40)) return {std::exchange(held_, {})};
        const unsigned what = below(100);
        if (what < 34) return click(place(items));
        if (what < 62) return drag(place(items));
        if (what < 84) return key();
        if (what < 89) return wheel(place(items));
        if (what < 94) return type();
        if (what < 97) return drop();
        if (what < 99) return resize();
        return {{{InputKind::close}}};
    }

  private:
    template <class List>
    const auto& one_of(const List& list) {
        return *std::next(std::begin(list), below(std::size(list)));
    }

    glm::dvec2 anywhere() { return {below(unsigned(size_.x)), below(unsigned(size_.y))}; }

    /// A place on an item, most of the time.
    glm::dvec2 place(const EditItems& items) {
        if (items.all().empty() || chance(15)) return anywhere();
        const auto& [name, rect] = one_of(items.all());
        if (name == "atlas.size" || name == "file:..") return anywhere();
        const glm::dvec2 share{below(101), below(101)};
        return rect.low + (rect.high - rect.low) * share / 100.0;
    }

    std::vector<Events> click(const glm::dvec2& at) {
        const int number = chance(80) ? 0 : int(below(3));
        std::vector<Events> frames{{pointer_to(at)}};
        for (int times = chance(15) ? 2 : 1; times > 0; --times) {
            frames.push_back({button_event(number, true)});
            frames.push_back({button_event(number, false)});
        }
        return frames;
    }

    std::vector<Events> drag(const glm::dvec2& from) {
        const int number = chance(85) ? 0 : int(below(3));
        const glm::dvec2 by{double(below(241)) - 120.0, chance(50) ? double(below(121)) - 60.0 : 0};
        const unsigned steps = 1 + below(6);
        const std::string modifier = chance(25) ? one_of(modifiers) : "";
        std::vector<Events> frames{{pointer_to(from)}, {button_event(number, true)}};
        if (!modifier.empty()) frames[1].insert(frames[1].begin(), key_event(modifier, true));
        for (unsigned i = 1; i <= steps; ++i) {
            frames.push_back({pointer_to(from + by * (double(i) / steps))});
            if (chance(6))
                for (Events& some : key()) frames.push_back(std::move(some));
        }
        Events up{button_event(number, false)};
        if (!modifier.empty()) up.push_back(key_event(modifier, false));
        if (chance(4))
            held_.insert(held_.end(), up.begin(), up.end());
        else
            frames.push_back(up);
        return frames;
    }

    std::vector<Events> key() {
        Events down, up;
        const std::string name = chance(50) ? one_of(shortcuts) : one_of(keys);
        for (std::size_t begin = 0; begin <= name.size();) {
            const std::size_t end = std::min(name.find('+', begin), name.size());
            down.push_back(key_event(name.substr(begin, end - begin), true));
            up.push_back(key_event(name.substr(begin, end - begin), false));
            begin = end + 1;
        }
        if (!chance(3)) return {down, up};
        held_.insert(held_.end(), up.begin(), up.end());
        return {down};
    }

    std::vector<Events> wheel(const glm::dvec2& at) {
        InputEvent turned{InputKind::wheel};
        turned.at = {0.0, double(below(7)) - 3.0};
        return {{pointer_to(at)}, {turned}};
    }

    /// No '/', which could lead a dialog out of the folder.
    std::vector<Events> type() {
        InputEvent typed{InputKind::text};
        typed.text = one_of(texts);
        if (chance(50)) return {{typed}};
        return {{typed}, {key_event("Enter", true)}, {key_event("Enter", false)}};
    }

    std::vector<Events> drop() {
        InputEvent dropped{InputKind::drop};
        for (unsigned i = chance(80) ? 1 : 2; i > 0; --i) dropped.files.push_back(one_of(files_));
        return {{dropped}};
    }

    std::vector<Events> resize() {
        InputEvent resized{InputKind::resize};
        resized.at = {64.0 + below(400), 64.0 + below(300)};
        if (chance(60)) resized.at = {400.0, 320.0};
        return {{resized}};
    }

    static constexpr std::array<const char*, 3> modifiers{"Ctrl", "Shift", "Alt"};
    static constexpr std::array<const char*, 38> shortcuts{"Ctrl+Z",
                                                           "Ctrl+Z",
                                                           "Ctrl+Y",
                                                           "Ctrl+Shift+Z",
                                                           "Ctrl+S",
                                                           "Ctrl+O",
                                                           "Ctrl+E",
                                                           "Ctrl+Shift+S",
                                                           "Ctrl+C",
                                                           "Ctrl+V",
                                                           "Ctrl+Shift+C",
                                                           "Ctrl+Q",
                                                           "F5",
                                                           "K",
                                                           "I",
                                                           "Delete",
                                                           "Space",
                                                           "V",
                                                           "W",
                                                           "B",
                                                           "P",
                                                           "G",
                                                           "X",
                                                           "A",
                                                           "Escape",
                                                           "Escape",
                                                           "Enter",
                                                           "Tab",
                                                           "Ctrl+Plus",
                                                           "Ctrl+Minus",
                                                           "N",
                                                           "Insert",
                                                           "Insert",
                                                           "Delete",
                                                           "Ctrl+G",
                                                           "Ctrl+X",
                                                           "Shift+A",
                                                           "Shift+B"};
    static constexpr std::array<const char*, 34> keys{
        "Left", "Right", "Up",   "Down", "Shift+Left", "Ctrl+Up", "PageUp",   "PageDown", "Home",
        "End",  "F",     "1",    "3",    "7",          "L",       "T",        "Comma",    "Period",
        "F1",   "F12",   "Tab",  "0",    "Ctrl+0",     "Ctrl+A",  "Insert",   "Shift",    "Alt",
        "Ctrl", "Q",     "Down", "Tab",  "Backspace",  "Alt+F4",  "Shift+Tab"};
    static constexpr std::array<const char*, 20> texts{
        "1",        "0.5",     "-3",    "1e30", "nan",     "abc",
        "out.glb",  "out.obj", "fbm",   "mix",  "add a=1", "warp octaves=99",
        "#ff",      "r.json",  "m.obj", "..",   ".",       "é☃",
        "new.json", "x.frag"};

    std::mt19937 random_;
    std::vector<std::string> files_;
    Events held_;  ///< what will let go of what is down
    glm::dvec2 size_{1.0};
};

}  // namespace burl
