#pragma once
// All controls of a recipe as knobs with their dials, which of them turn, and the recipe's shader
// where they are turned.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/base/shader_numbers.h"
#include "app/export/emit_knobs.h"
#include "app/export/knob.h"

namespace burl {

/// The values of all dials.
using Dials = std::vector<double>;

/// The knobs of a recipe. A knob turns until it is made constant, with a reason.
class KnobDials {
  public:
    using ShaderOf = std::function<std::string(const Recipe&)>;

    /// Both must outlive this object.
    KnobDials(const Recipe& recipe, const ShaderOf& shader_of);

    std::size_t count() const { return dials_.size(); }
    const KnobDial& operator[](std::size_t dial) const { return dials_[dial]; }
    bool turns_any() const;
    bool turns(std::size_t dial) const { return why_[dials_[dial].knob].empty(); }

    /// Makes the control of a dial constant, since other values need another shader.
    void keep(std::size_t dial) { keep_knob(dials_[dial].knob); }
    /// Makes the last control that turns constant; there must be one.
    void keep_last();
    void keep_all();
    /// Makes the controls constant none of whose dials is `used`.
    void keep_idle(const std::vector<bool>& used);

    /// The shader of the recipe itself.
    std::string shader() const { return shader_of_(recipe_); }
    /// The shader where the dials have these values; none where that is no valid recipe. Constant
    /// controls keep the recipe's.
    std::optional<ShaderNumbers> shader_at(const Dials& dials) const;

    /// The definitions of the uniforms of controls that turn.
    std::string definitions() const;
    /// Names the constant controls in a shader's uniforms and notes.
    void tell_constants(KnobbedShader& shader) const;

  private:
    void keep_knob(std::size_t knob);

    const Recipe& recipe_;
    const ShaderOf& shader_of_;
    Json json_;
    std::vector<Knob> knobs_;
    std::vector<std::string> why_;  ///< why a control stays constant; empty where it is turned
    std::vector<KnobDial> dials_;
};

}  // namespace burl
