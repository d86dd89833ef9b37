#include "app/export/emit_knobs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "app/export/formula_glsl.h"
#include "app/export/knob.h"
#include "app/export/number_law.h"
#include "app/export/shader_numbers.h"
#include "app/recipe/edit/leaves.h"
#include "app/recipe/edit/recipe_json.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

/// More passes than this would each find another control that turns nothing alone.
constexpr int most_passes = 8, joint_samples = 3;

/// The values of all dials.
using Dials = std::vector<double>;

/// The numbers of a shader while one dial has a value.
struct Sample {
    double value = 0.0;
    std::vector<double> numbers;
};

/// The part of a number that follows one dial: a quantity of a variable.
struct DialPart {
    std::size_t dial = 0, variable = 0;
    SimpleLaw law;
};

std::vector<double> values_of(const ShaderNumbers& shader) {
    std::vector<double> values;
    for (const ShaderNumber& number : shader.numbers) values.push_back(number.value);
    return values;
}

/// The search for the laws of one recipe's shader.
class KnobSearch {
  public:
    KnobSearch(const Recipe& recipe, const std::function<std::string(const Recipe&)>& shader_of)
        : recipe_(recipe),
          shader_of_(shader_of),
          json_(slider_json(recipe)),
          knobs_(knobs_of(json_)),
          why_(knobs_.size()) {
        for (std::size_t i = 0; i < knobs_.size(); ++i) {
            for (KnobDial& dial : knobs_[i].dials(i, json_)) dials_.push_back(std::move(dial));
            const std::string path = knobs_[i].left_behind(json_);
            if (!path.empty()) why_[i] = fmt::format("since {} has been set apart from it", path);
        }
    }

    KnobbedShader run() {
        for (int pass = 0; turns_any() && pass < most_passes; ++pass)
            if (search()) return result();
        for (std::size_t i = 0; i < knobs_.size(); ++i) keep(i);
        KnobbedShader plain{"", shader_of_(recipe_), {}};
        tell_constants(plain);
        return plain;
    }

  private:
    bool turns_any() const {
        return std::ranges::any_of(why_, [](const std::string& why) { return why.empty(); });
    }
    bool turns(std::size_t dial) const { return why_[dials_[dial].knob].empty(); }

    /// Makes a control constant.
    void keep(std::size_t knob) {
        if (why_[knob].empty())
            why_[knob] = fmt::format(
                "since other values need another shader: emit it again with --set \"{}=VALUE\"",
                knobs_[knob].name());
    }
    void keep_last() {
        std::size_t last = knobs_.size();
        while (!why_[--last].empty()) continue;
        keep(last);
    }

    /// The shader where the dials have these values; none where that is no valid recipe.
    std::optional<ShaderNumbers> shader_at(const Dials& dials) const {
        std::vector<std::string> settings;
        for (std::size_t d = 0; d < dials_.size();) {
            const std::size_t knob = dials_[d].knob, begin = d;
            while (d < dials_.size() && dials_[d].knob == knob) ++d;
            if (why_[knob].empty())
                settings.push_back(
                    knobs_[knob].setting(std::span(dials).subspan(begin, d - begin)));
        }
        try {
            return shader_numbers(shader_of_(with_numbers(recipe_, settings)));
        } catch (const Error&) {
            return {};
        }
    }

    /// Finds a shader none of whose dials has a special value, as far as such a recipe is valid.
    void find_base() {
        at_base_.clear();
        for (const KnobDial& dial : dials_) at_base_.push_back(dial.samples[0]);
        std::optional<ShaderNumbers> shader = shader_at(at_base_);
        if (!shader) {
            const Dials wanted = at_base_;
            for (std::size_t d = 0; d < dials_.size(); ++d) at_base_[d] = dials_[d].present;
            for (std::size_t d = 0; d < dials_.size(); ++d) {
                at_base_[d] = wanted[d];
                if (!shader_at(at_base_)) at_base_[d] = dials_[d].present;
            }
            shader = shader_at(at_base_);
        }
        base_ = shader ? std::move(*shader) : shader_numbers(shader_of_(recipe_));
    }

    std::optional<ShaderNumbers> shader_with(std::size_t dial, double value) const {
        Dials dials = at_base_;
        dials[dial] = value;
        return shader_at(dials);
    }

