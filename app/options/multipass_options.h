#pragma once
// The papers' passes as the command line describes them: what `--synth gl-multipass` takes.
#include <string>

#include "procedural/passes/plan.h"

namespace CLI {
class App;
}

namespace burl {

inline constexpr const char* multipass_synth = "gl-multipass";

class MultipassCommand {
  public:
    /// --gl-precision, --gl-randomizer and --gl-equalize.
    void add(CLI::App& verb);
    /// Throws Error(usage) where one of them is given without `--synth gl-multipass`.
    MultipassOptions options(const std::string& synth) const;

  private:
    std::string precision_, randomizer_;
    bool equalize_ = false;
};

}  // namespace burl
