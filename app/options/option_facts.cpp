#include "app/options/option_facts.h"

#include <algorithm>
#include <string_view>

#include <CLI/CLI.hpp>

#include "app/recipe/parameters.h"

namespace burl {

namespace {

std::vector<std::string> words_between(std::string_view text, char separator) {
    std::vector<std::string> words;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(separator), text.size());
        words.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return words;
}

/// The words of "TEXT:{a,b}".
std::vector<std::string> choices_in(std::string_view type) {
    const std::size_t begin = type.find('{');
    if (begin == std::string_view::npos) return {};
    return words_between(type.substr(begin + 1, type.find('}') - begin - 1), ',');
}

/// The choices of the recipe's parameter that has this option.
std::vector<std::string> parameter_choices(const std::string& name) {
    for (const RecipeParameter& parameter : parameters()) {
        const std::vector<std::string> names = words_between(parameter.use.option, ',');
        if (std::ranges::find(names, name) != names.end())
            return words_between(parameter.choices, '|');
    }
    return {};
}

OptionFacts facts_of(const CLI::Option& option) {
    OptionFacts facts;
    facts.positional = option.get_positional();
    facts.required = option.get_required();
    for (const std::string& name : option.get_snames()) facts.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) facts.names.push_back("--" + name);
    if (facts.positional) facts.names = {option.get_name(true, false)};
    const std::string type = option.get_type_name();
    if (option.get_items_expected_max() > 0 && !facts.positional)
        facts.value = type.substr(0, type.find(':'));
    facts.choices = choices_in(type);
    if (facts.choices.empty()) facts.choices = parameter_choices(facts.names.back());
    facts.about = option.get_description();
    facts.otherwise = option.get_default_str();
    return facts;
}

}  // namespace

std::vector<OptionFacts> facts_of(const CLI::App& app) {
    std::vector<OptionFacts> all;
    for (const CLI::Option* option : app.get_options())
        if (!option->get_group().empty()) all.push_back(facts_of(*option));
    std::ranges::stable_partition(all, &OptionFacts::positional);
    return all;
}

std::vector<const CLI::App*> verbs_of(const CLI::App& program) {
    return program.get_subcommands([](const CLI::App* verb) { return !verb->get_group().empty(); });
}

}  // namespace burl
