// A program that uses the library and goes on after failures: library_user OUT [THREADS].
// It does the same work twice. A failure of the library must be an exception; then the second time,
// with memory again, must succeed. Exit code 0: the work was done at last; 4: it failed twice.
// Every failure is a line on stderr. Anything else is an end of the process that its owner did not
// want.
#include <burl/bake.h>
#include <burl/evaluate.h>
#include <burl/metrics.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <new>
#include <string_view>

namespace {

/// Writes a line on stderr without memory.
void say(const char* sentence) {
    const std::string_view line(sentence, std::strlen(sentence));
    [[maybe_unused]] const auto told =
        ::write(STDERR_FILENO, line.data(), line.size()) + ::write(STDERR_FILENO, "\n", 1);
}

/// Everything that the library does, on the caller's thread or on `threads` others, which tell how
/// far they are; the files are those of OUT.
void use(const char* out, int threads) {
    const auto told = [](const burl::ProgressState& state) { return state.share >= 0.0; };
    const double points[] = {0.1, 0.2, 0.3};
    const burl::Mesh mesh = burl::Mesh::read("sample:cube");
    const burl::Recipe recipe = burl::Recipe::load("oak").set("atlas.size", 16.0);
    if (burl::Recipe::parse(recipe.to_json()).to_json() != recipe.to_json()) say("another recipe");
    if (burl::evaluate(recipe, points).values.size() != 1) say("no value");
    burl::MetricsOptions measured;
    measured.size = 32;
    if (threads > 0) measured.progress = told;
    if (burl::number_at(burl::metrics(mesh, recipe, measured), "/atlases/0/size") != 32.0)
        say("no figures");
    burl::BakeOptions options;
    options.size = 16;
    options.threads = threads > 0 ? threads : 1;
    if (threads > 0) options.progress = told;
    burl::write(burl::bake(mesh, recipe, options), out);
}

/// Whether the work was done; a failure is told.
bool done(const char* out, int threads) {
    try {
        use(out, threads);
        return true;
    } catch (const std::bad_alloc&) {
        say("std::bad_alloc");
    } catch (const burl::Error& error) {
        say(error.what());
    }
    return false;
}

}  // namespace

int main(int count, char** words) {
    if (count < 2) return 1;
    const int threads = count > 2 ? std::atoi(words[2]) : 0;
    return done(words[1], threads) || done(words[1], threads) ? 0 : 4;
}
