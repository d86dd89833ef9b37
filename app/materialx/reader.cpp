#include "app/materialx/reader.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/materialx/definitions.h"
#include "app/materialx/geometry.h"
#include "app/materialx/nodes.h"
#include "app/materialx/values/color_space.h"
#include "app/materialx/values/convert.h"

namespace burl::materialx {

namespace {

constexpr int most_hops = 100, deepest_graph = 32;
constexpr std::size_t most_evaluations = 20000, deepest_chain = 400;

}  // namespace

Reader::Reader(const Document& document) : document_(document) {
    root_.container = &document.root;
    index(document.root);
}

void Reader::index(const Element& element) {
    for (const Element& child : element.children) {
        parents_[&child] = &element;
        index(child);
    }
}

std::string Reader::inherited(const Element& element, std::string_view attribute) const {
    const Element* at = &element;
    for (;;) {
        if (const std::string* own = at->find(attribute)) return *own;
        const auto parent = parents_.find(at);
        if (parent == parents_.end()) return "";
        at = parent->second;
    }
}

void Reader::lose(const std::string& sentence) {
    if (std::ranges::find(losses_, sentence) == losses_.end()) losses_.push_back(sentence);
}

Value Reader::refused(const Element& node, Type type, const Scope& scope,
                      const std::string& reason) {
    const std::string sentence =
        fmt::format("{}{} (line {}): {}", scope.path, node.name(), node.line, reason);
    if (std::ranges::find(refusals_, sentence) == refusals_.end()) refusals_.push_back(sentence);
    return values.filled(type, 0.0);
}

Value Reader::geometry(const std::string& property, const Element& at, const Scope& scope) {
    if (const auto known = geometric_property(*this, property)) return *known;
    return refused(at, Type::vector3, scope,
                   fmt::format("the geometric property {} is not read", property));
}

const Scope& Reader::inner_scope(const Element& container, const Element* instance,
                                 const Element* definition, const Scope& outer) {
    std::unique_ptr<Scope>& scope = scopes_[{&container, instance, &outer}];
    if (scope) return *scope;
    if (outer.depth >= deepest_graph)
        throw document_.error(
            container, fmt::format("node graphs are nested more than {} deep", deepest_graph));
    scope = std::make_unique<Scope>(
        Scope{&container, instance, definition, &outer,
              outer.path + (instance ? *instance : container).name() + "/", outer.depth + 1});
    return *scope;
}

const Element& Reader::named_node(const Element& source, const Scope& scope) const {
    const std::string name = source.text("nodename");
    for (const Element& one : scope.container->children)
        if ((is_node(one) || one.tag == "nodegraph") && one.name() == name) return one;
    throw document_.error(source, fmt::format("there is no node \"{}\"{}", name,
                                              scope.outer ? " in this node graph" : ""));
}

Target Reader::into_graph(const Element& graph, const Element& source, const Scope& inner,
                          int hops) {
    const std::string name = source.text("output");
    const Element* output = nullptr;
    int outputs = 0;
    for (const Element& one : graph.children) {
        if (one.tag != "output" || (!name.empty() && one.name() != name)) continue;
        if (!output) output = &one;
        ++outputs;
    }
    if (!output)
        throw document_.error(
            source, fmt::format("the node graph \"{}\" has no output \"{}\"", graph.name(), name));
    if (outputs > 1)
        throw document_.error(
            source, fmt::format("the node graph \"{}\" has {} outputs; name one by \"output\"",
                                graph.name(), outputs));
    return follow(*output, inner, hops);
}

Target Reader::through_interface(const Element& source, const std::string& name, const Scope& scope,
                                 int hops) {
    const Element* container = scope.instance ? scope.instance : scope.container;
    if (const Element* bound = container->child("input", name)) {
        Target target = follow(*bound, scope.outer ? *scope.outer : scope, hops);
        if (target.node || target.holder) return target;
    }
    for (const Element* fallback : {scope.definition, scope.container}) {
        const Element* declared = fallback ? fallback->child("input", name) : nullptr;
        if (declared && (declared->find("value") || declared->find("defaultgeomprop")))
            return {nullptr, declared, "", &scope};
        if (declared) return {};
    }
    if (source.find("value")) return {nullptr, &source, "", &scope};
    throw document_.error(source, fmt::format("there is no interface input \"{}\"", name));
}

Target Reader::to_node(const Element& source, const Scope& scope, int hops) {
    const Element& node = named_node(source, scope);
    if (node.tag == "nodegraph")
        return into_graph(node, source, inner_scope(node, nullptr, nullptr, scope), hops);
    const auto [definition, graph] = own_definition(document_, node);
    if (!graph) return {&node, nullptr, source.text("output"), &scope};
    return into_graph(*graph, source, inner_scope(*graph, &node, definition, scope), hops);
}

Target Reader::follow(const Element& source, const Scope& scope, int hops) {
    if (++hops > most_hops)
        throw document_.error(source, "the connection leads in a circle, or too far");
    if (const std::string* name = source.find("interfacename"))
        return through_interface(source, *name, scope, hops);
    if (const std::string* name = source.find("nodegraph")) {
        const Element* graph = scope.container->child("nodegraph", *name);
        if (!graph)
            throw document_.error(source, fmt::format("there is no node graph \"{}\"", *name));
        return into_graph(*graph, source, inner_scope(*graph, nullptr, nullptr, scope), hops);
    }
    if (source.find("nodename")) return to_node(source, scope, hops);
    if (source.tag == "input" && source.find("output")) {
        const Element* output = scope.container->child("output", source.text("output"));
        if (!output)
            throw document_.error(source,
                                  fmt::format("there is no output \"{}\"", source.text("output")));
        return follow(*output, scope, hops);
    }
    if (source.find("value") || source.find("defaultgeomprop"))
        return {nullptr, &source, "", &scope};
    return {};
}

Target Reader::target(const Element& node, std::string_view name, const Scope& scope) {
    const Element* source = node.child("input", name);
    return source ? follow(*source, scope, 0) : Target{};
}

std::optional<Value> Reader::input(const Element& node, std::string_view name, const Scope& scope) {
    const Element* source = node.child("input", name);
    return source ? resolve(*source, scope) : std::nullopt;
}

std::optional<Value> Reader::input(const Element& node, std::string_view name, const Scope& scope,
                                   Type wanted) {
    auto value = input(node, name, scope);
    if (value && !is_number(value->type) && size_of(value->type) != size_of(wanted))
        throw document_.error(*node.child("input", name),
                              fmt::format("\"{}\" of {} is of type {}, must be {}", name,
                                          node.name(), to_string(value->type), to_string(wanted)));
    return value;
}

std::optional<Value> Reader::resolve(const Element& source, const Scope& scope) {
    const Target target = follow(source, scope, 0);
    if (target.node) return as_declared(value(target), source, target);
    if (!target.holder) return {};
    const auto constant = held(*target.holder, *target.scope);
    if (!constant) return {};
    return as_declared(*constant, source, target);
}

Type Reader::declared_type(const Element& source) const {
    if (const auto type = enum_named<Type>(source.text("type"))) return *type;
    throw document_.error(source,
                          fmt::format("\"{}\" is of type \"{}\", must be one of {}", source.name(),
                                      source.text("type"), fmt::join(enum_names<Type>, ", ")));
}

Value Reader::as_declared(const Value& value, const Element& source, const Target& from) {
    const Type type = declared_type(source);
    if (const std::string* channels = source.find("channels"))
        if (const auto chosen = swizzled(values, value, *channels, type)) return *chosen;
    if (type != value.type)
        throw document_.error(
            source,
            fmt::format("\"{}\" is of type {}, but {} gives {}", source.name(), to_string(type),
                        from.node ? from.scope->path + from.node->name() : "its value",
                        to_string(value.type)));
    return value;
}

std::optional<Value> Reader::held(const Element& holder, const Scope& scope) {
    const std::string* text = holder.find("value");
    if (!text) return geometry(holder.text("defaultgeomprop"), holder, scope);
    const Type type = declared_type(holder);
    auto numbers = parse_value(type, *text);
    if (!numbers)
        throw document_.error(holder, fmt::format("\"{}\" is \"{}\", must be a value of type {}",
                                                  holder.name(), *text, to_string(type)));
    if (is_color(type) && !to_linear(inherited(holder, "colorspace"), *numbers))
        throw document_.error(holder, fmt::format("the colour space \"{}\" is not known",
                                                  inherited(holder, "colorspace")));
    return values.constant(type, *numbers);
}

Value Reader::value(const Target& target) {
    const Place place{target.node, target.output, target.scope};
    const auto known = known_.find(place);
    if (known != known_.end()) return known->second;
    if (!open_.insert(place).second)
        throw document_.error(*target.node, fmt::format("{}{} is made of itself",
                                                        target.scope->path, target.node->name()));
    if (open_.size() > deepest_chain)
        throw document_.error(*target.node,
                              fmt::format("more than {} nodes hang on each other", deepest_chain));
    if (++evaluations_ > most_evaluations)
        throw document_.error(*target.node, fmt::format("node graphs stand for more than {} nodes",
                                                        most_evaluations));
    const std::string outside = nodes.set_label(target.scope->path + target.node->name());
    const Value result = evaluated(target);
    nodes.set_label(outside);
    open_.erase(place);
    return known_[place] = result;
}

Value Reader::evaluated(const Target& target) {
    const Element& node = *target.node;
    const auto type = enum_named<Type>(node.text("type"));
    const NodeFunction function = function_of(node.tag);
    NodeCall call{*this, node, *target.scope, target.output, type.value_or(Type::number)};
    if (!function) return refused(node, call.type, call.scope, node.tag + " is not read");
    if (!type && node.text("type") != "multioutput")
        return refused(node, call.type, call.scope,
                       fmt::format("values of type {} are not read", node.text("type")));
    return function(call);
}

}  // namespace burl::materialx
