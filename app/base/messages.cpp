#include "app/base/messages.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <mutex>
#include <numeric>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "atlas/base/utf8.h"

namespace burl {

namespace {

bool write_bytes(std::string_view bytes, std::FILE* stream) {
    return std::fwrite(bytes.data(), 1, bytes.size(), stream) == bytes.size();
}

/// The columns of the terminal that stderr is.
std::size_t terminal_columns() {
    winsize size{};
    const bool known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
    return known ? size.ws_col : 80;
}

/// The text's first characters.
std::string_view first_characters(std::string_view text, std::size_t count) {
    std::size_t end = 0;
    for (; count > 0 && end < text.size(); --count)
        end += std::max<std::size_t>(1, utf8_length(text.substr(end)));
    return text.substr(0, end);
}

/// The line of show_status(), which the process has once, as it has one terminal. The mutex is held
/// while anything is written to either.
struct StatusLine {
    std::mutex mutex;
    std::string text;

    void draw() const {
        if (!text.empty())
            write_bytes(std::string(first_characters(text, terminal_columns() - 1)), stderr);
    }
    void clear() const {
        if (!text.empty()) write_bytes("\r\x1b[K", stderr);
    }
};

/// The process's only line; never destroyed, since threads may speak during exit.
StatusLine& status_line() {
    static auto* const only = new StatusLine;
    return *only;
}

/// A line is shown up to so many bytes: names in files may be megabytes long.
constexpr std::size_t longest_line = 1200;

/// The printable line, without its middle where it is too long.
std::string shown(std::string_view line) {
    if (line.size() <= longest_line) return printable(line);
    constexpr std::size_t begin = 800, end = 300;
    return fmt::format("{} [{} bytes left out] {}", printable(line.substr(0, begin)),
                       line.size() - begin - end, printable(line.substr(line.size() - end)));
}

/// Writes a line above the status; whether it was written.
bool write_line(std::string_view line, std::FILE* stream) {
    StatusLine& status = status_line();
    const std::lock_guard lock(status.mutex);
    status.clear();
    bool written = write_bytes(shown(line) + "\n", stream);
    if (stream == stdout) written = std::fflush(stdout) == 0 && written;
    status.draw();
    return written;
}

/// Damerau's distance (CACM 7, 1964): insertions, deletions and replacements of single characters,
/// and exchanges of neighbours.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1), above(row), second(row);
    std::iota(row.begin(), row.end(), std::size_t(0));
    for (std::size_t i = 1; i <= a.size(); ++i) {
        second.swap(above);
        above.swap(row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] =
                std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], second[j - 2] + 1);
        }
    }
    return row[b.size()];
}

}  // namespace

std::string printable(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        const std::string_view character = text.substr(0, length == 0 ? 1 : length);
        text.remove_prefix(character.size());
        if (length > 0 && !commands_terminals(character)) {
            result += character;
            continue;
        }
        // The second byte of a C1 character is its code; its first, 0xc2, adds nothing.
        const auto code = static_cast<unsigned char>(character.back());
        result += fmt::format("\\x{:02x}", code);
    }
    return result;
}

void print_line(std::string_view line) {
    if (!write_line(line, stdout))
        throw std::system_error(errno, std::generic_category(),
                                "a line cannot be written to stdout");
}

void warn(std::string_view sentence) {
    write_line(sentence, stderr);
}

void show_status(std::string_view line) {
    StatusLine& status = status_line();
    const std::lock_guard lock(status.mutex);
    status.clear();
    status.text = printable(line);
    status.draw();
}

std::string names_together(std::span<const std::string> names) {
    constexpr std::size_t most = 4;
    const std::size_t count = std::min(names.size(), most);
    std::string text = count > 0 ? names[0] : "";
    for (std::size_t i = 1; i < count; ++i)
        text += (i + 1 == names.size() ? " and " : ", ") + names[i];
    if (names.size() > most) text += fmt::format(" and {} more", names.size() - most);
    return text;
}

std::string_view nearest_word(std::string_view word, std::span<const std::string> candidates) {
    const std::vector<std::string_view> views(candidates.begin(), candidates.end());
    return nearest_word(word, views);
}

std::string_view nearest_word(std::string_view word, std::span<const std::string_view> candidates) {
    std::string_view nearest;
    std::size_t best = std::string_view::npos;
    for (const std::string_view candidate : candidates) {
        const std::size_t distance = edit_distance(word.substr(0, 200), candidate);
        if (distance < best && 2 * distance <= std::max(word.size(), candidate.size()))
            best = distance, nearest = candidate;
    }
    return nearest;
}

}  // namespace burl
