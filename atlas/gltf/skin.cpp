#include "atlas/gltf/skin.h"

#include <tiny_gltf.h>

#include "atlas/base/error.h"
#include "atlas/gltf/accessor.h"

namespace burl {

std::vector<Mat4d> joint_matrices(const tinygltf::Model& model, int skin,
                                  std::span<const Mat4d> to_scene, const std::string& path) {
    const tinygltf::Skin& source = model.skins[std::size_t(skin)];
    AccessorValues inverse;
    if (source.inverseBindMatrices >= 0) {
        inverse = read_accessor(model, source.inverseBindMatrices);
        if (inverse.components != 16 || inverse.count() < source.joints.size())
            throw invalid_file(
                path, 0, fmt::format("skins[{}]: there must be a MAT4 for every joint", skin));
    }
    std::vector<Mat4d> matrices;
    for (std::size_t j = 0; j < source.joints.size(); ++j) {
        Mat4d to_joint(1.0);
        for (int k = 0; k < 16 && inverse.components == 16; ++k)
            to_joint[k / 4][k % 4] = inverse[j][k];
        matrices.push_back(to_scene[std::size_t(source.joints[j])] * to_joint);
    }
    return matrices;
}

VertexSkin::VertexSkin(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                       std::span<const Mat4d> joints, const std::string& path,
                       const std::string& where)
    : joints_(joints) {
    if (joints.empty()) return;
    std::vector<AccessorValues> numbers, weights;
    for (const auto& attributes = primitive.attributes;; ++sets_) {
        const auto joint = attributes.find(fmt::format("JOINTS_{}", sets_));
        const auto weight = attributes.find(fmt::format("WEIGHTS_{}", sets_));
        if (joint == attributes.end() || weight == attributes.end()) break;
        numbers.push_back(read_accessor(model, joint->second));
        weights.push_back(read_accessor(model, weight->second));
        if (numbers.back().components != 4 || weights.back().components != 4 ||
            numbers.back().count() != weights.back().count() ||
            numbers.back().count() != numbers.front().count())
            throw invalid_file(path, 0, where + ": JOINTS and WEIGHTS must be VEC4, one a vertex");
    }
    for (std::size_t i = 0; sets_ > 0 && i < sets_ * numbers.front().count(); ++i) {
        Influence influence;
        for (int k = 0; k < 4; ++k) {
            const double joint = numbers[i % sets_][i / sets_][k];
            influence.weights[k] = weights[i % sets_][i / sets_][k];
            if (influence.weights[k] != 0.0 && !(joint >= 0.0 && joint < double(joints.size())))
                throw invalid_file(
                    path, 0,
                    fmt::format("{}: vertex {} follows joint {}, but its skin has {} joints", where,
                                i / sets_, joint, joints.size()));
            influence.joints[std::size_t(k)] = influence.weights[k] != 0.0 ? std::size_t(joint) : 0;
        }
        influences_.push_back(influence);
    }
}

Mat4d VertexSkin::operator[](std::size_t vertex) const {
    Mat4d sum(0.0);
    double weights = 0.0;
    for (const Influence& influence : std::span(influences_).subspan(sets_ * vertex, sets_))
        for (std::size_t k = 0; k < 4; ++k) {
            sum += influence.weights[int(k)] * joints_[influence.joints[k]];
            weights += influence.weights[int(k)];
        }
    return weights > 0.0 ? sum / weights : joints_[influences_[sets_ * vertex].joints[0]];
}

}  // namespace burl
