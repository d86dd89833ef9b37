#include "procedural/model/members.h"

#include <deque>
#include <mutex>

namespace burl::members {

std::string_view kept(std::string text) {
    static std::mutex one_at_a_time;
    static std::deque<std::string> texts;
    const std::scoped_lock lock(one_at_a_time);
    return texts.emplace_back(std::move(text));
}

std::string_view default_text(const Json& json) {
    if (json.is_null()) return "";
    if (json.is_number()) return kept(fmt::format("{}", json.get<double>()));
    if (!json.is_array()) return kept(json.dump());
    return kept(fmt::format("[{}]", fmt::join(json.get<std::vector<double>>(), ",")));
}

std::string key_of(const Parameter& row) {
    const std::string_view path = row.path.substr(0, row.path.find_last_not_of(".*") + 1);
    return std::string(path.substr(path.rfind('.') + 1));
}

const Json* find_value(const Json& json, const std::string& key) {
    if (json.is_array()) return &json[std::stoul(key)];
    const auto found = json.find(key);
    return found == json.end() ? nullptr : &*found;
}

Json& place_of(Json& json, const std::string& key) {
    return key.find_first_not_of("0123456789") == std::string::npos ? json.emplace_back()
                                                                    : json[key];
}

}  // namespace burl::members
