// The program `burl`: the command line with its verbs, errors as one sentence, and exit codes
// (docs/reference/usage.md).
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/base/atomic_file.h"
#include "app/base/messages.h"
#include "app/base/out_of_memory.h"
#include "app/base/version.h"
#include "app/main/verbs.h"
#include "app/options/command_options.h"
#include "atlas/base/error.h"

namespace {

constexpr std::string_view out_of_memory = "burl: out of memory; try a smaller --size or mesh\n";

/// Opens /dev/null for a closed stdin, stdout or stderr. Otherwise an output file might get its
/// descriptor, and messages would go into that file.
void open_standard_streams() {
    for (int opened = 0; opened >= 0 && opened <= STDERR_FILENO;) {
        opened = ::open("/dev/null", O_RDWR);
        if (opened > STDERR_FILENO) ::close(opened);
    }
}

/// Prints a sentence on stderr with the program's name in front.
void say(std::string_view sentence) {
    burl::warn(fmt::format("burl: {}", sentence));
}

/// The sentence about an option on the verb's command line that the verb does not have, with the
/// verb that has it, or the nearest one; empty where there is none.
std::string unknown_option(const CLI::App& program, const CLI::App& verb) {
    const std::vector<std::string> unknown = verb.remaining();
    const auto found = std::ranges::find_if(
        unknown, [](const std::string& word) { return word.size() > 1 && word[0] == '-'; });
    if (found == unknown.end()) return "";
    const std::string name = found->substr(0, found->find('='));
    if (program.get_option_no_throw(name) != nullptr)
        return fmt::format("{} is asked of burl itself, without a verb ", name);
    for (const CLI::App* other : program.get_subcommands([](const CLI::App*) { return true; }))
        if (other->get_option_no_throw(name) != nullptr)
            return fmt::format("{} is no option of burl {}, but of burl {} ", name, verb.get_name(),
                               other->get_name());
    return fmt::format("there is no option {}; {}", name,
                       burl::did_you_mean(name, burl::option_names(verb)));
}

/// The sentence about a long option behind one dash, as -size, which counts as the value ize of -s;
/// empty where there is none.
std::string one_dash(const CLI::App& verb, std::span<char*> arguments) {
    const std::vector<std::string> names = burl::option_names(verb);
    for (const std::string_view word : arguments) {
        const std::string name = fmt::format("-{}", word.substr(0, word.find('=')));
        if (word.starts_with('-') && !word.starts_with("--") && std::ranges::count(names, name))
            return fmt::format("{} has two dashes: {} ", name.substr(1), name);
    }
    return {};
}

/// The sentence about a wrong option or argument of a verb.
std::string wrong_argument(const CLI::App& verb, const CLI::ParseError& wrong) {
    const std::string said = wrong.what(), name = said.substr(0, said.find(':'));
    if (said.ends_with(" missing")) return name + " needs a value ";
    if (said.find("At Most") != std::string::npos) return name + " is given more than once ";
    const std::vector<std::string> left = verb.remaining();
    if (left.empty()) return said + " ";
    return fmt::format("nothing takes \"{}\"; lists have commas without spaces{} ", left[0],
                       verb.get_name() == "bake" ? ", and burl batch takes several meshes" : "");
}

/// The sentence about a wrong command line, and the help to read.
std::string usage_sentence(const CLI::App& program, const CLI::ParseError& wrong,
                           std::span<char*> arguments) {
    const std::vector<CLI::App*> chosen = program.get_subcommands();
    if (!chosen.empty()) {
        std::string sentence = unknown_option(program, *chosen[0]);
        if (sentence.empty()) sentence = one_dash(*chosen[0], arguments);
        if (sentence.empty()) sentence = wrong_argument(*chosen[0], wrong);
        return fmt::format("{}(try `burl {} --help`)", sentence, chosen[0]->get_name());
    }
    if (arguments.size() < 2 || program.get_option_no_throw(arguments[1]) != nullptr)
        return "a verb is missing (try `burl --help`)";
    std::vector<std::string> verbs;
    for (const CLI::App* verb :
         program.get_subcommands([](const CLI::App* one) { return !one->get_group().empty(); }))
        verbs.push_back(verb->get_name());
    std::vector<std::string> words = burl::option_names(program);
    words.insert(words.end(), verbs.begin(), verbs.end());
    return fmt::format("there is no verb or option '{}'; {}the verbs are {} (try `burl --help`)",
                       arguments[1], burl::did_you_mean(arguments[1], words),
                       fmt::join(verbs, ", "));
}

/// Adds the verbs and the version to the program.
void set_up(CLI::App& program) {
    program.name("burl");
    program.set_version_flag("--version", [] { return burl::version_text(); });
    program.require_subcommand(1);
    program.get_formatter()->column_width(34);
    burl::add_bake(program);
    burl::add_render(program);
    burl::add_batch(program);
    burl::add_diff(program);
    burl::add_metrics(program);
    burl::add_bench(program);
    burl::add_eval(program);
    burl::add_figures(program);
    burl::add_page(program);
    burl::add_list(program);
    burl::add_show(program);
    burl::add_manual(program);
}

/// Runs the verb, reports errors and returns the exit code. A wrong command line gives one sentence
/// on stderr, help goes to stdout. Failures of stdout are left for main to report.
int run(int argc, char** argv) {
    try {
        CLI::App program{
            "Burl carves triangle meshes out of procedural wood, marble, stone, cloud and fire."};
        set_up(program);
        try {
            program.parse(argc, argv);
        } catch (const CLI::Success& asked) {
            std::ostringstream text;
            program.exit(asked, text, text);
            fmt::print("{}", text.str());
        } catch (const CLI::ParseError& wrong) {
            say(usage_sentence(program, wrong, {argv, std::size_t(argc)}));
            return static_cast<int>(burl::ExitCode::usage);
        }
        return 0;
    } catch (const burl::Error& error) {
        if (*error.what() != '\0') say(error.what());
        return static_cast<int>(error.code());
    } catch (const std::bad_alloc&) {
        say("out of memory; try a smaller --size or mesh");
    } catch (const std::exception& error) {
        if (std::ferror(stdout) != 0) return 0;
        say(error.what());
    }
    return static_cast<int>(burl::ExitCode::runtime);
}

/// Whether stdout is a pipe that no process reads any more.
bool reader_left() {
    pollfd state{STDOUT_FILENO, POLLOUT, 0};
    return ::poll(&state, 1, 0) == 1 && (state.revents & (POLLERR | POLLHUP)) != 0;
}

/// Ends the program by SIGPIPE, without a message, as other programs end before `| head -1`.
[[noreturn]] void end_by_sigpipe() {
    std::signal(SIGPIPE, SIG_DFL);
    std::raise(SIGPIPE);
    std::_Exit(128 + SIGPIPE);  // reached where the signal is blocked
}

/// The exit code with stdout taken into account: results that could not be written are an error,
/// unless an earlier error has been reported.
int code_with_results(int code) {
    const bool arrived = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
    const bool told = code != 0 && code != static_cast<int>(burl::ExitCode::difference);
    if (arrived || told) return code;
    if (reader_left()) end_by_sigpipe();
    say("the results cannot be written to stdout; make room there, or send them elsewhere");
    return static_cast<int>(burl::ExitCode::io);
}

}  // namespace

int main(int argc, char** argv) {
    open_standard_streams();
    // Without SIGPIPE a broken pipe is a write error, so that the program still writes its other
    // files and messages; without SIGXFSZ a file-size limit is a write error, too.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    burl::end_where_memory_ends(out_of_memory);
    burl::clean_up_on_signals();
    return code_with_results(run(argc, argv));
}
