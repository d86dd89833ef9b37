// The program `burl`: verbs in, one sentence and an exit code out (docs/usage.md).
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

#include <fmt/format.h>

#include "app/verbs.h"
#include "app/version.h"
#include "atlas/error.h"

namespace {

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
    burl::add_diff(program);
    burl::add_metrics(program);
    burl::add_bench(program);
    burl::add_list(program);
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& asked) {
        return program.exit(asked);
    } catch (const CLI::ParseError& wrong) {
        fmt::print(stderr, "burl: {} (try `burl --help`)\n", wrong.what());
        return static_cast<int>(burl::ExitCode::usage);
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    // A reader that went away or a file-size limit is an error to report, not a reason to die.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    try {
        return run(argc, argv);
    } catch (const burl::Error& error) {
        if (*error.what() != '\0') fmt::print(stderr, "burl: {}\n", error.what());
        return static_cast<int>(error.code());
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "burl: out of memory; try a smaller --size or mesh\n");
    } catch (const std::exception& error) {
        fmt::print(stderr, "burl: {}\n", error.what());
    }
    return static_cast<int>(burl::ExitCode::runtime);
}
