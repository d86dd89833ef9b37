// Vertices and triangles of glTF primitives, after the specification 3.7.2. Primitives that share
// all their accessors share their points.
#include "atlas/gltf/primitive.h"

#include <algorithm>
#include <cmath>

#include <tiny_gltf.h>

#include "atlas/base/error.h"
#include "atlas/file/text_scanner.h"
#include "atlas/gltf/accessor.h"

namespace burl {

namespace {

const Vec4f white(1.0f);
constexpr std::array<std::uint16_t, 4> no_joints{};
const Vec4f first_joint_only(1.0f, 0.0f, 0.0f, 0.0f);

/// The matrix that takes normals to the scene where `linear` takes points: the inverse transpose up
/// to a positive factor, also where `linear` is singular.
Mat3d normal_matrix(const Mat3d& linear) {
    const Mat3d cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                          glm::cross(linear[0], linear[1]));
    return glm::determinant(linear) < 0.0 ? -cofactors : cofactors;
}

float finite_float(double value) {
    const auto rounded = static_cast<float>(value);
    return std::isfinite(rounded) ? rounded : 0.0f;
}

Vec4f weights_of_sum_one(const double* w) {
    const Vec4f weights(finite_float(w[0]), finite_float(w[1]), finite_float(w[2]),
                        finite_float(w[3]));
    const float sum = weights.x + weights.y + weights.z + weights.w;
    return sum > 0.0f && std::isfinite(sum) ? weights / sum : first_joint_only;
}

/// Number of points or lines that `vertices` vertices draw in `mode`: points, lines, a line loop or
/// a line strip.
std::uint64_t drawn_elements(int mode, std::size_t vertices) {
    if (mode == TINYGLTF_MODE_LINE) return vertices / 2;
    if (mode == TINYGLTF_MODE_LINE_STRIP) return vertices - 1;
    return vertices;
}

}  // namespace

std::uint64_t gltf_triangles(const tinygltf::Model& model, const tinygltf::Primitive& primitive) {
    const auto position = primitive.attributes.find("POSITION");
    const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
    if (position == primitive.attributes.end() || mode < TINYGLTF_MODE_TRIANGLES) return 0;
    const int corners = primitive.indices >= 0 ? primitive.indices : position->second;
    const std::uint64_t count = model.accessors[std::size_t(corners)].count;
    return mode == TINYGLTF_MODE_TRIANGLES ? count / 3 : count < 3 ? 0 : count - 2;
}

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

/// The vertices of one primitive, with the morph targets and the skin that move them.
struct PrimitiveReader::Vertices {
    const tinygltf::Model& model;
    const tinygltf::Primitive& primitive;
    const std::string& where;
    Targets targets;
    VertexSkin skin;

    /// The values of attribute `name`, with the weighted changes of all targets that have it added.
    AccessorValues read(const std::string& name) const {
        AccessorValues values = read_accessor(model, primitive.attributes.at(name));
        for (const WeightedTarget& target : targets) {
            if (!target.attributes->contains(name)) continue;
            const AccessorValues change = read_accessor(model, target.attributes->at(name));
            if (change.components != values.components) continue;
            for (std::size_t i = 0; i < values.values.size(); ++i)
                values.values[i] += target.weight * change.values[i];
        }
        return values;
    }

    /// Whether the normals are still the surface's: all targets that move the primitive have
    /// normals, too.
    bool keeps_normals() const {
        return primitive.attributes.contains("NORMAL") &&
               std::ranges::all_of(targets, [](const WeightedTarget& target) {
                   return target.attributes->contains("NORMAL");
               });
    }
};

PrimitiveReader::PrimitiveReader(const tinygltf::Model& model, const std::string& path,
                                 MeshPlace place, PolygonSoup& soup)
    : model_(model), path_(path), place_(std::move(place)), soup_(soup) {}

