#pragma once
// The options of `--synth gl-multipass`, which evaluates the papers' passes over whole images.
#include <string>

#include "procedural/passes/plan.h"

namespace CLI {
class App;
}

namespace burl {

inline constexpr const char* multipass_synth = "gl-multipass";

class MultipassCommand {
  public:
    /// Adds --gl-precision, --gl-randomizer and --gl-equalize.
    void add(CLI::App& verb);
    /// The passes' options. Throws Error(usage) where one is given without `--synth gl-multipass`.
    MultipassOptions options(const std::string& synth) const;

  private:
    std::string precision_, randomizer_;
    bool equalize_ = false;
};

}  // namespace burl
