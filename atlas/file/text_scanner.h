#pragma once
// Tokens and numbers of line-based text formats (OBJ, OFF, ascii PLY and STL), with the line number
// every message needs. Numbers go through std::from_chars: locale-free and correctly rounded, so
// coordinates keep double precision.
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "atlas/base/stop.h"
#include "atlas/base/utf8.h"
#include "atlas/file/file_buffer.h"

namespace burl {

/// Largest absolute value of a coordinate that the readers take: beyond it squared areas would
/// overflow a double.
inline constexpr double largest_coordinate = 1e100;

/// A place in a text that moves forward token by token, counting lines.
class TextScanner {
  public:
    /// Scans `buffer` (which must outlive the scanner) from byte `begin`, counting lines from
    /// `line`; a `\` before a line end joins lines when `continuation` is set.
    explicit TextScanner(const FileBuffer& buffer, bool continuation = false, std::size_t begin = 0,
                         std::size_t line = 1)
        : path_(&buffer.path),
          stop_(&buffer.stop),
          start_(buffer.bytes.get()),
          at_(buffer.bytes.get() + begin),
          end_(buffer.bytes.get() + buffer.size),
          line_(line),
          continuation_(continuation) {}

    std::size_t line() const { return line_; }
    const std::string& path() const { return *path_; }
    /// Offset of the current byte from the start of the file.
    std::size_t offset() const { return static_cast<std::size_t>(at_ - start_); }
    std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - at_); }

    /// Moves to the next token of this line; false at the line's end or at a comment ('#').
    bool more_on_line() {
        skip_blanks();
        return at_ != end_ && *at_ != '\n' && *at_ != '#';
    }

    /// Moves to the start of the next line; false when the text is over. Throws Error(runtime)
    /// soon after the buffer's stop is requested.
    bool next_line() {
        while (at_ != end_ && *at_ != '\n') skip_inside_line();
        if (at_ == end_) return false;
        ++at_;
        if ((++line_ & (lines_to_look - 1)) == 0) check_stop(*stop_);
        return true;
    }

    /// Moves to the next token on this or a later line; false when the text is over.
    bool more() {
        while (!more_on_line())
            if (!next_line()) return false;
        return true;
    }

    /// The next token of this line, empty at its end.
    std::string_view word() {
        if (!more_on_line()) return {};
        const char* begin = at_;
        while (at_ != end_ && !ends_token(*at_)) ++at_;
        if (at_ == begin) ++at_;  // a lone `\` is a token, so that scanning always moves on
        return {begin, static_cast<std::size_t>(at_ - begin)};
    }

    /// All that is left of this line and those joined to it, as as_one_line() gives it, such as a
    /// name with spaces; the scanner stays where it is.
    std::string rest_of_line() const;

    /// The next number of this line. Throws Error when it is missing, no number, or not finite;
    /// `what` names it in the message ("a vertex coordinate").
    double number(const char* what) {
        if (!more_on_line()) fail_missing(what);
        double value = 0.0;
        const char* begin = at_ + (*at_ == '+' && at_ + 1 != end_ && at_[1] != '-');
        const auto [stop, error] = std::from_chars(begin, end_, value);
        if (error != std::errc{} || !(stop == end_ || ends_token(*stop)) || !std::isfinite(value))
            return slow_number(what);
        at_ = stop;
        return value;
    }

    /// The next number of this line as a coordinate. Throws Error in the cases of number(), and for
    /// an absolute value above largest_coordinate, which no geometry can use.
    double coordinate() {
        const double value = number("a coordinate");
        if (!(std::abs(value) <= largest_coordinate)) fail_too_large(value);
        return value;
    }

    /// The next whole number of this line, of either sign. Throws Error when it is missing or no
    /// whole number; `what` names it in the message.
    std::int64_t integer(const char* what) {
        if (!more_on_line()) fail_missing(what);
        std::int64_t value = 0;
        const char* begin = at_ + (*at_ == '+' && at_ + 1 != end_ && at_[1] != '-');
        const auto [stop, error] = std::from_chars(begin, end_, value);
        if (error != std::errc{} || !(stop == end_ || ends_token(*stop))) fail_bad(what);
        at_ = stop;
        return value;
    }

    /// Reads a whole number at the current byte without checking where it ends (OBJ's 1/2/3);
    /// false, without moving, where there is none.
    bool raw_integer(std::int64_t& value) {
        const auto [stop, error] = std::from_chars(at_, end_, value);
        if (error != std::errc{}) return false;
        at_ = stop;
        return true;
    }
    /// Moves past the next byte if it is `c`; returns whether it did.
    bool take(char c) {
        if (at_ == end_ || *at_ != c) return false;
        ++at_;
        return true;
    }
    bool at_token_end() const { return at_ == end_ || ends_token(*at_); }

    /// Throws Error(invalid_file) with this line's number.
    [[noreturn]] void fail(const std::string& message) const;

  private:
    static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r' && c != '\n'); }
    bool ends_token(char c) const {
        return c == ' ' || (c >= '\t' && c <= '\r') || (c == '\\' && continuation_);
    }
    void skip_blanks() {
        while (at_ != end_ && (is_blank(*at_) || (*at_ == '\\' && joined_line())))
            skip_inside_line();
    }
    /// Moves past one byte, or past a joined line end.
    void skip_inside_line() {
        if (*at_ == '\\' && joined_line()) {
            at_ += at_[1] == '\r' ? 3 : 2;
            ++line_;
        } else {
            ++at_;
        }
    }
    /// Whether a line end follows the `\` at the current byte, so that it joins two lines.
    bool joined_line() const {
        if (!continuation_) return false;
        const char* next = at_ + 1;
        if (next != end_ && *next == '\r') ++next;
        return next != end_ && *next == '\n';
    }
    double slow_number(const char* what);
    [[noreturn]] void fail_missing(const char* what) const;
    [[noreturn]] void fail_bad(const char* what) const;
    [[noreturn]] void fail_too_large(double value) const;
    std::string_view token_here() const;

    /// The lines after which a request to stop is looked for.
    static constexpr std::size_t lines_to_look = 4096;

    const std::string* path_;
    const std::stop_token* stop_;
    const char* start_;
    const char* at_;
    const char* end_;
    std::size_t line_;
    bool continuation_;
};

/// Offset of the text's first byte, behind a UTF-8 byte order mark where there is one. Throws Error
/// for UTF-16 text, which no reader takes.
std::size_t text_begin(const FileBuffer& buffer);

/// The line, which may go on over several that are joined to it, as one: a blank stands for every
/// `\` with its line end, and there are no blanks at its ends.
std::string as_one_line(std::string_view line);

/// The beginning of a token as messages quote it.
inline std::string printable(std::string_view token, std::size_t longest = 40) {
    return legible(token, longest);
}

}  // namespace burl
