#include "atlas/gltf/motion.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_set>

#include <fmt/format.h>
#include <tiny_gltf.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "atlas/base/error.h"
#include "atlas/gltf/accessor.h"

namespace burl {

namespace {

/// A node's transform as translation, rotation (a quaternion x, y, z, w) and scale.
struct NodeParts {
    std::vector<double> translation{0.0, 0.0, 0.0}, rotation{0.0, 0.0, 0.0, 1.0},
        scale{1.0, 1.0, 1.0};

    explicit NodeParts(const tinygltf::Node& node) {
        if (node.translation.size() == 3) translation = node.translation;
        if (node.rotation.size() == 4) rotation = node.rotation;
        if (node.scale.size() == 3) scale = node.scale;
    }

    Mat4d matrix() const {
        const auto vec = [](const std::vector<double>& v) { return Vec3d(v[0], v[1], v[2]); };
        Mat4d result = glm::translate(Mat4d(1.0), vec(translation));
        const glm::dquat q(rotation[3], rotation[0], rotation[1], rotation[2]);
        if (glm::length(q) > 0.0) result *= glm::mat4_cast(glm::normalize(q));
        return glm::scale(result, vec(scale));
    }
};

Mat4d from_columns(const std::vector<double>& columns) {
    Mat4d matrix(1.0);
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 3; ++r)  // the last row of an affine matrix is 0 0 0 1
            matrix[c][r] = columns[static_cast<std::size_t>(4 * c + r)];
    return matrix;
}

std::vector<double> slerped(const double* from, const double* to, double share) {
    const glm::dquat a(from[3], from[0], from[1], from[2]), b(to[3], to[0], to[1], to[2]);
    const glm::dquat q = glm::slerp(a, b, share);  // the shorter way
    return {q.x, q.y, q.z, q.w};
}

/// The keyframes of one animation channel.
class Keys {
  public:
    Keys(const tinygltf::Model& model, const tinygltf::AnimationSampler& sampler,
         std::size_t components, bool rotation, const std::string& where, const std::string& path)
        : times_(read_accessor(model, sampler.input)),
          values_(read_accessor(model, sampler.output)),
          width_(components),
          rotation_(rotation),
          step_(sampler.interpolation == "STEP"),
          cubic_(sampler.interpolation == "CUBICSPLINE") {
        const std::size_t expected = times_.count() * width_ * (cubic_ ? 3 : 1);
        if (times_.components != 1 || times_.count() == 0 || values_.values.size() != expected)
            throw invalid_file(path, 0,
                               fmt::format("{}: the keys' times and values do not fit", where));
        if (!std::ranges::is_sorted(times_.values))
            throw invalid_file(path, 0, fmt::format("{}: the keys' times do not increase", where));
    }

    /// The channel's value at a time, interpolated as its sampler says.
    std::vector<double> at(double seconds) const {
        const std::vector<double>& times = times_.values;
        const auto after = std::ranges::upper_bound(times, seconds);
        if (after == times.begin()) return key(0);
        const auto k = std::size_t(after - times.begin()) - 1;
        if (after == times.end() || step_) return key(k);
        const double length = times[k + 1] - times[k], share = (seconds - times[k]) / length;
        if (cubic_) return hermite(k, share, length);
        if (rotation_) return slerped(value(k), value(k + 1), share);
        std::vector<double> result = key(k);
        for (std::size_t i = 0; i < width_; ++i) result[i] += share * (value(k + 1)[i] - result[i]);
        return result;
    }

  private:
    /// The value of key k. Keys of cubic splines store an in-tangent before it and an out-tangent
    /// after it.
    const double* value(std::size_t k) const {
        return &values_.values[width_ * (cubic_ ? 3 * k + 1 : k)];
    }
    std::vector<double> key(std::size_t k) const { return {value(k), value(k) + width_}; }

    /// The cubic spline between keys k and k+1, which are `length` seconds apart, at t in [0, 1)
    /// (specification, appendix C.5).
    std::vector<double> hermite(std::size_t k, double t, double length) const {
        const double *out = value(k) + width_, *in = value(k + 1) - width_;
        const double t2 = t * t, t3 = t2 * t;
        std::vector<double> result(width_);
        for (std::size_t i = 0; i < width_; ++i)
            result[i] = (2 * t3 - 3 * t2 + 1) * value(k)[i] + length * (t3 - 2 * t2 + t) * out[i] +
                        (3 * t2 - 2 * t3) * value(k + 1)[i] + length * (t3 - t2) * in[i];
        return result;
    }

