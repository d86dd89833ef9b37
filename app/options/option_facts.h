#pragma once
// What a command line says of its options, for pages and completions.
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace burl {

/// An option, or an argument without a name of its own.
struct OptionFacts {
    std::vector<std::string> names;  ///< "-o" and "--output"; of an argument its name alone
    std::string value;               ///< the kind of its value, such as "TEXT"; empty: it has none
    std::vector<std::string> choices;
    std::string about;
    std::string otherwise;  ///< the default; empty: none
    bool positional = false, required = false;
};

/// The options of the program or verb, arguments first.
std::vector<OptionFacts> facts_of(const CLI::App& app);

/// The program's verbs that its help lists.
std::vector<const CLI::App*> verbs_of(const CLI::App& program);

}  // namespace burl
