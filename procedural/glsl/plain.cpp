#include "procedural/glsl/plain.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace burl {

namespace {

bool in_name(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Calls visit(name, begin, end) for the words that do not begin with a digit, in order.
template <class Visit>
void for_names(std::string_view text, Visit visit) {
    for (std::size_t begin = 0; begin < text.size();) {
        std::size_t end = begin;
        while (end < text.size() && in_name(text[end])) ++end;
        if (end == begin) {
            ++begin;
            continue;
        }
        if (std::isdigit(static_cast<unsigned char>(text[begin])) == 0)
            visit(text.substr(begin, end - begin), begin, end);
        begin = end;
    }
}

/// Calls visit(line) for every line, its line feed included.
template <class Visit>
void for_lines(std::string_view text, Visit visit) {
    while (!text.empty()) {
        const std::size_t length = std::min(text.find('\n'), text.size() - 1) + 1;
        visit(text.substr(0, length));
        text.remove_prefix(length);
    }
}

/// The text with only the second branch of every #if REAL_IS_DOUBLE.
std::string float_branches(std::string_view text) {
    std::string kept;
    bool conditional = false, dropped = false;
    for_lines(text, [&](std::string_view line) {
        if (line.starts_with("#if REAL_IS_DOUBLE")) {
            conditional = dropped = true;
        } else if (conditional && line.starts_with("#else")) {
            dropped = false;
        } else if (conditional && line.starts_with("#endif")) {
            conditional = dropped = false;
        } else if (!dropped) {
            kept += line;
        }
    });
    return kept;
}

struct Replacement {
    std::string_view name, by;
};
constexpr std::array replacements{
    Replacement{"real", "float"},       Replacement{"real2", "vec2"},
    Replacement{"real3", "vec3"},       Replacement{"real4", "vec4"},
    Replacement{"real_item", "float"},  Replacement{"real4_item", "vec4"},
    Replacement{"nearest_root", "sqrt"}};

/// The functions of numbers/real.glsl that do nothing to floats.
bool does_nothing(std::string_view name) {
    return name == "to_item" || name == "from_item";
}

/// The text in parentheses, which may have some in it, at the start of the text.
std::string_view bracketed(std::string_view text) {
    int depth = 0;
    std::size_t at = 0;
    do {
        depth += text[at] == '(' ? 1 : text[at] == ')' ? -1 : 0;
        ++at;
    } while (depth > 0 && at < text.size());
    return text.substr(1, at - 2);
}

/// Whether the text is an operand without an operator: a name, an element, a member, a call.
bool is_operand(std::string_view text) {
    return text.find(' ') == std::string_view::npos;
}

/// The length of a number in parentheses, such as "(0.5)", at the start of the text; 0 if there is
/// none.
std::size_t bracketed_number(std::string_view text) {
    if (!text.starts_with('(')) return 0;
    std::size_t end = 1;
    while (end < text.size() &&
           (std::isdigit(static_cast<unsigned char>(text[end])) != 0 || text[end] == '.'))
        ++end;
    return end > 1 && end < text.size() && text[end] == ')' ? end + 1 : 0;
}

/// A definition of a function, struct, uniform, macro or constants.
struct Definition {
    std::string text;  ///< text with comments
    std::string code;  ///< text without comments
    bool needed = false;
};

std::string_view without_comment(std::string_view line) {
    return line.substr(0, line.find("//"));
}

std::vector<Definition> definitions_of(std::string_view text) {
    std::vector<Definition> all;
    Definition open;
    int depth = 0;
    for_lines(text, [&](std::string_view line) {
        const std::string_view code = without_comment(line);
        const std::size_t last = code.find_last_not_of(" \n");
        if (last == std::string_view::npos && line.size() == 1 && open.code.empty()) {
            // After a blank line the comment before it belongs to no definition.
            open = {};
            return;
        }
        open.text += line;
        if (last == std::string_view::npos) return;
        open.code += code;
        for (const char c : code) depth += c == '{' || c == '(' ? 1 : c == '}' || c == ')' ? -1 : 0;
        const bool ends = open.code.starts_with('#') || code[last] == ';' || code[last] == '}';
        if (depth != 0 || !ends) return;
        all.push_back(std::move(open));
        open = {};
    });
    return all;
}

/// Calls visit(name) for the names that the definition is one of: a name stands before its body or
/// value and is not the type of a parameter.
template <class Visit>
void for_defined(const Definition& definition, Visit visit) {
    const std::string_view code = definition.code;
    if (code.starts_with("struct")) {
        const auto end = std::ranges::find_if_not(code.substr(7), in_name);
        return visit(std::string_view(code.begin() + 7, end));
    }
    const std::size_t body = code.find('{'), bracket = code.find('('), equals = code.find('=');
    const bool function = bracket < body && body != std::string_view::npos && bracket < equals;
    for_names(code.substr(0, body), [&](std::string_view word, std::size_t, std::size_t end) {
        const std::size_t next = code.find_first_not_of(' ', end);
        const char after = next == std::string_view::npos ? '\n' : code[next];
        const bool variable = after == '=' || after == ';' || after == ',' || after == '[' ||
                              code.starts_with("#define");
        if (function ? end == bracket : variable) visit(word);
    });
}

}  // namespace

std::string glsl_in_float(std::string_view text) {
    const std::string branches = float_branches(text);
    std::string plain;
    std::size_t done = 0;
    for_names(branches, [&](std::string_view name, std::size_t begin, std::size_t end) {
        if (begin < done) return;
        const std::string_view rest = std::string_view(branches).substr(end);
        const auto* known = std::ranges::find(replacements, name, &Replacement::name);
        if (known == replacements.end() && name != "exact" && !does_nothing(name)) return;
        plain += branches.substr(done, begin - done);
        done = end;
        if (does_nothing(name) && rest.starts_with('(')) {
            const std::string_view inside = bracketed(rest);
            const std::string inner = glsl_in_float(inside);
            plain += is_operand(inside) ? inner : fmt::format("({})", inner);
            done += inside.size() + 2;
        } else if (name == "exact") {
            done += rest.starts_with(' ') ? 1 : 0;
        } else if (const std::size_t number = name == "real" ? bracketed_number(rest) : 0) {
            plain += rest.substr(1, number - 2);
            done += number;
        } else {
            plain += known->by;
        }
    });
    return plain + branches.substr(done);
}

std::string glsl_needed_by(const std::vector<std::string>& roots, std::string_view text) {
    std::vector<Definition> all = definitions_of(text);
    std::multimap<std::string_view, Definition*> definitions;
    for (Definition& definition : all)
        for_defined(definition,
                    [&](std::string_view name) { definitions.emplace(name, &definition); });
    std::vector<std::string_view> names(roots.begin(), roots.end());
    while (!names.empty()) {
        const auto [first, last] = definitions.equal_range(names.back());
        names.pop_back();
        for (auto known = first; known != last; ++known) {
            if (std::exchange(known->second->needed, true)) continue;
            for_names(known->second->code, [&](std::string_view name, std::size_t, std::size_t) {
                names.push_back(name);
            });
        }
    }
    std::string kept;
    for (const Definition& definition : all)
        if (definition.needed) kept += (kept.empty() ? "" : "\n") + definition.text;
    return kept;
}

}  // namespace burl
