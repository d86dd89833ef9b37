// `burl manual`: pages for man and completions of shells, for those who package Burl.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/base/messages.h"
#include "app/main/verbs.h"
#include "app/options/command_options.h"
#include "app/options/manual.h"
#include "app/options/option_facts.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

struct ManualCommand {
    std::string form, verb;
};

/// The end of a sentence about a verb that there is not.
std::string hint_of_verb(const std::vector<const CLI::App*>& verbs, const std::string& name) {
    std::vector<std::string> names;
    for (const CLI::App* verb : verbs) names.push_back(verb->get_name());
    const std::string_view nearest = nearest_word(name, names);
    return nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest);
}

/// The page of section 1 of the program, or of a verb by its name.
std::string page_of(const CLI::App& program, const std::string& name) {
    if (name.empty()) return program_page(program);
    const std::vector<const CLI::App*> verbs = verbs_of(program);
    const auto found =
        std::ranges::find(verbs, name, [](const auto* verb) { return verb->get_name(); });
    if (found == verbs.end())
        throw Error(ExitCode::usage, fmt::format("manual: there is no verb '{}'{}", name,
                                                 hint_of_verb(verbs, name)));
    return verb_page(program, **found);
}

void run(const CLI::App& program, const ManualCommand& command) {
    if (!command.verb.empty() && command.form != "man")
        throw Error(ExitCode::usage, fmt::format("manual: {} is of the whole program; leave \"{}\" "
                                                 "out",
                                                 command.form, command.verb));
    if (command.form == "verbs")
        for (const CLI::App* verb : verbs_of(program)) fmt::print("{}\n", verb->get_name());
    else if (command.form == "man")
        fmt::print("{}", page_of(program, command.verb));
    else if (command.form == "recipe")
        fmt::print("{}", recipe_page());
    else
        fmt::print("{}", completion(program, *enum_named<Shell>(command.form)));
}

}  // namespace

void add_manual(CLI::App& program) {
    auto command = std::make_shared<ManualCommand>();
    CLI::App* verb =
        program.add_subcommand("manual", "Print a page for man, or a shell's completion");
    verb->group("");  // not among what a texture's maker needs
    verb->add_option("form", command->form,
                     "man (of VERB, or the program), recipe (its page of section 5), verbs (their "
                     "names), or a shell")
        ->required()
        ->check(one_of({"man", "recipe", "verbs", "bash", "zsh", "fish"}));
    verb->add_option("verb", command->verb, "man: the verb");
    verb->callback([&program, command] { run(program, *command); });
}

}  // namespace burl
