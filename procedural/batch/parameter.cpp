#include "procedural/batch/parameter.h"

#include <algorithm>
#include <array>

namespace burl {

std::string_view to_string(ParameterType type) {
    constexpr std::array<std::string_view, 6> names{"number", "integer", "numbers",
                                                    "text",   "choice",  "color"};
    return names[std::size_t(type)];
}

std::vector<std::string_view> split_choices(std::string_view choices) {
    std::vector<std::string_view> words;
    while (!choices.empty()) {
        const std::size_t end = std::min(choices.find('|'), choices.size());
        words.push_back(choices.substr(0, end));
        choices.remove_prefix(std::min(end + 1, choices.size()));
    }
    return words;
}

}  // namespace burl
