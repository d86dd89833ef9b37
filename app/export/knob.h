#pragma once
// Controls of a recipe (app/recipe/edit/controls.h) as uniforms of an emitted shader.
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/recipe/edit/controls.h"
#include "app/recipe/recipe.h"

namespace burl {

/// A number that a control's value is to what it sets, and its expression in GLSL.
struct KnobVariable {
    std::string name;                    ///< a name, or an expression in parentheses
    std::function<double(double)> of{};  ///< its value, from the dial's
};

/// A number that a person turns by itself: a control's value, or a component of its colour, 0 to
/// 255.
struct KnobDial {
    std::size_t knob = 0;           ///< index of the control
    double present = 0.0;           ///< the recipe's own value
    std::vector<double> samples{};  ///< values all over the range, none of them special; the first
                                    ///< of them stands for the others while another dial is turned
    double nudge = 0.0;             ///< a step to another value beside a sample
    std::vector<KnobVariable> variables{};
};

/// A control as a uniform.
class Knob {
  public:
    Knob(ControlState state, std::string uniform)
        : state_(std::move(state)), uniform_(std::move(uniform)) {}

    /// The dials, of the control with this number. Their variables are the value, and the formulas
    /// of it.
    std::vector<KnobDial> dials(std::size_t number, const Json& recipe) const;
    /// The setting "NAME=VALUE" that gives its dials these values.
    std::string setting(std::span<const double> dials) const;
    /// The uniform's definition after a comment with name, range and sentence.
    std::string definition() const;
    /// The control's name, and its value as text.
    const std::string& name() const { return state_.control.name; }
    std::string value() const;
    /// The path of a number that does not follow the control now, since it was set by itself; empty
    /// where all do.
    std::string left_behind(const Json& recipe) const;

  private:
    bool is_color() const { return state_.value.is_string(); }
    std::vector<KnobDial> color_dials(std::size_t number) const;

    ControlState state_;
    std::string uniform_;
};

/// The controls of a recipe as knobs. Names of uniforms are `knob_` and the control's name in small
/// letters, with an underscore for what names of GLSL may not have.
std::vector<Knob> knobs_of(const Json& recipe);

/// The text in printable ASCII without backslashes, as a comment of GLSL 3.30 may have it.
std::string in_glsl_comment(std::string text);

}  // namespace burl
