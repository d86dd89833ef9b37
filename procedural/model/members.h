#pragma once
// Parameters that are members of structs: a row of a table names a member once, and its type,
// default, words, reading and writing follow from the member.
#include <algorithm>
#include <array>
#include <concepts>
#include <optional>
#include <ranges>
#include <string>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include "atlas/base/enum_names.h"
#include "atlas/base/json.h"
#include "atlas/base/vec.h"
#include "procedural/batch/parameter.h"
#include "procedural/model/texture_json.h"

namespace burl {

namespace members {

using Json = nlohmann::ordered_json;

/// The type of a value that a member has once, at most once or any number of times.
template <class T>
struct Item {
    using Value = T;
};
template <class T>
struct Item<std::optional<T>> {
    using Value = T;
};
template <class T>
struct Item<std::vector<T>> {
    using Value = T;
};

template <class T>
inline constexpr bool is_optional = std::same_as<T, std::optional<typename Item<T>::Value>>;
template <class T>
inline constexpr bool is_list = std::same_as<T, std::vector<typename Item<T>::Value>>;
template <class T>
inline constexpr bool is_choice = std::is_enum_v<T> || std::same_as<T, bool>;

template <class T>
constexpr ParameterType parameter_type() {
    if (is_choice<T>) return ParameterType::choice;
    if (std::integral<T>) return ParameterType::integer;
    if (std::floating_point<T>) return ParameterType::number;
    if (std::same_as<T, std::string>) return ParameterType::text;
    return std::same_as<T, Rgb8> ? ParameterType::color : ParameterType::numbers;
}

/// Sets a value from JSON that has been checked.
template <class T>
void read_value(const Parameter& parameter, const Json& json, T& value) {
    if constexpr (is_optional<T>) {
        read_value(parameter, json, value.emplace());
    } else if constexpr (is_list<T>) {
        for (const Json& item : json) read_value(parameter, item, value.emplace_back());
    } else if constexpr (is_choice<T>) {
        const auto words = split_choices(parameter.choices);
        value = T(std::ranges::find(words, json.get<std::string>()) - words.begin());
    } else if constexpr (std::integral<T>) {
        value = T(json.get<double>());  // also written as 4.0 or 1e3
    } else if constexpr (std::same_as<T, Vec3d>) {
        value = {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
    } else if constexpr (std::same_as<T, Rgb8>) {
        value = color_from_hex(json.get<std::string>());
    } else {
        value = json.get<T>();
    }
}

/// Returns a value as JSON; null for an optional without one.
template <class T>
Json value_json(const Parameter& parameter, const T& value) {
    if constexpr (is_optional<T>) {
        return value ? value_json(parameter, *value) : Json();
    } else if constexpr (is_list<T>) {
        Json items = Json::array();
        for (const auto& item : value) items.push_back(value_json(parameter, item));
        return items;
    } else if constexpr (is_choice<T>) {
        return split_choices(parameter.choices)[std::size_t(value)];
    } else if constexpr (std::same_as<T, Vec3d>) {
        return {value.x, value.y, value.z};
    } else if constexpr (std::same_as<T, Rgb8>) {
        return color_to_hex(value);
    } else {
        return value;
    }
}

/// Returns a view of a text that lives as long as the program.
std::string_view kept(std::string text);

/// A default as tables write it: whole numbers have no point; empty for null.
std::string_view default_text(const Json& json);

/// The last part of its path; of items ("points.*") the one before it.
std::string key_of(const Parameter& row);

/// The value of a key of an object, or of an index of an array; null where there is none.
const Json* find_value(const Json& json, const std::string& key);

/// The place of a key of an object, or of an index at the end of an array.
Json& place_of(Json& json, const std::string& key);

}  // namespace members

/// The range of a number, both ends included, the step of one notch of a slider, and its unit;
/// the words for a bool's false and true, separated by "|".
struct NumberRange {
    double low = 0.0, high = 0.0, step = 0.0;
    std::string_view unit{}, words{};
};

/// The look of a parameter in editors, and whether it has no default.
struct ParameterLook {
    std::string_view label{};
    bool rare = false, required = false;
};

/// The parameter that a member stands for.
template <class Owner, class Member>
MemberParameter member_row(std::string_view path, Member Owner::*member, const NumberRange& range,
                           std::string_view tip, const ParameterLook& look = {}) {
    using Value = typename members::Item<Member>::Value;
    static_assert(!std::is_enum_v<Value> || NamedEnum<Value>, "enum_names has no words for it");
    const auto& [low, high, step, unit, words] = range;
    Parameter parameter{path,       members::parameter_type<Value>(),
                        low,        high,
                        step,       1,
                        unit,       "",
                        words,      tip,
                        look.label, look.rare};
    if constexpr (NamedEnum<Value>)
        parameter.choices = members::kept(fmt::format("{}", fmt::join(enum_names<Value>, "|")));
    if (parameter.type == ParameterType::numbers)
        parameter.count = members::value_json(parameter, Value{}).size();
    if (!look.required)
        parameter.default_value =
            members::default_text(members::value_json(parameter, Owner{}.*member));
    return {parameter, &typeid(Owner),
            [=](const members::Json& json, void* owner) {
                members::read_value(parameter, json, static_cast<Owner*>(owner)->*member);
            },
            [=](const void* owner) {
                return members::value_json(parameter, static_cast<const Owner*>(owner)->*member);
            }};
}

/// The rows of a table that are members of `Owner`.
template <class Owner, class Table>
auto rows_of(const Table& table) {
    return std::views::filter(
        table, [](const auto& row) { return row.owner && *row.owner == typeid(Owner); });
}

/// Sets the members of `owner` that the table and the JSON, an object or a tuple, have.
template <class Table, class Owner>
void read_members(const Table& table, const nlohmann::ordered_json& json, Owner& owner) {
    for (const auto& row : rows_of<Owner>(table))
        if (const auto* value = members::find_value(json, members::key_of(row)))
            row.read(*value, &owner);
}

/// Adds the members of `owner` that the table has, except those that have their default and for
/// which needs(key) is false.
template <class Table, class Owner, class Needs>
void write_members(const Table& table, const Owner& owner, nlohmann::ordered_json& json,
                   const Needs& needs) {
    static const Owner defaults{};
    for (const auto& row : rows_of<Owner>(table)) {
        const std::string key = members::key_of(row);
        nlohmann::ordered_json value = row.write(&owner);
        if (value.is_null() || (!needs(key) && value == row.write(&defaults))) continue;
        members::place_of(json, key) = std::move(value);
    }
}

template <class Table, class Owner>
void write_members(const Table& table, const Owner& owner, nlohmann::ordered_json& json) {
    write_members(table, owner, json, [](std::string_view) { return true; });
}

template <class Table, class Owner>
void read_list(const Table& table, const nlohmann::ordered_json& json, std::vector<Owner>& list) {
    for (const auto& one : json) read_members(table, one, list.emplace_back());
}

template <class Table, class Owner>
nlohmann::ordered_json list_json(const Table& table, const std::vector<Owner>& list) {
    auto json = nlohmann::ordered_json::array();
    for (const Owner& one : list) write_members(table, one, json.emplace_back());
    return json;
}

}  // namespace burl
