#include "app/export/knob_samples.h"

#include <algorithm>
#include <utility>

namespace burl {

namespace {

std::vector<double> values_of(const ShaderNumbers& shader) {
    std::vector<double> values;
    for (const ShaderNumber& number : shader.numbers) values.push_back(number.value);
    return values;
}

}  // namespace

KnobSamples::KnobSamples(const KnobDials& dials) : dials_(dials), samples_(dials.count()) {
    for (std::size_t d = 0; d < dials.count(); ++d) at_base_.push_back(dials[d].samples[0]);
    std::optional<ShaderNumbers> shader = dials.shader_at(at_base_);
    if (!shader) {
        const Dials wanted = at_base_;
        for (std::size_t d = 0; d < dials.count(); ++d) at_base_[d] = dials[d].present;
        for (std::size_t d = 0; d < dials.count(); ++d) {
            at_base_[d] = wanted[d];
            if (!dials.shader_at(at_base_)) at_base_[d] = dials[d].present;
        }
        shader = dials.shader_at(at_base_);
    }
    base_ = shader ? std::move(*shader) : shader_numbers(dials.shader());
}

std::optional<ShaderNumbers> KnobSamples::shader_with(std::size_t dial, double value) const {
    Dials dials = at_base_;
    dials[dial] = value;
    return dials_.shader_at(dials);
}

bool KnobSamples::sample(std::size_t d) {
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

bool KnobSamples::follows(std::size_t number, std::size_t dial) const {
    return std::ranges::any_of(samples_[dial], [&](const KnobSample& sample) {
        return sample.numbers[number] != base_.numbers[number].value;
    });
}

const std::vector<double>& KnobSamples::corner(const std::map<std::size_t, double>& turned) {
    const auto [known, is_new] = corners_.try_emplace(turned);
    if (!is_new) return known->second;
    Dials values = at_base_;
    for (const auto& [dial, value] : turned) values[dial] = value;
    const std::optional<ShaderNumbers> shader = dials_.shader_at(values);
    if (shader && same_structure(*shader, base_)) known->second = values_of(*shader);
    return known->second;
}

}  // namespace burl