    /// Samples the shader over a dial; false where more than its numbers change.
    bool sample(std::size_t d) {
        samples_[d] = {{at_base_[d], values_of(base_)}};
        for (double value : dials_[d].samples) {
            if (value == at_base_[d]) continue;
            std::optional<ShaderNumbers> shader = shader_with(d, value);
            if (shader && !same_structure(*shader, base_)) {
                value += dials_[d].nudge;
                shader = shader_with(d, value);
            }
            if (!shader) continue;
            if (!same_structure(*shader, base_)) return false;
            samples_[d].push_back({value, values_of(*shader)});
        }
        return samples_[d].size() >= std::min<std::size_t>(4, dials_[d].samples.size());
    }

    bool follows(std::size_t number, std::size_t dial) const {
        return std::ranges::any_of(samples_[dial], [&](const Sample& sample) {
            return sample.numbers[number] != base_.numbers[number].value;
        });
    }

    /// Returns the part of the number that follows the dial, if there is a law.
    std::optional<DialPart> part_of(std::size_t number, std::size_t dial) const {
        std::vector<double> u, y;
        for (const Sample& sample : samples_[dial]) y.push_back(sample.numbers[number]);
        for (std::size_t v = 0; v < dials_[dial].variables.size(); ++v) {
            u.clear();
            for (const Sample& sample : samples_[dial])
                u.push_back(dials_[dial].variables[v].of(sample.value));
            if (const auto law = find_law(u, y)) return DialPart{dial, v, *law};
        }
        return {};
    }

    /// The value of a part's quantity.
    double quantity(const DialPart& part, double dial) const {
        return part.law.quantity.at(dials_[part.dial].variables[part.variable].of(dial));
    }

    NamedQuantity named(const DialPart& part) const {
        return {dials_[part.dial].variables[part.variable].name, part.law.quantity};
    }

    /// The value of a dial furthest from that of the base, as far as a quantity tells.
    double far_value(const DialPart& part) const {
        const auto distance = [&](const Sample& sample) {
            return std::abs(quantity(part, sample.value) - quantity(part, at_base_[part.dial]));
        };
        return std::ranges::max(samples_[part.dial], {}, distance).value;
    }

    /// The shader's numbers where some dials have other values.
    const std::vector<double>& corner(const std::map<std::size_t, double>& dials) {
        const auto [known, is_new] = corners_.try_emplace(dials);
        if (!is_new) return known->second;
        Dials values = at_base_;
        for (const auto& [dial, value] : dials) values[dial] = value;
        const std::optional<ShaderNumbers> shader = shader_at(values);
        if (shader && same_structure(*shader, base_)) known->second = values_of(*shader);
        return known->second;
    }

    /// The number where the parts of a set have their values furthest from the base; none where
    /// that is no such shader.
    std::optional<double> number_at(std::size_t number, const std::vector<DialPart>& parts,
                                    std::size_t set) {
        std::map<std::size_t, double> turned;
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (set >> i & 1) turned.emplace(parts[i].dial, far_value(parts[i]));
        const std::vector<double>& numbers = corner(turned);
        if (numbers.empty()) return {};
        return numbers[number];
    }

    /// The law of a number that follows several dials: the sum of what it makes of each, or of
    /// products. None where one of the shaders that tell cannot be.
    std::optional<ProductLaw> joint_law(std::size_t number, const std::vector<DialPart>& parts) {
        const std::size_t sets = std::size_t(1) << parts.size();
        std::vector<NamedQuantity> quantities;
        std::vector<double> low, high, corners, factors;
        for (const DialPart& part : parts) {
            quantities.push_back(named(part));
            low.push_back(quantity(part, at_base_[part.dial]));
            high.push_back(quantity(part, far_value(part)));
            factors.push_back(part.law.factor);
        }
        const std::optional<double> last = number_at(number, parts, sets - 1);
        if (!last) return {};
        const ProductLaw sum = sum_law(quantities, factors, low, base_.numbers[number].value);
        if (sum.agrees(high, *last)) return sum;
        for (std::size_t set = 0; set < sets; ++set) {
            const std::optional<double> value = number_at(number, parts, set);
            if (!value) return {};
            corners.push_back(*value);
        }
        return law_between(std::move(quantities), low, high, corners);
    }

    /// Finds the law of a number, or makes a control that it follows constant.
    bool find_law_of(std::size_t number) {
        std::vector<DialPart> parts;
        for (std::size_t d = 0; d < dials_.size(); ++d) {
            if (!turns(d) || !follows(number, d)) continue;
            const std::optional<DialPart> part = part_of(number, d);
            if (!part || parts.size() == most_quantities) {
                keep(dials_[d].knob);
                return false;
            }
            parts.push_back(*part);
        }
        if (parts.empty()) return true;
        std::optional<ProductLaw> law =
            parts.size() > 1
                ? joint_law(number, parts)
                : ProductLaw{{named(parts[0])}, {parts[0].law.constant, parts[0].law.factor}};
        if (!law) {
            keep(dials_[parts.back().dial].knob);
            return false;
        }
        laws_.emplace(number, std::pair(std::move(parts), std::move(*law)));
        return true;
    }

