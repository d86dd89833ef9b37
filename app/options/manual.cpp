// Pages for man (man(7), groff).
#include "app/options/manual.h"

#include <cctype>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/base/version.h"
#include "app/options/option_facts.h"
#include "app/recipe/parameters.h"
#include "procedural/graph/table.h"

namespace burl {

namespace {

/// The text as roff shows it: backslashes, hyphens that can be copied, and no line that is a
/// request.
std::string roff(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool starts = i == 0 || text[i - 1] == '\n';
        if (starts && (text[i] == '.' || text[i] == '\'')) result += "\\&";
        if (text[i] == '\\')
            result += "\\e";
        else if (text[i] == '-')
            result += "\\-";
        else
            result += text[i];
    }
    return result;
}

std::string bold(std::string_view text) {
    return fmt::format("\\fB{}\\fR", roff(text));
}
std::string slanted(std::string_view text) {
    return fmt::format("\\fI{}\\fR", roff(text));
}

std::string in_capitals(std::string text) {
    for (char& c : text) c = char(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

/// The head of a page, up to its one-line description.
std::string page_head(const std::string& name, int section, const std::string& about) {
    return fmt::format(".TH {} {} \"\" \"Burl {}\" \"{}\"\n.SH NAME\n{} \\- {}\n",
                       roff(in_capitals(name)), section, burl_version(),
                       section == 1 ? "User Commands" : "File Formats", roff(name), roff(about));
}

/// An entry of a list: its head, in roff, and what is said about it.
std::string item(const std::string& head, std::string_view about) {
    return fmt::format(".TP\n{}\n{}\n", head, roff(about));
}

std::string option_item(const OptionFacts& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.names) names.push_back(bold(name));
    std::string head = fmt::format("{}", fmt::join(names, ", "));
    if (!option.value.empty()) head += ' ' + slanted(option.value);
    std::string about = option.about;
    if (!option.choices.empty()) about += fmt::format(" ({})", fmt::join(option.choices, ", "));
    if (!option.otherwise.empty()) about += fmt::format("; default {}", option.otherwise);
    return item(head, about);
}

std::string options_section(const CLI::App& app) {
    std::string arguments, options;
    for (const OptionFacts& option : facts_of(app))
        (option.positional ? arguments : options) += option_item(option);
    if (!arguments.empty()) arguments = ".SH ARGUMENTS\n" + arguments;
    return fmt::format("{}.SH OPTIONS\n{}", arguments, options);
}

std::string synopsis(const std::string& command, const CLI::App& app) {
    std::string text = fmt::format(".SH SYNOPSIS\n{} [{}]", bold(command), slanted("options"));
    for (const OptionFacts& option : facts_of(app))
        if (option.positional)
            text += option.required ? " " + slanted(option.names[0])
                                    : fmt::format(" [{}]", slanted(option.names[0]));
    return text + '\n';
}

constexpr std::string_view exit_codes = R"(.SH "EXIT STATUS"
.TP
0
All was done.
.TP
1
The command line is wrong.
.TP
2
A file or folder could not be read or written.
.TP
3
A file was read, but what it holds is wrong.
.TP
4
Any other failure.
.TP
5
What was asked for is valid, but cannot be done or kept.
.TP
7
.B burl diff
found more than its tolerance.
)";

}  // namespace

std::string program_page(const CLI::App& program) {
    const std::string name = program.get_name();
    std::string text = page_head(name, 1, program.get_description());
    const std::vector<const CLI::App*> verbs = verbs_of(program);
    if (verbs.empty()) return text + synopsis(name, program) + options_section(program);
    text += fmt::format(".SH SYNOPSIS\n{} {} [{}]\n.SH VERBS\n", bold(name), slanted("verb"),
                        slanted("options"));
    std::vector<std::string> pages;
    for (const CLI::App* verb : verbs) {
        text += item(bold(verb->get_name()), verb->get_description());
        pages.push_back(fmt::format(".BR {}\\-{} (1)", roff(name), roff(verb->get_name())));
    }
    return text + options_section(program) + std::string(exit_codes) +
           fmt::format(".SH \"SEE ALSO\"\n{},\n.BR burl\\-recipe (5)\n", fmt::join(pages, ",\n"));
}

std::string verb_page(const CLI::App& program, const CLI::App& verb) {
    const std::string name = program.get_name();
    return page_head(fmt::format("{}-{}", name, verb.get_name()), 1, verb.get_description()) +
           synopsis(fmt::format("{} {}", name, verb.get_name()), verb) + options_section(verb) +
           fmt::format(".SH \"SEE ALSO\"\n.BR {} (1),\n.BR burl\\-recipe (5)\n", roff(name));
}

std::string recipe_page() {
    std::string text = page_head("burl-recipe", 5, "what a texture and its material are, in JSON");
    text +=
        ".SH DESCRIPTION\nA recipe is a JSON object. Every parameter can be set on the command "
        "line "
        "by\n.BR \\-\\-set\n.IR path = value .\n.SH PARAMETERS\n";
    for (const RecipeParameter& parameter : parameters())
        text += item(bold(parameter.path), parameter.tip);
    text +=
        ".SH NODES\nThe texture is a tree of nodes, objects with their name under\n.BR node .\n";
    for (const NodeType& type : graph_table()) text += item(bold(type.name), type.text);
    return text + ".SH \"SEE ALSO\"\n.BR burl (1)\n";
}

}  // namespace burl
