// Constants, and components of values taken apart, put together and renamed.
#include <array>

#include <fmt/format.h>

#include "app/materialx/nodes.h"
#include "app/materialx/values/convert.h"

namespace burl::materialx {

namespace {

Value constant(const NodeCall& call) {
    return call.in("value", 0.0);
}

Value passed_on(const NodeCall& call) {
    return call.in("in", 0.0);
}

Value convert(const NodeCall& call) {
    return converted(call.values(), call.any("in"), call.type);
}

/// Appends the components of inputs in1, in2 and so on, up to the size of the result.
Value combine(const NodeCall& call) {
    std::vector<NodeRef> parts;
    for (int k = 1; k <= 4 && parts.size() < size_of(call.type); ++k) {
        const Value part = call.any(fmt::format("in{}", k));
        for (const NodeRef one : call.values().parts_of(part)) parts.push_back(one);
    }
    if (parts.size() != size_of(call.type))
        return call.refused(fmt::format("its inputs have {} components, its type {}", parts.size(),
                                        size_of(call.type)));
    return call.values().of_parts(call.type, parts);
}

Value separate(const NodeCall& call) {
    const Value from = call.any("in");
    const std::string channel = call.output.starts_with("out") ? call.output.substr(3) : "";
    const auto part = swizzled(call.values(), from, channel, Type::number);
    if (channel.size() != 1 || !part)
        return call.refused(fmt::format("it has no output \"{}\"", call.output));
    return *part;
}

Value extract(const NodeCall& call) {
    const auto index = call.constant("index", 0.0);
    const Value from = call.any("in");
    if (!index) return call.varies("index");
    if (*index < 0.0 || *index >= double(size_of(from.type)))
        return call.refused(fmt::format("its value has no component {}", *index));
    return call.made(call.values().part(from, std::size_t(*index)));
}

Value swizzle(const NodeCall& call) {
    const std::string channels = call.text("channels");
    const auto result = swizzled(call.values(), call.any("in"), channels, call.type);
    if (result) return *result;
    return call.refused(fmt::format("its channels are \"{}\"", channels));
}

}  // namespace

std::span<const NodeRow> channel_rows() {
    static constexpr std::array rows{NodeRow{"constant", constant},  NodeRow{"dot", passed_on},
                                     NodeRow{"convert", convert},    NodeRow{"combine2", combine},
                                     NodeRow{"combine3", combine},   NodeRow{"combine4", combine},
                                     NodeRow{"separate2", separate}, NodeRow{"separate3", separate},
                                     NodeRow{"separate4", separate}, NodeRow{"extract", extract},
                                     NodeRow{"swizzle", swizzle}};
    return rows;
}

}  // namespace burl::materialx
