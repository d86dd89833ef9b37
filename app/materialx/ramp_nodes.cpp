// Ramps and splits over the texture coordinates.
#include <array>

#include <fmt/format.h>

#include "app/materialx/nodes.h"

namespace burl::materialx {

namespace {

/// A texture coordinate, clamped to [0, 1].
Value clamped_coordinate(const NodeCall& call, std::size_t index) {
    Arithmetic& values = call.values();
    const NodeRef at = values.part(call.geometry("texcoord", "UV0"), index);
    return values.number(
        call.nodes().math("clamp", {at, call.nodes().number(0.0), call.nodes().number(1.0)}));
}

Value between(const NodeCall& call, const Value& from, const Value& to, const Value& amount) {
    return call.values().apply("mix", call.type, {from, to, amount});
}

Value left_to_right(const NodeCall& call) {
    return between(call, call.in("valuel", 0.0), call.in("valuer", 0.0),
                   clamped_coordinate(call, 0));
}

Value top_to_bottom(const NodeCall& call) {
    return between(call, call.in("valuet", 0.0), call.in("valueb", 0.0),
                   clamped_coordinate(call, 1));
}

Value four_corners(const NodeCall& call) {
    const Value across = clamped_coordinate(call, 0);
    return between(call, between(call, call.in("valuetl", 0.0), call.in("valuetr", 0.0), across),
                   between(call, call.in("valuebl", 0.0), call.in("valuebr", 0.0), across),
                   clamped_coordinate(call, 1));
}

/// Two values, one on each side of a line.
Value split(const NodeCall& call, const char* low, const char* high, std::size_t index) {
    const NodeRef at = call.values().part(call.geometry("texcoord", "UV0"), index);
    const NodeRef beyond = call.nodes().math("ifgreatereq", {at, call.number("center", 0.5)});
    return between(call, call.in(low, 0.0), call.in(high, 0.0), call.values().number(beyond));
}

Value split_left_right(const NodeCall& call) {
    return split(call, "valuel", "valuer", 0);
}
Value split_top_bottom(const NodeCall& call) {
    return split(call, "valuet", "valueb", 1);
}

}  // namespace

std::span<const NodeRow> ramp_rows() {
    static constexpr std::array rows{
        NodeRow{"ramplr", left_to_right}, NodeRow{"ramptb", top_to_bottom},
        NodeRow{"ramp4", four_corners}, NodeRow{"splitlr", split_left_right},
        NodeRow{"splittb", split_top_bottom}};
    return rows;
}

}  // namespace burl::materialx
