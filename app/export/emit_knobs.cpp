#include "app/export/emit_knobs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "app/export/formula_glsl.h"
#include "app/export/knob_samples.h"
#include "app/export/number_law.h"

namespace burl {

namespace {

/// More passes than this would each find another control that turns nothing alone.
constexpr int most_passes = 8, joint_samples = 3;

/// The part of a number that follows one dial: a quantity of a variable.
struct DialPart {
    std::size_t dial = 0, variable = 0;
    SimpleLaw law;
};

/// The laws of one shader's numbers. What follows none makes a control constant.
class KnobLaws {
  public:
    KnobLaws(KnobDials& dials, KnobSamples& samples) : dials_(dials), samples_(samples) {}

    /// Finds all laws; false where that made a control constant.
    bool find() {
        for (std::size_t d = 0; d < dials_.count(); ++d) {
            if (!dials_.turns(d) || samples_.sample(d)) continue;
            dials_.keep(d);  // the others may have failed for this one's value alone
            return false;
        }
        bool complete = true;
        for (std::size_t number = 0; number < base().size(); ++number)
            complete = find_law_of(number) && complete;
        for (int i = 0; complete && i < joint_samples; ++i) complete = holds(i);
        return complete;
    }

    /// Which dials a number follows.
    std::vector<bool> used() const {
        std::vector<bool> used(dials_.count());
        for (const auto& [number, law] : laws_)
            for (const DialPart& part : law.first) used[part.dial] = true;
        return used;
    }

    /// The shader with the laws in the place of numbers.
    std::string text() const {
        std::vector<std::string> expressions(base().size());
        for (const auto& [number, law] : laws_) expressions[number] = law.second.text();
        return with_expressions(samples_.base(), expressions);
    }

  private:
    const std::vector<ShaderNumber>& base() const { return samples_.base().numbers; }

    /// The part of the number that follows the dial, if there is a law.
    std::optional<DialPart> part_of(std::size_t number, std::size_t dial) const {
        std::vector<double> u, y;
        for (const KnobSample& sample : samples_.of(dial)) y.push_back(sample.numbers[number]);
        for (std::size_t v = 0; v < dials_[dial].variables.size(); ++v) {
            u.clear();
            for (const KnobSample& sample : samples_.of(dial))
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

    double low_value(const DialPart& part) const { return samples_.at_base()[part.dial]; }

    /// The value of a dial furthest from that of the base, as far as a quantity tells.
    double far_value(const DialPart& part) const {
        const auto distance = [&](const KnobSample& sample) {
            return std::abs(quantity(part, sample.value) - quantity(part, low_value(part)));
        };
        return std::ranges::max(samples_.of(part.dial), {}, distance).value;
    }

    /// The number where the parts of a set have their values furthest from the base; none where
    /// that is no such shader.
    std::optional<double> number_at(std::size_t number, const std::vector<DialPart>& parts,
                                    std::size_t set) {
        std::map<std::size_t, double> turned;
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (set >> i & 1) turned.emplace(parts[i].dial, far_value(parts[i]));
        const std::vector<double>& numbers = samples_.corner(turned);
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
            low.push_back(quantity(part, low_value(part)));
            high.push_back(quantity(part, far_value(part)));
            factors.push_back(part.law.factor);
        }
        const std::optional<double> last = number_at(number, parts, sets - 1);
        if (!last) return {};
        const ProductLaw sum = sum_law(quantities, factors, low, base()[number].value);
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
        for (std::size_t d = 0; d < dials_.count(); ++d) {
            if (!dials_.turns(d) || !samples_.follows(number, d)) continue;
            const std::optional<DialPart> part = part_of(number, d);
            if (!part || parts.size() == most_quantities) {
                dials_.keep(d);
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
            dials_.keep(parts.back().dial);
            return false;
        }
        laws_.emplace(number, std::pair(std::move(parts), std::move(*law)));
        return true;
    }

    /// Holds all laws to a shader of which all dials are turned.
    bool holds(int which) {
        Dials dials = samples_.at_base();
        for (std::size_t d = 0; d < dials_.count(); ++d) {
            const std::vector<KnobSample>& samples = samples_.of(d);
            if (dials_.turns(d))
                dials[d] = samples[(d * 5 + std::size_t(which) * 3 + 1) % samples.size()].value;
        }
        const std::optional<ShaderNumbers> shader = dials_.shader_at(dials);
        if (!shader) return true;
        if (!same_structure(*shader, samples_.base())) {
            dials_.keep_last();
            return false;
        }
        for (std::size_t number = 0; number < base().size(); ++number)
            if (!holds(number, shader->numbers[number].value, dials)) return false;
        return true;
    }

    bool holds(std::size_t number, double value, const Dials& dials) {
        const auto known = laws_.find(number);
        if (known == laws_.end()) {
            if (value == base()[number].value) return true;
            dials_.keep_last();
            return false;
        }
        const auto& [parts, law] = known->second;
        std::vector<double> quantities;
        for (const DialPart& part : parts) quantities.push_back(quantity(part, dials[part.dial]));
        if (law.agrees(quantities, value)) return true;
        dials_.keep(parts.back().dial);
        return false;
    }

    KnobDials& dials_;
    KnobSamples& samples_;
    std::map<std::size_t, std::pair<std::vector<DialPart>, ProductLaw>> laws_;  ///< by number
};

/// The shader with laws, if all that turns has some; else a control more is constant.
std::optional<KnobbedShader> search(KnobDials& dials) {
    KnobSamples samples(dials);
    KnobLaws laws(dials, samples);
    if (!laws.find()) return {};
    dials.keep_idle(laws.used());
    KnobbedShader shader{dials.definitions(), laws.text(), {}};
    if (shader.text.find("formula_power(") != std::string::npos)
        shader.uniforms += formula_power_glsl;
    dials.tell_constants(shader);
    return shader;
}

}  // namespace

KnobbedShader with_knobs(const Recipe& recipe,
                         const std::function<std::string(const Recipe&)>& shader_of) {
    // It must be possible before it is tried with other values.
    KnobbedShader plain{"", shader_of(recipe), {}};
    if (recipe.controls.empty()) return plain;
    KnobDials dials(recipe, shader_of);
    for (int pass = 0; dials.turns_any() && pass < most_passes; ++pass)
        if (std::optional<KnobbedShader> shader = search(dials)) return *shader;
    dials.keep_all();
    dials.tell_constants(plain);
    return plain;
}

}  // namespace burl
