// The rare paths of the text scanner: numbers that std::from_chars refuses, and error messages.
#include "atlas/file/text_scanner.h"

#include <algorithm>
#include <cstdlib>

#include "atlas/base/error.h"

namespace burl {

std::size_t text_begin(const FileBuffer& buffer) {
    const std::string_view text = buffer.text();
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
        throw invalid_file(buffer.path, 1, "this is UTF-16 text; save the file as UTF-8 or ASCII");
    return text.starts_with("\xef\xbb\xbf") ? 3 : 0;
}

std::string as_one_line(std::string_view line) {
    std::string joined;
    for (std::size_t at = 0; at < line.size(); ++at) {
        const std::string_view rest = line.substr(at);
        const bool joins = rest.starts_with("\\\n") || rest.starts_with("\\\r\n");
        joined += joins ? ' ' : rest.front();
        if (joins) at += rest[1] == '\r' ? 2 : 1;
    }
    const auto is_blank = [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); };
    while (!joined.empty() && is_blank(joined.back())) joined.pop_back();
    joined.erase(0, std::size_t(std::ranges::find_if_not(joined, is_blank) - joined.begin()));
    return joined;
}

std::string TextScanner::rest_of_line() const {
    TextScanner ahead = *this;
    while (ahead.at_ != end_ && *ahead.at_ != '\n') ahead.skip_inside_line();
    return as_one_line({at_, std::size_t(ahead.at_ - at_)});
}

void TextScanner::fail(const std::string& message) const {
    throw invalid_file(*path_, line_, message);
}

std::string_view TextScanner::token_here() const {
    const char* stop = at_;
    while (stop != end_ && !ends_token(*stop)) ++stop;
    return {at_, static_cast<std::size_t>(stop - at_)};
}

void TextScanner::fail_missing(const char* what) const {
    fail(fmt::format("expected {}, but the {} ends here", what, at_ == end_ ? "file" : "line"));
}

void TextScanner::fail_bad(const char* what) const {
    fail(fmt::format("expected {}, found '{}'", what, printable(token_here())));
}

void TextScanner::fail_too_large(double value) const {
    fail(fmt::format("the coordinate {:g} is too large; coordinates may reach 1e100", value));
}

// std::from_chars reports an underflow (1e-400) as an error, but such a number is a zero, not a bad
// file.
double TextScanner::slow_number(const char* what) {
    const std::string token(token_here());
    char* stop = nullptr;
    const bool plain = token.find_first_not_of("+-.0123456789eE") == std::string::npos;
    const double value = plain ? std::strtod(token.c_str(), &stop) : 0.0;
    const bool whole = plain && !token.empty() && stop == token.c_str() + token.size();
    if (!whole || !std::isfinite(value))
        fail_bad(fmt::format("{} (a finite number)", what).c_str());
    at_ += token.size();
    return value;
}

}  // namespace burl
