// The program `burl`: verbs in, one sentence and an exit code out (docs/usage.md).
#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "app/atomic_file.h"
#include "app/verbs.h"
#include "app/version.h"
#include "atlas/error.h"

namespace {

/// A closed stdin, stdout or stderr would lend its number to an output file, and messages would go
/// into that.
void open_standard_streams() {
    for (int opened = 0; opened >= 0 && opened <= STDERR_FILENO;) {
        opened = ::open("/dev/null", O_RDWR);
        if (opened > STDERR_FILENO) ::close(opened);
    }
}

/// Unlike fmt::print it never throws: nobody could be told.
void say(std::string_view sentence) {
    const std::string line = fmt::format("burl: {}\n", sentence);
    std::fwrite(line.data(), 1, line.size(), stderr);
}

/// What is wrong with a command line, and which help to read.
std::string usage_sentence(const CLI::App& program, const CLI::ParseError& wrong,
                           std::span<char*> arguments) {
    const std::vector<CLI::App*> chosen = program.get_subcommands();
    if (!chosen.empty())
        return fmt::format("{} (try `burl {} --help`)", wrong.what(), chosen[0]->get_name());
    if (arguments.size() < 2 || program.get_option_no_throw(arguments[1]) != nullptr)
        return "a verb is missing (try `burl --help`)";
    std::vector<std::string> verbs;
    for (const CLI::App* verb : program.get_subcommands([](const CLI::App*) { return true; }))
        verbs.push_back(verb->get_name());
    return fmt::format("there is no verb or option '{}'; the verbs are {} (try `burl --help`)",
                       arguments[1], fmt::join(verbs, ", "));
}

/// Results that did not reach stdout are an error, as a file that could not be written.
void flush_results() {
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
    throw burl::Error(burl::ExitCode::io, "the results cannot be written to stdout");
}

/// A verb, at most one usage sentence for a wrong line, help on stdout.
int run(int argc, char** argv) {
    CLI::App program{
        "Burl carves triangle meshes out of procedural wood, marble, stone, cloud and fire."};
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
    burl::add_list(program);
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& asked) {
        return program.exit(asked);
    } catch (const CLI::ParseError& wrong) {
        say(usage_sentence(program, wrong, {argv, std::size_t(argc)}));
        return static_cast<int>(burl::ExitCode::usage);
    }
    flush_results();
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    open_standard_streams();
    // A reader that went away or a file-size limit is an error to report, not a reason to die.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    burl::clean_up_on_signals();
    try {
        return run(argc, argv);
    } catch (const burl::Error& error) {
        if (*error.what() != '\0') say(error.what());
        return static_cast<int>(error.code());
    } catch (const std::bad_alloc&) {
        say("out of memory; try a smaller --size or mesh");
    } catch (const std::exception& error) {
        say(error.what());
    }
    return static_cast<int>(burl::ExitCode::runtime);
}
