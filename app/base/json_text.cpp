#include "app/base/json_text.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

#include "atlas/base/error.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

std::size_t line_of(const std::string& text, std::size_t byte) {
    const auto end = text.begin() + std::ptrdiff_t(std::min(byte, text.size()));
    return 1 + std::size_t(std::count(text.begin(), end, '\n'));
}

/// The message without the library's prefix "[json.exception.parse_error.101] parse error at line
/// 3, column 5: ".
std::string_view reason(std::string_view what) {
    const std::size_t column = what.find("column ");
    const std::size_t colon = what.find(": ", column == std::string_view::npos ? 0 : column);
    if (colon != std::string_view::npos && column != std::string_view::npos)
        return what.substr(colon + 2);
    const std::size_t bracket = what.find("] ");
    return bracket == std::string_view::npos ? what : what.substr(bracket + 2);
}

/// The line, from 1, of the number that a message such as "number overflow parsing '1e999'" quotes;
/// 0 where it is not found.
std::size_t line_of_number(const std::string& text, std::string_view what) {
    const std::size_t begin = what.find('\''), end = what.rfind('\'');
    if (begin == std::string_view::npos || end <= begin) return 0;
    const std::size_t byte = text.find(what.substr(begin + 1, end - begin - 1));
    return byte == std::string::npos ? 0 : line_of(text, byte);
}

/// Whether a key or value is a text with U+0000, at which names of files would end.
bool has_null(Json::parse_event_t event, const Json& parsed) {
    const bool text = event == Json::parse_event_t::key || event == Json::parse_event_t::value;
    return text && parsed.is_string() &&
           parsed.get_ref<const std::string&>().find('\0') != std::string::npos;
}

/// A parser callback that finds the first key given twice in one object, of which the library
/// itself keeps the last value, and texts with U+0000.
class RepeatedKeys {
  public:
    bool operator()(int, Json::parse_event_t event, const Json& parsed) {
        null_ = null_ || has_null(event, parsed);
        if (event == Json::parse_event_t::object_start) open_.emplace_back();
        if (event == Json::parse_event_t::object_end) open_.pop_back();
        if (event == Json::parse_event_t::key && first_.empty()) {
            const std::string key = parsed.get<std::string>();
            if (!open_.back().insert(key).second) first_ = key;
        }
        return true;
    }
    const std::string& first() const { return first_; }
    bool any_null() const { return null_; }

  private:
    std::vector<std::set<std::string>> open_;
    std::string first_;
    bool null_ = false;
};

/// The reason to stop parsing a document that is too deep.
struct TooDeep {};

/// True; a depth from max_json_depth on ends the parse by an exception.
bool is_shallow(int depth) {
    if (depth >= max_json_depth) throw TooDeep{};
    return true;
}

void print(const Json& json, std::size_t indent, std::string& out) {
    const bool flat = !json.is_object() &&
                      !(json.is_array() && std::any_of(json.begin(), json.end(), [](const Json& j) {
                            return j.is_structured();
                        }));
    if (flat || json.empty()) {
        out += print_json_value(json);
        return;
    }
    out += json.is_object() ? "{\n" : "[\n";
    std::size_t left = json.size();
    for (const auto& item : json.items()) {
        out.append(indent + 2, ' ');
        if (json.is_object()) out += print_json_value(Json(item.key())) + ": ";
        print(item.value(), indent + 2, out);
        out += --left > 0 ? ",\n" : "\n";
    }
    out.append(indent, ' ');
    out += json.is_object() ? "}" : "]";
}

}  // namespace

Json parse_json_text(const std::string& text, const std::string& origin) {
    RepeatedKeys keys;
    try {
        Json json = Json::parse(text, [&keys](int depth, Json::parse_event_t event, Json& parsed) {
            return is_shallow(depth) && keys(depth, event, parsed);
        });
        if (keys.any_null())
            throw invalid_file(origin, 0, "a text holds U+0000, which names cannot have");
        if (!keys.first().empty())
            throw invalid_file(
                origin, 0, fmt::format("the key \"{}\" is given twice; keep one", keys.first()));
        return json;
    } catch (const TooDeep&) {
        throw invalid_file(origin, 0,
                           fmt::format("nested more than {} levels deep", max_json_depth));
    } catch (const Json::parse_error& error) {
        const std::size_t byte = error.byte > 0 ? error.byte - 1 : 0;
        throw invalid_file(origin, line_of(text, byte),
                           fmt::format("not valid JSON: {}", reason(error.what())));
    } catch (const Json::exception& error) {
        throw invalid_file(origin, line_of_number(text, error.what()),
                           fmt::format("not valid JSON: {}", reason(error.what())));
    }
}

Json parse_json_value(const std::string& text) {
    try {
        return Json::parse(
            text, [](int depth, Json::parse_event_t, Json&) { return is_shallow(depth); }, false);
    } catch (const TooDeep&) {
        return Json(Json::value_t::discarded);
    }
}

std::string print_json(const Json& json) {
    std::string out;
    print(json, 0, out);
    return out + "\n";
}

std::string print_json_value(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace burl
