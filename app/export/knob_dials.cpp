#include "app/export/knob_dials.h"

#include <algorithm>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "app/recipe/edit/leaves.h"
#include "app/recipe/edit/recipe_json.h"
#include "atlas/base/error.h"

namespace burl {

KnobDials::KnobDials(const Recipe& recipe, const ShaderOf& shader_of)
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

bool KnobDials::turns_any() const {
    return std::ranges::any_of(why_, [](const std::string& why) { return why.empty(); });
}

void KnobDials::keep_knob(std::size_t knob) {
    if (why_[knob].empty())
        why_[knob] = fmt::format(
            "since other values need another shader: emit it again with --set \"{}=VALUE\"",
            knobs_[knob].name());
}

void KnobDials::keep_last() {
    std::size_t last = knobs_.size();
    while (!why_[--last].empty()) continue;
    keep_knob(last);
}

void KnobDials::keep_all() {
    for (std::size_t i = 0; i < knobs_.size(); ++i) keep_knob(i);
}

void KnobDials::keep_idle(const std::vector<bool>& used) {
    std::vector<bool> matters(knobs_.size());
    for (std::size_t d = 0; d < dials_.size(); ++d)
        if (used[d]) matters[dials_[d].knob] = true;
    for (std::size_t i = 0; i < knobs_.size(); ++i)
        if (!matters[i] && why_[i].empty()) why_[i] = "since nothing in it depends on that";
}

std::optional<ShaderNumbers> KnobDials::shader_at(const Dials& dials) const {
    std::vector<std::string> settings;
    for (std::size_t d = 0; d < dials_.size();) {
        const std::size_t knob = dials_[d].knob, begin = d;
        while (d < dials_.size() && dials_[d].knob == knob) ++d;
        if (why_[knob].empty())
            settings.push_back(knobs_[knob].setting(std::span(dials).subspan(begin, d - begin)));
    }
    try {
        return shader_numbers(shader_of_(with_numbers(recipe_, settings)));
    } catch (const Error&) {
        return {};
    }
}

std::string KnobDials::definitions() const {
    std::string text;
    for (std::size_t i = 0; i < knobs_.size(); ++i)
        if (why_[i].empty()) text += knobs_[i].definition();
    return text;
}

void KnobDials::tell_constants(KnobbedShader& shader) const {
    for (std::size_t i = 0; i < knobs_.size(); ++i) {
        if (why_[i].empty()) continue;
        const std::string& name = knobs_[i].name();
        shader.uniforms +=
            fmt::format("// Constant: {}, {}\n", in_glsl_comment(name), knobs_[i].value());
        shader.notes.push_back(
            fmt::format("the shader's \"{}\" stays {}, {}", name, knobs_[i].value(), why_[i]));
    }
}

}  // namespace burl
