#pragma once
// The command line in the forms that systems install: pages for man, and completions for shells.
// All of it is made of the programs' own options and of the tables of parameters and nodes.
#include <string>

#include "atlas/base/enum_names.h"

namespace CLI {
class App;
}

namespace burl {

/// The page of section 1 of a program, which lists its verbs, or of one of its verbs.
std::string program_page(const CLI::App& program);
std::string verb_page(const CLI::App& program, const CLI::App& verb);

/// The page of section 5 about recipes: all parameters and nodes.
std::string recipe_page();

/// A shell with completions.
enum class Shell { bash, zsh, fish };
template <>
inline constexpr auto enum_names<Shell> = enum_words("bash", "zsh", "fish");

/// The file by which the shell completes the program's verbs, options, their choices and the names
/// of recipes.
std::string completion(const CLI::App& program, Shell shell);

}  // namespace burl
