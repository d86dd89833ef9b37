#pragma once
// A shader's numbers while its recipe's dials are turned one by one from a base, or several at
// once.
#include <map>
#include <optional>
#include <vector>

#include "app/export/knob_dials.h"

namespace burl {

/// The numbers of a shader while one dial has a value.
struct KnobSample {
    double value = 0.0;
    std::vector<double> numbers;
};

/// The shader at a base, none of whose dials has a special value as far as such a recipe is valid,
/// and what turning them makes of it.
class KnobSamples {
  public:
    /// Finds the base. `dials` must outlive this object.
    explicit KnobSamples(const KnobDials& dials);

    const Dials& at_base() const { return at_base_; }
    const ShaderNumbers& base() const { return base_; }

    /// Samples the shader over a dial; false where more than its numbers change.
    bool sample(std::size_t dial);
    const std::vector<KnobSample>& of(std::size_t dial) const { return samples_[dial]; }
    /// Whether the number changes where the dial is turned.
    bool follows(std::size_t number, std::size_t dial) const;
    /// The shader's numbers where some dials have other values; empty where that is no such shader.
    const std::vector<double>& corner(const std::map<std::size_t, double>& turned);

  private:
    std::optional<ShaderNumbers> shader_with(std::size_t dial, double value) const;

    const KnobDials& dials_;
    Dials at_base_;
    ShaderNumbers base_;
    std::vector<std::vector<KnobSample>> samples_;  ///< those of each dial
    std::map<std::map<std::size_t, double>, std::vector<double>> corners_;
};

}  // namespace burl
