// Linked into every program that is built with -fsanitize-coverage=trace-pc, which g++ has: counts
// how often each place in the code runs, where libFuzzer looks for such counters. (It knows clang's
// own counters only, and its own function of this name ends the program.)
#include <cstddef>
#include <cstdint>

namespace {

constexpr std::size_t counter_bits = 17;

[[gnu::used,
  gnu::section(
      "__libfuzzer_extra_counters")]] std::uint8_t counters[std::size_t(1) << counter_bits];

}  // namespace

/// Called at the beginning of every basic block of instrumented code.
extern "C" [[gnu::visibility("default")]] void __sanitizer_cov_trace_pc() {
    const auto place = reinterpret_cast<std::uintptr_t>(__builtin_return_address(0));
    std::uint8_t& counter = counters[(place * 0x9e3779b97f4a7c15u) >> (64 - counter_bits)];
    counter = static_cast<std::uint8_t>(counter + (counter != 255));
}

/// Called where floating-point numbers are compared; libFuzzer has no use for them.
extern "C" [[gnu::visibility("default")]] void __sanitizer_cov_trace_cmpf(float, float) {}
extern "C" [[gnu::visibility("default")]] void __sanitizer_cov_trace_cmpd(double, double) {}
