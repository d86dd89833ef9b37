// Changes of JSON that leave it JSON: other values of a place, parts of other files, places that
// swap, go, or come.
#include <array>

#include "atlas/base/json.h"
#include "tests/fuzz/mutate.h"

namespace burl::fuzz {
namespace {

/// Changes one place of a JSON document.
class JsonChange {
  public:
    JsonChange(Json& root, const JsonPool& pool, Random& random) : pool_(pool), random_(random) {
        collect(root);
    }

    void make() {
        switch (below(random_, 9)) {
            case 0:
            case 1:
                return change_value();
            case 2:
                return take_from_pool();
            case 3:
                return erase();
            case 4:
                return insert();
            case 5:
                return copy();
            case 6:
                return rename();
            case 7:
                return nest();
            default:
                return change_number();
        }
    }

  private:
    void collect(Json& json) {
        places_.push_back(&json);
        if (json.is_structured())
            for (Json& one : json) collect(one);
    }
    Json& any() { return *places_[below(random_, places_.size())]; }
    /// A place with members or elements; the root where there is none.
    Json& container() {
        for (int trial = 0; trial < 8; ++trial)
            if (Json& json = any(); json.is_structured() && !json.empty()) return json;
        return *places_.front();
    }
    std::string word() {
        return pool_.words.empty() ? "x" : pool_.words[below(random_, pool_.words.size())];
    }
    std::pair<std::string, Json> member() {
        if (pool_.members.empty()) return {word(), Json(1)};
        const auto& [key, text] = pool_.members[below(random_, pool_.members.size())];
        return {key, Json::parse(text)};
    }

    Json odd_value() {
        static const std::array<const char*, 26> values{"0",
                                                        "1",
                                                        "-1",
                                                        "2",
                                                        "0.5",
                                                        "1e-300",
                                                        "1e300",
                                                        "-1e300",
                                                        "255",
                                                        "256",
                                                        "65535",
                                                        "65536",
                                                        "2147483647",
                                                        "4294967295",
                                                        "18446744073709551615",
                                                        "1e15",
                                                        "null",
                                                        "true",
                                                        "false",
                                                        "\"\"",
                                                        "[]",
                                                        "{}",
                                                        "[0,0,0]",
                                                        "[[]]",
                                                        "\"#ff8000\"",
                                                        "\"\\u0000\\u001b\""};
        return Json::parse(values[below(random_, values.size())]);
    }
    void change_value() { any() = below(random_, 3) == 0 ? Json(word()) : odd_value(); }
    void take_from_pool() { any() = member().second; }
    void change_number() {
        for (int trial = 0; trial < 8; ++trial) {
            Json& json = any();
            if (!json.is_number()) continue;
            const double factors[] = {2.0, 0.5, -1.0, 1000.0, 1e-6, 1e12};
            if (json.is_number_integer() && below(random_, 2) == 0)
                json = json.get<std::int64_t>() / 2 + std::int64_t(below(random_, 5)) - 2;
            else
                json = json.get<double>() * factors[below(random_, 6)];
            return;
        }
        change_value();
    }
    void erase() {
        Json& json = container();
        if (!json.is_structured() || json.empty()) return;
        const std::size_t at = below(random_, json.size());
        if (json.is_array()) json.erase(at);
        if (json.is_object()) json.erase(std::next(json.begin(), std::ptrdiff_t(at)).key());
    }
    void insert() {
        Json& json = container();
        auto [key, value] = member();
        if (json.is_array())
            json.insert(json.begin() + std::ptrdiff_t(below(random_, json.size() + 1)), value);
        if (json.is_object()) json[key] = value;
    }
    /// Puts what is in one place into another, or an element once more into its list.
    void copy() {
        Json& list = container();
        if (list.is_array() && !list.empty() && below(random_, 2) == 0) {
            const Json one = list[below(random_, list.size())];
            for (std::size_t n = 1 + below(random_, 4); n > 0; --n) list.push_back(one);
            return;
        }
        const Json from = any();
        any() = from;
    }
    void rename() {
        Json& json = container();
        if (!json.is_object() || json.empty()) return change_value();
        const auto old = std::next(json.begin(), std::ptrdiff_t(below(random_, json.size())));
        const Json value = old.value();
        json.erase(old.key());
        json[below(random_, 2) == 0 ? word() : member().first] = value;
    }
    void nest() {
        Json& json = any();
        const Json inside = json;
        if (below(random_, 2) == 0)
            json = Json::array({inside});
        else
            json = Json{{word(), inside}};
    }

    const JsonPool& pool_;
    Random& random_;
    std::vector<Json*> places_;
};

void add(const Json& json, JsonPool& pool) {
    if (json.is_string()) pool.words.push_back(json.get<std::string>());
    if (json.is_object())
        for (const auto& item : json.items())
            if (item.value().dump().size() < 400)
                pool.members.emplace_back(item.key(), item.value().dump());
    if (json.is_structured())
        for (const Json& one : json) add(one, pool);
}

/// Whether the text is deeper than functions that call themselves should go.
bool is_deep(const std::string& text) {
    int depth = 0, most = 0;
    for (const char c : text) {
        depth += c == '{' || c == '[' ? 1 : c == '}' || c == ']' ? -1 : 0;
        most = std::max(most, depth);
    }
    return most > 200;
}

}  // namespace

void add_to_pool(const std::string& text, JsonPool& pool) {
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_discarded()) add(json, pool);
}

std::string mutated_json(const std::string& text, const JsonPool& pool, Random& random) {
    if (is_deep(text)) return mutated_bytes(text, random);
    Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded()) return mutated_bytes(text, random);
    JsonChange(json, pool, random).make();
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace burl::fuzz
