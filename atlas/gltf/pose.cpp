#include "atlas/gltf/pose.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <unordered_set>

#include <fmt/format.h>

#include "atlas/base/error.h"
#include "atlas/gltf/motion.h"

namespace burl {
namespace {

constexpr int moments = 5;                ///< moments that are listed of each animation
constexpr std::size_t most_listed = 100;  ///< largest number of poses in a message
const char* const nodes_name = "nodes";

/// A time in seconds from the begin of an animation.
struct Moment {
    std::size_t animation = 0;
    double seconds = 0.0;
};

/// The moment that "NAME@SECONDS" names; nothing where there is no animation NAME or SECONDS is no
/// number.
std::optional<Moment> moment_of(const tinygltf::Model& model, const std::string& name) {
    const std::size_t at = name.rfind('@');
    if (at == std::string::npos) return {};
    Moment moment;
    const char *begin = name.data() + at + 1, *end = name.data() + name.size();
    const auto [stop, error] = std::from_chars(begin, end, moment.seconds);
    if (error != std::errc{} || stop != end || !std::isfinite(moment.seconds)) return {};
    for (; moment.animation < model.animations.size(); ++moment.animation)
        if (animation_name(model, moment.animation) == name.substr(0, at)) return moment;
    return {};
}

Error no_such_pose(const tinygltf::Model& model, const std::string& name, const std::string& path) {
    std::vector<std::string> names = pose_names(model);
    if (names.empty())
        return Error(ExitCode::usage,
                     fmt::format("{}: there is no pose \"{}\", nor any other one: the file has no "
                                 "morph targets, skins or animations",
                                 path, name));
    std::string more;
    if (names.size() > most_listed) {
        more = fmt::format(" and {} more", names.size() - most_listed);
        names.resize(most_listed);
    }
    return Error(ExitCode::usage, fmt::format("{}: there is no pose \"{}\"; those of the file are "
                                              "{}{}",
                                              path, name, fmt::join(names, ", "), more));
}

}  // namespace

std::vector<double> GltfPose::target_weights(const tinygltf::Model& model, int mesh,
                                             int node) const {
    if (target.empty()) return nodes.target_weights[std::size_t(node)];
    const tinygltf::Mesh& drawn = model.meshes[std::size_t(mesh)];
    const std::optional<std::size_t> number = find_target(drawn, target);
    if (!number) return {};
    std::vector<double> weights(*number + 1, 0.0);
    weights.back() = 1.0;
    return weights;
}

std::vector<std::string> pose_names(const tinygltf::Model& model) {
    std::vector<std::string> names = target_names(model);
    std::unordered_set<std::string> known(names.begin(), names.end());
    const auto add = [&](std::string name) {
        if (known.insert(name).second) names.push_back(std::move(name));
    };
    if (!model.skins.empty()) add(nodes_name);
    const std::vector<double> ends = animation_ends(model);
    for (std::size_t a = 0; a < ends.size(); ++a)
        for (int k = 0; k < moments; ++k)
            add(fmt::format("{}@{:.6g}", animation_name(model, a), ends[a] * k / (moments - 1)));
    return names;
}

GltfPose find_pose(const tinygltf::Model& model, const std::string& name, const std::string& path) {
    const std::vector<std::string> targets = target_names(model);
    if (std::ranges::find(targets, name) != targets.end())
        return {nodes_at_rest(model), name, false};
    if (name == nodes_name && !model.skins.empty()) return {nodes_at_rest(model), "", true};
    const std::optional<Moment> moment = moment_of(model, name);
    if (!moment) throw no_such_pose(model, name, path);
    return {motion_at(model, moment->animation, moment->seconds, path), "", true};
}

}  // namespace burl
