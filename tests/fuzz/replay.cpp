// burl_replay TARGET [SECONDS | FILE | FOLDER]: reads all first inputs of a target, then for so
// many seconds mutations of them, the same ones in every run; or reads the file alone; or writes
// the first inputs into the folder, for libFuzzer. Any compiler will do.
#include <chrono>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "tests/fuzz/mutate.h"
#include "tests/fuzz/target.h"

namespace burl::fuzz {
namespace {

using Clock = std::chrono::steady_clock;

/// The last input, which a sanitizer's report does not show.
class Current {
  public:
    explicit Current(std::string file) : file_(std::move(file)) {}

    void operator()(const Target& target, const std::string& bytes) {
        std::ofstream(file_, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
        const auto begin = Clock::now();
        run(target, bytes);
        const std::chrono::duration<double> taken = Clock::now() - begin;
        slowest_ = std::max(slowest_, taken.count());
        ++runs_;
    }
    void report() const { fmt::print("{} runs, the slowest {:.2f} s\n", runs_, slowest_); }

  private:
    std::string file_;
    double slowest_ = 0.0;
    std::size_t runs_ = 0;
};

int replay(const Target& target, double seconds) {
    const std::vector<std::string> inputs = first_inputs(target);
    Current current(fmt::format("{}.input", target.name));
    for (const std::string& bytes : inputs) current(target, bytes);
    const Mutator mutator(target);
    Random random(1);
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    while (Clock::now() < end) {
        std::string bytes = inputs.empty() ? "" : inputs[below(random, inputs.size())];
        current(target, mutator(std::move(bytes), target.most_bytes, random));
    }
    current.report();
    return inputs.empty() ? 1 : 0;
}

void write_inputs(const Target& target, const std::filesystem::path& folder) {
    int number = 0;
    for (const std::string& bytes : first_inputs(target))
        std::ofstream(folder / fmt::format("first-{:03}", number++), std::ios::binary)
            .write(bytes.data(), std::streamsize(bytes.size()));
}

int main_of(std::span<char*> arguments) {
    if (arguments.size() < 2) {
        for (const Target& target : all_targets()) fmt::print("{}\n", target.name);
        return 1;
    }
    const Target target = find_target(arguments[1]);
    const std::string what = arguments.size() > 2 ? arguments[2] : "0";
    if (!std::filesystem::exists(what)) return replay(target, std::atof(what.c_str()));
    if (std::filesystem::is_directory(what)) {
        write_inputs(target, what);
        return 0;
    }
    std::ifstream stream(what, std::ios::binary);
    run(target, {std::istreambuf_iterator<char>(stream), {}});
    return 0;
}

}  // namespace
}  // namespace burl::fuzz

int main(int count, char** arguments) {
    try {
        return burl::fuzz::main_of({arguments, std::size_t(count)});
    } catch (const std::exception& error) {
        fmt::print(stderr, "not an Error: {}\n", error.what());
        return 3;
    }
}