/// The morph targets of the primitive whose weight is not 0.
PrimitiveReader::Targets PrimitiveReader::targets_of(const tinygltf::Primitive& primitive) const {
    Targets targets;
    const std::size_t count = std::min(place_.target_weights.size(), primitive.targets.size());
    for (std::size_t i = 0; i < count; ++i)
        if (place_.target_weights[i] != 0.0)
            targets.push_back({&primitive.targets[i], place_.target_weights[i]});
    return targets;
}

void PrimitiveReader::append(const tinygltf::Primitive& primitive, const std::string& where) {
    const auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end()) {
        ++soup_.notes.ignored_elements;
        return;
    }
    const tinygltf::Accessor& points = model_.accessors[static_cast<std::size_t>(position->second)];
    if (points.bufferView < 0 && primitive.extensions.contains("KHR_draco_mesh_compression"))
        throw Error(ExitCode::unsupported,
                    fmt::format("{}: {} exists in KHR_draco_mesh_compression only, which is not "
                                "supported; export it without",
                                path_, where));
    const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
    std::vector<std::uint32_t> indices;
    if (primitive.indices >= 0) indices = read_indices(model_, primitive.indices);
    if (mode < TINYGLTF_MODE_TRIANGLES) {
        soup_.notes.ignored_elements +=
            drawn_elements(mode, primitive.indices >= 0 ? indices.size() : points.count);
        return;
    }
    first_point_ = append_vertices(primitive, where);
    if (primitive.indices < 0)
        for (std::uint32_t i = 0; i < points.count; ++i) indices.push_back(i);
    for (std::uint32_t& index : indices) index += first_point_;
    append_triangles(mode, indices);
}

/// Appends the primitive's vertices, unless an earlier primitive shares them; the number of the
/// first one in the soup.
std::uint32_t PrimitiveReader::append_vertices(const tinygltf::Primitive& primitive,
                                               const std::string& where) {
    const std::size_t first = soup_.points.size();
    const auto [entry, is_new] = first_point_of_.try_emplace(
        {primitive.attributes, targets_of(primitive)}, static_cast<std::uint32_t>(first));
    if (is_new) {
        const Vertices vertices{model_, primitive, where, targets_of(primitive),
                                VertexSkin(model_, primitive, place_.joints, path_, where)};
        append_positions(vertices);
        if (vertices.keeps_normals()) append_normals(vertices, first);
        append_attributes(vertices, first);
    }
    return entry->second;
}

void PrimitiveReader::append_positions(const Vertices& vertices) {
    const AccessorValues values = vertices.read("POSITION");
    if (values.components != 3)
        throw invalid_file(path_, 0, vertices.where + ": POSITION must be VEC3");
    if (soup_.points.size() + values.count() >= no_index)
        throw Error(ExitCode::unsupported, fmt::format("{}: too many vertices", path_));
    soup_.points.reserve(soup_.points.size() + values.count());
    for (std::size_t i = 0; i < values.count(); ++i) {
        const Mat4d to_scene = vertices.skin.empty() ? place_.to_scene : vertices.skin[i];
        const Vec3d p(to_scene * Vec4d(values[i][0], values[i][1], values[i][2], 1.0));
        for (int k = 0; k < 3; ++k)
            if (!(std::abs(p[k]) <= largest_coordinate))
                throw invalid_file(
                    path_, 0,
                    fmt::format("{}: the position of vertex {} is not finite, or beyond "
                                "1e100, in the scene",
                                vertices.where, i));
        soup_.points.push_back(p);
    }
}

void PrimitiveReader::append_normals(const Vertices& vertices, std::size_t first) {
    const AccessorValues values = vertices.read("NORMAL");
    if (values.components != 3)
        throw invalid_file(path_, 0, vertices.where + ": NORMAL has a wrong type");
    soup_.normals.values.resize(first, Vec3f(0.0f));
    const Mat3d to_scene = normal_matrix(Mat3d(place_.to_scene));
    for (std::size_t i = 0; i < values.count(); ++i) {
        const Vec3d normal(values[i][0], values[i][1], values[i][2]);
        soup_.normals.values.push_back(Vec3f(glm::normalize(
            (vertices.skin.empty() ? to_scene : normal_matrix(Mat3d(vertices.skin[i]))) * normal)));
    }
}

