#include "app/kept/attributes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

namespace burl {
namespace {

template <class Value>
double decoded(const std::uint8_t* bytes, bool normalized) {
    Value value;
    std::memcpy(&value, bytes, sizeof value);
    if (!normalized) return double(value);
    return std::max(double(value) / double(std::numeric_limits<Value>::max()), -1.0);
}

template <class Value>
void encode(double value, bool normalized, std::uint8_t* bytes) {
    Value coded;
    if constexpr (std::is_floating_point_v<Value>) {
        coded = Value(value);
    } else {
        using Limits = std::numeric_limits<Value>;
        if (normalized) value *= double(Limits::max());
        coded = Value(std::clamp(std::round(value), double(Limits::min()), double(Limits::max())));
    }
    std::memcpy(bytes, &coded, sizeof coded);
}

/// Calls work.template operator()<Value>() for the type of a component.
template <class Work>
auto with_type(int component_type, const Work& work) {
    switch (component_type) {
        case 5120:
            return work.template operator()<std::int8_t>();
        case 5121:
            return work.template operator()<std::uint8_t>();
        case 5122:
            return work.template operator()<std::int16_t>();
        case 5123:
            return work.template operator()<std::uint16_t>();
        case 5125:
            return work.template operator()<std::uint32_t>();
        default:
            return work.template operator()<float>();
    }
}

double component(const Elements& elements, std::size_t i, std::size_t k) {
    const std::uint8_t* bytes = elements[i].data() + k * elements.component_bytes;
    return with_type(elements.component_type,
                     [&]<class Value>() { return decoded<Value>(bytes, elements.normalized); });
}

void set_component(Elements& elements, std::size_t i, std::size_t k, double value) {
    std::uint8_t* bytes =
        elements.bytes.data() + i * elements.element_bytes + k * elements.component_bytes;
    with_type(elements.component_type,
              [&]<class Value>() { encode<Value>(value, elements.normalized, bytes); });
}

/// The elements with room for `count`, their own first.
Elements with_room(const Elements& source, std::size_t count) {
    Elements result = source;
    result.bytes.resize(count * source.element_bytes, 0);
    return result;
}

void copy_element(const Elements& source, std::size_t from, Elements& target, std::size_t to) {
    std::ranges::copy(source[from],
                      target.bytes.begin() + std::ptrdiff_t(to * target.element_bytes));
}

/// The mean of two elements of up to four components.
std::array<double, 4> middle(const Elements& source, const KeptVertex& vertex, bool unit) {
    std::array<double, 4> mean{};
    double square = 0.0;
    for (std::size_t k = 0; k < source.components; ++k) {
        const double a = component(source, vertex.a, k), b = component(source, vertex.b, k);
        mean[k] = unit && k == 3 ? a : 0.5 * a + 0.5 * b;
        if (k < 3) square += mean[k] * mean[k];
    }
    for (std::size_t k = 0; unit && square > 0.0 && k < 3; ++k) mean[k] /= std::sqrt(square);
    return mean;
}

using Influences = std::vector<std::pair<double, std::size_t>>;  // weight and joint

/// The joints of a middle with their weights, the largest weight first.
Influences influences_of(const SkinSets& source, const KeptVertex& vertex) {
    std::map<std::size_t, double> sums;
    for (const std::uint32_t end : {vertex.a, vertex.b})
        for (std::size_t set = 0; set < source.joints.size(); ++set)
            for (std::size_t k = 0; k < 4; ++k) {
                const double weight = component(source.weights[set], end, k);
                if (weight > 0.0)
                    sums[std::size_t(component(source.joints[set], end, k))] += 0.5 * weight;
            }
    Influences result;
    for (const auto& [joint, weight] : sums) result.emplace_back(weight, joint);
    std::ranges::stable_sort(result, std::ranges::greater(), &Influences::value_type::first);
    return result;
}

bool same_joints(const SkinSets& source, const KeptVertex& vertex) {
    return std::ranges::all_of(source.joints, [&](const Elements& joints) {
        return std::ranges::equal(joints[vertex.a], joints[vertex.b]);
    });
}

/// Stores influences, whose weights have the sum 1, in all sets; in whole numbers the sum is exact.
void store(const Influences& influences, std::size_t vertex, SkinSets& sets) {
    const bool whole = sets.weights[0].component_type != gltf_float;
    const double unit = sets.weights[0].component_bytes == 1 ? 1.0 / 255.0 : 1.0 / 65535.0;
    double rest = 1.0;
    for (std::size_t i = influences.size(); i-- > 0;) {  // the largest weight takes the rounding
        double weight = influences[i].first;
        if (whole) weight = i == 0 ? rest : std::round(weight / unit) * unit;
        rest -= weight;
        set_component(sets.weights[i / 4], vertex, i % 4, weight);
        set_component(sets.joints[i / 4], vertex, i % 4, double(influences[i].second));
    }
}

/// Brings whole weights of a vertex to the sum 1, from which rounded means may be off by a code.
void mend_sum(SkinSets& sets, std::size_t vertex) {
    double rest = 1.0;
    std::size_t set = 0, largest = 0;
    for (std::size_t i = 0; i < 4 * sets.weights.size(); ++i) {
        const double weight = component(sets.weights[i / 4], vertex, i % 4);
        rest -= weight;
        if (weight > component(sets.weights[set], vertex, largest)) set = i / 4, largest = i % 4;
    }
    Elements& weights = sets.weights[set];
    set_component(weights, vertex, largest, component(weights, vertex, largest) + rest);
}

void store_middle(const SkinSets& source, const KeptVertex& middle, std::size_t vertex,
                  SkinSets& sets) {
    Influences influences = influences_of(source, middle);
    double sum = 0.0, kept = 0.0;
    for (const auto& [weight, joint] : influences) sum += weight;
    if (influences.size() > 4 * source.joints.size()) influences.resize(4 * source.joints.size());
    for (const auto& [weight, joint] : influences) kept += weight;
    if (!(kept > 0.0)) return;
    sets.left_out = std::max(sets.left_out, 1.0 - kept / sum);
    for (auto& [weight, joint] : influences) weight /= kept;
    store(influences, vertex, sets);
}

}  // namespace

Elements extended(const std::string& name, const Elements& source,
                  std::span<const KeptVertex> vertices) {
    const bool unit = name == "NORMAL" || name == "TANGENT";
    Elements result = with_room(source, vertices.size());
    for (std::size_t i = source.count(); i < vertices.size(); ++i) {
        const KeptVertex& vertex = vertices[i];
        copy_element(source, vertex.a, result, i);
        if (vertex.a == vertex.b || source.components > 4) continue;
        const std::array<double, 4> mean = middle(source, vertex, unit);
        for (std::size_t k = 0; k < source.components; ++k) set_component(result, i, k, mean[k]);
    }
    return result;
}

SkinSets extended(const SkinSets& source, std::span<const KeptVertex> vertices) {
    SkinSets result;
    const std::size_t count = source.joints[0].count();
    for (const Elements& joints : source.joints)
        result.joints.push_back(with_room(joints, vertices.size()));
    for (const Elements& weights : source.weights)
        result.weights.push_back(extended("", weights, vertices));
    for (std::size_t i = count; i < vertices.size(); ++i) {
        const KeptVertex& vertex = vertices[i];
        if (same_joints(source, vertex)) {
            for (std::size_t set = 0; set < source.joints.size(); ++set)
                copy_element(source.joints[set], vertex.a, result.joints[set], i);
            if (result.weights[0].component_type != gltf_float) mend_sum(result, i);
            continue;
        }
        for (Elements& weights : result.weights)
            for (std::size_t k = 0; k < 4; ++k) set_component(weights, i, k, 0.0);
        store_middle(source, vertex, i, result);
    }
    return result;
}

}  // namespace burl