    AccessorValues times_, values_;
    std::size_t width_;
    bool rotation_, step_, cubic_;
};

}  // namespace

GltfMotion nodes_at_rest(const tinygltf::Model& model) {
    GltfMotion motion;
    motion.target_weights.resize(model.nodes.size());
    for (const tinygltf::Node& node : model.nodes)
        motion.local.push_back(node.matrix.size() == 16 ? from_columns(node.matrix)
                                                        : NodeParts(node).matrix());
    return motion;
}

std::string animation_name(const tinygltf::Model& model, std::size_t number) {
    const std::string& name = model.animations[number].name;
    return name.empty() ? fmt::format("animation {}", number) : name;
}

std::vector<double> animation_ends(const tinygltf::Model& model) {
    std::map<int, double> last;  // last key time of each accessor read so far
    const auto last_of = [&](int accessor) {
        const auto [entry, is_new] = last.try_emplace(accessor, 0.0);
        if (!is_new) return entry->second;
        for (const double time : read_accessor(model, accessor).values)
            if (std::isfinite(time)) entry->second = std::max(entry->second, time);
        return entry->second;
    };
    std::vector<double> ends;
    for (const tinygltf::Animation& animation : model.animations) {
        double& end = ends.emplace_back(0.0);
        for (const tinygltf::AnimationSampler& sampler : animation.samplers)
            end = std::max(end, last_of(sampler.input));
    }
    return ends;
}

GltfMotion motion_at(const tinygltf::Model& model, std::size_t animation, double seconds,
                     const std::string& path) {
    GltfMotion motion = nodes_at_rest(model);
    std::vector<NodeParts> parts(model.nodes.begin(), model.nodes.end());
    std::vector<bool> moved(model.nodes.size(), false);
    const tinygltf::Animation& motions = model.animations[animation];
    for (std::size_t c = 0; c < motions.channels.size(); ++c) {
        const tinygltf::AnimationChannel& channel = motions.channels[c];
        if (channel.target_node < 0) continue;
        const auto n = std::size_t(channel.target_node);
        const auto at = [&](std::size_t components) {
            return Keys(model, motions.samplers[std::size_t(channel.sampler)], components,
                        channel.target_path == "rotation",
                        fmt::format("animations[{}].channels[{}]", animation, c), path)
                .at(seconds);
        };
        moved[n] = moved[n] || channel.target_path != "weights";
        if (channel.target_path == "translation") parts[n].translation = at(3);
        if (channel.target_path == "rotation") parts[n].rotation = at(4);
        if (channel.target_path == "scale") parts[n].scale = at(3);
        if (channel.target_path != "weights" || model.nodes[n].mesh < 0) continue;
        const std::size_t targets = target_count(model.meshes[std::size_t(model.nodes[n].mesh)]);
        if (targets > 0) motion.target_weights[n] = at(targets);
    }
    for (std::size_t n = 0; n < parts.size(); ++n)
        if (moved[n]) motion.local[n] = parts[n].matrix();
    return motion;
}

std::size_t target_count(const tinygltf::Mesh& mesh) {
    std::size_t count = 0;
    for (const tinygltf::Primitive& primitive : mesh.primitives)
        count = std::max(count, primitive.targets.size());
    return count;
}

std::vector<std::string> target_names(const tinygltf::Mesh& mesh) {
    const std::size_t count = target_count(mesh);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < count; ++i) names.push_back(fmt::format("{}", i));
    if (!mesh.extras.IsObject() || !mesh.extras.Has("targetNames")) return names;
    const tinygltf::Value& given = mesh.extras.Get("targetNames");
    if (!given.IsArray()) return names;
    for (std::size_t i = 0; i < std::min(count, given.ArrayLen()); ++i)
        if (const tinygltf::Value& name = given.Get(int(i));
            name.IsString() && !name.Get<std::string>().empty())
            names[i] = name.Get<std::string>();
    return names;
}

std::vector<std::string> target_names(const tinygltf::Model& model) {
    std::vector<std::string> names;
    std::unordered_set<std::string> known;
    for (const tinygltf::Mesh& mesh : model.meshes)
        for (std::string& name : target_names(mesh))
            if (known.insert(name).second) names.push_back(std::move(name));
    return names;
}

std::optional<std::size_t> find_target(const tinygltf::Mesh& mesh, const std::string& name) {
    const std::vector<std::string> names = target_names(mesh);
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) return {};
    return std::size_t(found - names.begin());
}

}  // namespace burl
