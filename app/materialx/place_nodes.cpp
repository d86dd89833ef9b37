// Positions, normals and texture coordinates, and maps of these.
#include <array>
#include <numbers>

#include <fmt/format.h>

#include "app/materialx/nodes.h"
#include "app/materialx/values/convert.h"

namespace burl::materialx {

namespace {

Value position(const NodeCall& call) {
    return call.reader.geometry("Pobject", call.node, call.scope);
}

Value normal(const NodeCall& call) {
    return call.reader.geometry("Nobject", call.node, call.scope);
}

Value texcoord(const NodeCall& call) {
    if (call.constant("index", 0.0) != 0.0)
        return call.refused("texture coordinates other than the first set are not read");
    return converted(call.values(), call.reader.geometry("UV0", call.node, call.scope), call.type);
}

Value geomcolor(const NodeCall& call) {
    if (call.constant("index", 0.0) != 0.0)
        return call.refused("colours of the mesh other than the first set are not read");
    NodeBuilder& nodes = call.nodes();
    const NodeRef color = nodes.node("vertex_color", true, {});
    if (is_number(call.type)) return call.made(nodes.channel(color, 0));
    return call.values().of_color(call.type, color, nodes.number(1.0));
}

Value geomprop(const NodeCall& call) {
    const std::string property = call.text("geomprop");
    for (const char* known : {"Pobject", "Pworld", "Nobject", "Nworld", "UV0", "st", "uv"}) {
        if (property != known) continue;
        const bool is_uv = property.size() == 2;
        const Value value = call.reader.geometry(is_uv ? "UV0" : property, call.node, call.scope);
        return converted(call.values(), value, call.type);
    }
    return call.refused(fmt::format("the geometric property \"{}\" is not read", property));
}

/// The map of `place2d`, applied to a vector about its pivot.
class Placement {
  public:
    explicit Placement(const NodeCall& call) : call_(call) {
        value_ = call.in("texcoord", 0.0);
        pivot_ = call.in("pivot", 0.0);
        value_ = with("subtract", pivot_);
    }
    void scale() { value_ = with("divide", call_.in("scale", 1.0)); }
    void rotate() {
        NodeBuilder& nodes = call_.nodes();
        const NodeRef degrees = call_.number("rotate", 0.0);
        if (nodes.constant(degrees) == 0.0) return;
        value_ = turned(call_.values(), value_,
                        nodes.math("multiply", {degrees, nodes.number(std::numbers::pi / 180.0)}));
    }
    void offset() { value_ = with("subtract", call_.in("offset", 0.0)); }
    Value result() { return with("add", pivot_); }

  private:
    Value with(const char* operation, const Value& other) {
        return call_.values().apply(operation, Type::vector2, {value_, other});
    }

    const NodeCall& call_;
    Value value_, pivot_;
};

Value place2d(const NodeCall& call) {
    const auto order = call.constant("operationorder", 0.0);
    if (!order) return call.varies("operationorder");
    Placement place(call);
    if (*order == 0.0) {
        place.scale();
        place.rotate();
        place.offset();
    } else {
        place.offset();
        place.rotate();
        place.scale();
    }
    return place.result();
}

}  // namespace

std::span<const NodeRow> place_rows() {
    static constexpr std::array rows{
        NodeRow{"position", position},      NodeRow{"normal", normal},
        NodeRow{"texcoord", texcoord},      NodeRow{"geomcolor", geomcolor},
        NodeRow{"geompropvalue", geomprop}, NodeRow{"place2d", place2d}};
    return rows;
}

}  // namespace burl::materialx