void PrimitiveReader::append_attributes(const Vertices& vertices, std::size_t first) {
    // Fills up for earlier primitives without the attribute, then converts each element.
    const auto append = [&](const char* name, std::size_t least, std::size_t most, auto& values,
                            const auto& missing, const auto& convert) {
        if (!vertices.primitive.attributes.contains(name)) return;
        const AccessorValues source = vertices.read(name);
        if (source.components < least || source.components > most)
            throw invalid_file(path_, 0,
                               fmt::format("{}: {} has a wrong type", vertices.where, name));
        values.resize(first, missing);
        for (std::size_t i = 0; i < source.count(); ++i)
            values.push_back(convert(source[i], source.components));
    };
    append(fmt::format("TEXCOORD_{}", place_.uv_set).c_str(), 2, 2, soup_.uvs.values, Vec2d(0.0),
           [](const double* uv, std::size_t) {
               return Vec2d(std::isfinite(uv[0]) ? uv[0] : 0.0, std::isfinite(uv[1]) ? uv[1] : 0.0);
           });
    append("COLOR_0", 3, 4, soup_.colors.values, white,
           [](const double* c, std::size_t components) {
               const float alpha = components == 4 ? finite_float(c[3]) : 1.0f;
               return Vec4f(finite_float(c[0]), finite_float(c[1]), finite_float(c[2]), alpha);
           });
    append("JOINTS_0", 4, 4, soup_.joints.values, no_joints, [](const double* j, std::size_t) {
        const auto joint = [](double value) {
            return static_cast<std::uint16_t>(value >= 0.0 && value <= 65535.0 ? value : 0.0);
        };
        return std::array{joint(j[0]), joint(j[1]), joint(j[2]), joint(j[3])};
    });
    append("WEIGHTS_0", 4, 4, soup_.weights.values, first_joint_only,
           [](const double* w, std::size_t) { return weights_of_sum_one(w); });
}

void PrimitiveReader::append_triangles(int mode, const std::vector<std::uint32_t>& indices) {
    const std::size_t count = indices.size();
    if (mode == TINYGLTF_MODE_TRIANGLES) {
        for (std::size_t i = 0; i + 2 < count; i += 3)
            push(indices[i], indices[i + 1], indices[i + 2]);
        soup_.notes.ignored_elements += count % 3;
        return;
    }
    if (count < 3) soup_.notes.ignored_elements += count;
    for (std::size_t i = 0; i + 2 < count; ++i) {
        const bool fan = mode == TINYGLTF_MODE_TRIANGLE_FAN;
        const std::uint32_t a = fan ? indices[i + 1] : indices[i];
        const std::uint32_t b = fan ? indices[i + 2] : indices[i + 1 + i % 2];
        const std::uint32_t c = fan ? indices[0] : indices[i + 2 - i % 2];
        if (!fan && (a == b || b == c || c == a))
            ++stitches_;
        else
            push(a, b, c);
    }
}

void PrimitiveReader::push(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    soup_.corners.insert(soup_.corners.end(),
                         {a, place_.mirrored ? c : b, place_.mirrored ? b : c});
}

void fill_attributes(PolygonSoup& soup) {
    const auto fill = [&](auto& values, const auto& missing) {
        if (!values.empty()) values.resize(soup.points.size(), missing);
    };
    fill(soup.normals.values, Vec3f(0.0f));
    fill(soup.uvs.values, Vec2d(0.0));
    fill(soup.colors.values, white);
    fill(soup.joints.values, no_joints);
    fill(soup.weights.values, first_joint_only);
}

}  // namespace burl