    /// Holds all laws to a shader of which all dials are turned.
    bool holds(int which) {
        Dials dials = at_base_;
        for (std::size_t d = 0; d < dials_.size(); ++d)
            if (turns(d))
                dials[d] =
                    samples_[d][(d * 5 + std::size_t(which) * 3 + 1) % samples_[d].size()].value;
        const std::optional<ShaderNumbers> shader = shader_at(dials);
        if (!shader) return true;
        if (!same_structure(*shader, base_)) {
            keep_last();
            return false;
        }
        for (std::size_t number = 0; number < base_.numbers.size(); ++number)
            if (!holds(number, shader->numbers[number].value, dials)) return false;
        return true;
    }

    bool holds(std::size_t number, double value, const Dials& dials) {
        const auto known = laws_.find(number);
        if (known == laws_.end()) {
            if (value == base_.numbers[number].value) return true;
            keep_last();
            return false;
        }
        const auto& [parts, law] = known->second;
        std::vector<double> quantities;
        for (const DialPart& part : parts) quantities.push_back(quantity(part, dials[part.dial]));
        if (law.agrees(quantities, value)) return true;
        keep(dials_[parts.back().dial].knob);
        return false;
    }

    /// One search with the controls that are not constant; false where it made another constant.
    bool search() {
        find_base();
        samples_.assign(dials_.size(), {});
        corners_.clear();
        laws_.clear();
        for (std::size_t d = 0; d < dials_.size(); ++d) {
            if (!turns(d) || sample(d)) continue;
            keep(dials_[d].knob);  // the others may have failed for this one's value alone
            return false;
        }
        bool complete = true;
        for (std::size_t number = 0; number < base_.numbers.size(); ++number)
            complete = find_law_of(number) && complete;
        for (int i = 0; complete && i < joint_samples; ++i) complete = holds(i);
        if (complete) name_idle();
        return complete;
    }

    /// Controls that no number follows have no uniform.
    void name_idle() {
        std::vector<bool> used(knobs_.size());
        for (const auto& [number, law] : laws_)
            for (const DialPart& part : law.first) used[dials_[part.dial].knob] = true;
        for (std::size_t i = 0; i < knobs_.size(); ++i)
            if (!used[i] && why_[i].empty()) why_[i] = "since nothing in it depends on that";
    }

    void tell_constants(KnobbedShader& shader) const {
        for (std::size_t i = 0; i < knobs_.size(); ++i) {
            if (why_[i].empty()) continue;
            const std::string& name = knobs_[i].name();
            shader.uniforms +=
                fmt::format("// Constant: {}, {}\n", in_glsl_comment(name), knobs_[i].value());
            shader.notes.push_back(
                fmt::format("the shader's \"{}\" stays {}, {}", name, knobs_[i].value(), why_[i]));
        }
    }

    KnobbedShader result() const {
        std::vector<std::string> expressions(base_.numbers.size());
        for (const auto& [number, law] : laws_) expressions[number] = law.second.text();
        KnobbedShader shader{"", with_expressions(base_, expressions), {}};
        for (std::size_t i = 0; i < knobs_.size(); ++i)
            if (why_[i].empty()) shader.uniforms += knobs_[i].definition();
        if (shader.text.find("formula_power(") != std::string::npos)
            shader.uniforms += formula_power_glsl;
        tell_constants(shader);
        return shader;
    }

    const Recipe& recipe_;
    const std::function<std::string(const Recipe&)>& shader_of_;
    Json json_;
    std::vector<Knob> knobs_;
    std::vector<std::string> why_;  ///< why a control stays constant; empty where it is turned
    std::vector<KnobDial> dials_;
    Dials at_base_;
    ShaderNumbers base_;                        ///< the shader at the first samples of all dials
    std::vector<std::vector<Sample>> samples_;  ///< those of each dial
    std::map<std::map<std::size_t, double>, std::vector<double>> corners_;
    std::map<std::size_t, std::pair<std::vector<DialPart>, ProductLaw>> laws_;  ///< by number
};

}  // namespace

KnobbedShader with_knobs(const Recipe& recipe,
                         const std::function<std::string(const Recipe&)>& shader_of) {
    // It must be possible before it is tried with other values.
    KnobbedShader plain{"", shader_of(recipe), {}};
    return recipe.controls.empty() ? plain : KnobSearch(recipe, shader_of).run();
}

}  // namespace burl
