#include "app/materialx/values/convert.h"

namespace burl::materialx {

namespace {

/// The index of a component by its letter; none for any other letter.
std::optional<std::size_t> component_of(char letter) {
    for (const std::string_view letters : {"rgba", "xyzw"})
        if (const std::size_t index = letters.find(letter); index != std::string_view::npos)
            return index;
    return {};
}

}  // namespace

Value converted(Arithmetic& values, const Value& value, Type type) {
    if (is_number(type)) return values.number(values.part(value, 0), type);
    if (is_number(value.type))
        return values.of_parts(type, std::vector(size_of(type), values.part(value, 0)));
    const std::size_t have = size_of(value.type), want = size_of(type);
    if (want >= 3 && have >= 3) {
        const NodeRef fourth = have == 4 ? values.part(value, 3) : values.nodes.number(1.0);
        Value result = value;
        result.type = type;
        if (want == 4) result.parts[3] = fourth;
        return result;
    }
    std::vector<NodeRef> parts = values.parts_of(value);
    if (parts.size() < 3) parts.push_back(values.nodes.number(0.0));
    if (parts.size() < 4) parts.push_back(values.nodes.number(1.0));
    return values.of_parts(type, parts);
}

std::optional<Value> swizzled(Arithmetic& values, const Value& value, std::string_view channels,
                              Type type) {
    std::vector<NodeRef> parts;
    for (const char letter : channels) {
        const auto index = component_of(letter);
        if (letter == '0' || letter == '1')
            parts.push_back(values.nodes.number(letter - '0'));
        else if (index && (is_number(value.type) || *index < size_of(value.type)))
            parts.push_back(values.part(value, *index));
        else
            return {};
    }
    if (parts.size() == 1) parts.resize(size_of(type), parts[0]);
    if (parts.size() != size_of(type)) return {};
    return values.of_parts(type, parts);
}

}  // namespace burl::materialx
