// Completions of bash, zsh and fish: verbs, options, their choices, and names of recipes and
// materials; else files.
#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/options/manual.h"
#include "app/options/option_facts.h"
#include "app/recipe/presets.h"

namespace burl {

namespace {

/// The option's choices, and of --recipe the names of what is built in; empty: files.
std::vector<std::string> words_of(const OptionFacts& option) {
    if (std::ranges::find(option.names, "--recipe") == option.names.end()) return option.choices;
    std::vector<std::string> names;
    for (const auto name : material_names()) names.emplace_back(name);
    for (const auto name : preset_names()) names.emplace_back(name);
    return names;
}

/// The words without what a shell would read in them; a verb's options, or those of the program
/// itself where it has no verbs.
struct Completed {
    std::string verb, about;
    std::vector<OptionFacts> options;
};

std::vector<Completed> completed(const CLI::App& program) {
    std::vector<Completed> all;
    for (const CLI::App* verb : verbs_of(program))
        all.push_back({verb->get_name(), verb->get_description(), facts_of(*verb)});
    if (all.empty()) all.push_back({"", program.get_description(), facts_of(program)});
    for (Completed& one : all)
        std::erase_if(one.options, [](const OptionFacts& option) { return option.positional; });
    return all;
}

/// The text between single quotes of a shell.
std::string quoted(std::string_view text, std::string_view quote) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string(quote) : std::string(1, c);
    return result + '\'';
}

std::string bash_case(const Completed& one) {
    std::string text =
        fmt::format("        {})\n            case $prev in\n", one.verb.empty() ? "*" : one.verb);
    std::vector<std::string> names;
    for (const OptionFacts& option : one.options) {
        names.insert(names.end(), option.names.begin(), option.names.end());
        if (const auto words = words_of(option); !option.value.empty() && !words.empty())
            text += fmt::format("                {}) words='{}' ;;\n", fmt::join(option.names, "|"),
                                fmt::join(words, " "));
    }
    return text +
           fmt::format("            esac\n            options='{}' ;;\n", fmt::join(names, " "));
}

std::string bash(const CLI::App& program) {
    const std::string name = program.get_name();
    std::string function = name, cases;
    std::ranges::replace(function, '-', '_');
    std::vector<std::string> verbs;
    for (const Completed& one : completed(program)) {
        cases += bash_case(one);
        if (!one.verb.empty()) verbs.push_back(one.verb);
    }
    const std::string first =
        verbs.empty() ? ""
                      : fmt::format(
                            "    if ((COMP_CWORD == 1)); then\n        COMPREPLY=($(compgen "
                            "-W '{} --help --version' -- \"$cur\"))\n        return\n    fi\n",
                            fmt::join(verbs, " "));
    return fmt::format(R"(# bash completion of {0}
_{1}() {{
    local cur=${{COMP_WORDS[COMP_CWORD]}} prev=${{COMP_WORDS[COMP_CWORD - 1]}} words='' options=''
    COMPREPLY=()
{2}    case ${{COMP_WORDS[1]}} in
{3}    esac
    if [[ -n $words ]]; then
        COMPREPLY=($(compgen -W "$words" -- "$cur"))
    elif [[ $cur == -* ]]; then
        COMPREPLY=($(compgen -W "$options" -- "$cur"))
    fi
}}
complete -o bashdefault -o default -F _{1} {0}
)",
                       name, function, first, cases);
}

/// An option as zsh's _arguments takes it.
std::string zsh_option(const OptionFacts& option) {
    std::string about;
    for (const char c : option.about) {
        if (c == '[' || c == ']' || c == '\\') about += '\\';
        about += c;
    }
    const auto words = words_of(option);
    const std::string value = option.value.empty() ? ""
                              : words.empty()      ? ":value:_files"
                                              : fmt::format(":value:({})", fmt::join(words, " "));
    std::string lines;
    for (const std::string& name : option.names)
        lines += fmt::format(" \\\n                {}",
                             quoted(fmt::format("{}[{}]{}", name, about, value), "'\\''"));
    return lines;
}

std::string zsh(const CLI::App& program) {
    const std::string name = program.get_name();
    std::string verbs, cases;
    for (const Completed& one : completed(program)) {
        if (!one.verb.empty())
            verbs += ' ' + quoted(fmt::format("{}:{}", one.verb, one.about), "'\\''");
        cases +=
            fmt::format("        {})\n            _arguments", one.verb.empty() ? "*" : one.verb);
        for (const OptionFacts& option : one.options) cases += zsh_option(option);
        cases += " \\\n                '*:file:_files' ;;\n";
    }
    const std::string choose =
        verbs.empty()
            ? ""
            : fmt::format(
                  "    local -a verbs=({} )\n    if ((CURRENT == 2)); then\n        "
                  "_describe verb verbs\n        return\n    fi\n    local verb=$words[2]\n"
                  "    shift words\n    ((CURRENT--))\n",
                  verbs);
    return fmt::format("#compdef {}\n{}case ${} in\n{}esac\n", name, choose,
                       verbs.empty() ? "words[1]" : "verb", cases);
}

std::string fish_option(const std::string& head, const OptionFacts& option) {
    std::string line = head;
    for (const std::string& name : option.names)
        line += name.starts_with("--") ? fmt::format(" -l {}", name.substr(2))
                                       : fmt::format(" -s {}", name.substr(1));
    const auto words = words_of(option);
    if (!option.value.empty() && !words.empty())
        line += fmt::format(" -xa '{}'", fmt::join(words, " "));
    else if (!option.value.empty())
        line += " -r";
    return line + fmt::format(" -d {}\n", quoted(option.about, "\\'"));
}

std::string fish(const CLI::App& program) {
    const std::string name = program.get_name();
    std::string text = fmt::format("# fish completion of {}\n", name);
    for (const Completed& one : completed(program)) {
        std::string head = "complete -c " + name;
        if (!one.verb.empty()) {
            text += fmt::format("{} -n __fish_use_subcommand -fa {} -d {}\n", head, one.verb,
                                quoted(one.about, "\\'"));
            head += fmt::format(" -n '__fish_seen_subcommand_from {}'", one.verb);
        }
        for (const OptionFacts& option : one.options) text += fish_option(head, option);
    }
    return text;
}

}  // namespace

std::string completion(const CLI::App& program, Shell shell) {
    if (shell == Shell::bash) return bash(program);
    return shell == Shell::zsh ? zsh(program) : fish(program);
}

}  // namespace burl
