#include "app/recipe/recipe_names.h"

#include <algorithm>
#include <iterator>
#include <sstream>

#include "app/recipe/presets.h"
#include "atlas/base/error.h"
#include "atlas/base/glob.h"

namespace burl {

namespace {

void append_once(std::string name, std::vector<std::string>& names) {
    if (std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
}

/// Appends the presets and materials whose names the pattern fits.
void append_matches(const std::string& pattern, std::vector<std::string>& names) {
    std::vector<std::string_view> known = preset_names();
    std::ranges::copy(material_names(), std::back_inserter(known));
    bool any = false;
    for (const std::string_view name : known) {
        if (!matches_glob(name, pattern)) continue;
        append_once(std::string(name), names);
        any = true;
    }
    if (!any)
        throw Error(ExitCode::usage,
                    fmt::format("--recipes: no recipe or material has a name like \"{}\" (`burl "
                                "list recipes`, `burl list materials`)",
                                pattern));
}

}  // namespace

std::vector<std::string> recipes_named(const std::vector<std::string>& texts) {
    std::vector<std::string> names;
    for (const std::string& text : texts) {
        std::istringstream list(text + ",");
        for (std::string name; std::getline(list, name, ',');) {
            if (name.empty())
                throw Error(ExitCode::usage, fmt::format("--recipes: \"{}\" has an empty name; "
                                                         "write names with commas between them",
                                                         text));
            if (name.find_first_of("*?") == std::string::npos)
                append_once(std::move(name), names);
            else
                append_matches(name, names);
        }
    }
    return names;
}

}  // namespace burl
