// What libFuzzer calls. The target is the one that BURL_FUZZ names.
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <exception>

#include <fmt/format.h>

#include "tests/fuzz/mutate.h"
#include "tests/fuzz/target.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace burl::fuzz {
namespace {

Target named_target() {
    const char* name = std::getenv("BURL_FUZZ");
    try {
        return find_target(name ? name : "");
    } catch (const std::exception& error) {
        fmt::print(stderr, "BURL_FUZZ: {}\n", error.what());
        std::exit(1);
    }
}

const Target& target() {
    static const Target chosen = named_target();
    return chosen;
}

}  // namespace
}  // namespace burl::fuzz

extern "C" [[gnu::visibility("default")]] int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                                                     std::size_t size) {
    burl::fuzz::run(burl::fuzz::target(), {reinterpret_cast<const char*>(data), size});
    return 0;
}

extern "C" [[gnu::visibility("default")]] std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data,
                                                                              std::size_t size,
                                                                              std::size_t most,
                                                                              unsigned seed) {
    using namespace burl::fuzz;
    static const Mutator mutator(target());
    Random random(seed);
    if (below(random, 4) == 0) return LLVMFuzzerMutate(data, size, most);
    const std::string bytes = mutator({reinterpret_cast<const char*>(data), size}, most, random);
    std::memcpy(data, bytes.data(), bytes.size());
    return bytes.size();
}
