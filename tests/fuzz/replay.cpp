// burl_replay TARGET [SECONDS [SEED] | FILE | FOLDER]: reads all first inputs of a target, then for
// so many seconds mutations of them, the same ones in every run with the same seed; or reads the
// file alone; or writes the first inputs into the folder, for libFuzzer. Inputs that end in
// another exception than Error are kept as TARGET.found-N, the slowest of those that take over a
// second as TARGET.slow, and the one that is read as TARGET.input, which stays where a sanitizer
// ends the program. Any compiler will do.
#include <algorithm>
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

void write(const std::string& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
}

/// Reads inputs one after the other, and counts what is wrong.
class Reading {
  public:
    explicit Reading(const Target& target) : target_(target) {}

    void operator()(const std::string& bytes) {
        write(file("input"), bytes);
        const auto begin = Clock::now();
        try {
            run(target_, bytes);
        } catch (const std::exception& error) {
            fmt::print("found-{}: not an Error: {}\n", found_, error.what());
            write(file(fmt::format("found-{}", found_++)), bytes);
        }
        const std::chrono::duration<double> taken = Clock::now() - begin;
        if (taken.count() > std::max(slowest_, 1.0)) write(file("slow"), bytes);
        slowest_ = std::max(slowest_, taken.count());
        ++runs_;
    }
    /// Whether nothing was found, after the last input.
    bool report() const {
        std::filesystem::remove(file("input"));
        fmt::print("{} runs, the slowest {:.2f} s, {} found\n", runs_, slowest_, found_);
        return found_ == 0 && runs_ > 0;
    }

  private:
    std::string file(const std::string& what) const {
        return fmt::format("{}.{}", target_.name, what);
    }

    const Target& target_;
    double slowest_ = 0.0;
    std::size_t runs_ = 0, found_ = 0;
};

int replay(const Target& target, double seconds, unsigned seed) {
    const std::vector<std::string> inputs = first_inputs(target);
    Reading read(target);
    for (const std::string& bytes : inputs) read(bytes);
    const Mutator mutator(target);
    Random random(seed);
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    while (!inputs.empty() && Clock::now() < end) {
        const std::string& bytes = inputs[below(random, inputs.size())];
        read(mutator(bytes, target.most_bytes, random));
    }
    return read.report() ? 0 : 1;
}

void write_inputs(const Target& target, const std::filesystem::path& folder) {
    int number = 0;
    for (const std::string& bytes : first_inputs(target))
        write((folder / fmt::format("first-{:03}", number++)).string(), bytes);
}

int main_of(std::span<char*> arguments) {
    if (arguments.size() < 2) {
        for (const Target& target : all_targets()) fmt::print("{}\n", target.name);
        return 1;
    }
    const Target target = find_target(arguments[1]);
    const std::string what = arguments.size() > 2 ? arguments[2] : "0";
    if (!std::filesystem::exists(what)) {
        const int seed = arguments.size() > 3 ? std::atoi(arguments[3]) : 1;
        return replay(target, std::atof(what.c_str()), unsigned(seed));
    }
    if (std::filesystem::is_directory(what)) {
        write_inputs(target, what);
        return 0;
    }
    std::ifstream stream(what, std::ios::binary);
    Reading read(target);
    read({std::istreambuf_iterator<char>(stream), {}});
    return read.report() ? 0 : 1;
}

}  // namespace
}  // namespace burl::fuzz

int main(int count, char** arguments) {
    try {
        return burl::fuzz::main_of({arguments, std::size_t(count)});
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 3;
    }
}
