#pragma once
// Follows a document's connections: from an input to the value or the node that it names, through
// node graphs, their interfaces, and definitions of nodes that the document brings along.
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "app/materialx/document.h"
#include "app/materialx/values/value.h"

namespace burl::materialx {

/// Where names are looked up: the document, or a node graph as one node or input uses it.
struct Scope {
    const Element* container = nullptr;   ///< the element whose children are the nodes
    const Element* instance = nullptr;    ///< the node that stands for the graph; null: none
    const Element* definition = nullptr;  ///< the instance's `nodedef`; null: none
    const Scope* outer = nullptr;         ///< where the instance, or the graph, stands
    std::string path{};                   ///< "NG_marble/", for messages and names
    int depth = 0;
};

/// The end of a connection: a node's output, or an element that holds a value itself. Neither
/// for an input that is left out.
struct Target {
    const Element* node = nullptr;
    const Element* holder = nullptr;
    std::string output{};
    const Scope* scope = nullptr;
};

/// Reads values of one document. What it cannot read is gathered, and stands for 0.
class Reader {
  public:
    /// The document must live as long as the reader.
    explicit Reader(const Document& document);

    const Scope& root() const { return root_; }
    const Document& document() const { return document_; }

    /// The value of a node's input; none where it has neither value nor connection. Throws
    /// Error(invalid_file) for names that nothing has, for types that differ, and for circles.
    std::optional<Value> input(const Element& node, std::string_view name, const Scope& scope);
    /// The value of an input that must have as many components as a type, or one; throws as input()
    /// does, and where it has others.
    std::optional<Value> input(const Element& node, std::string_view name, const Scope& scope,
                               Type wanted);
    /// The value of an input, or of an output of a graph; throws as input() does.
    std::optional<Value> resolve(const Element& source, const Scope& scope);
    /// Where the connection of an input leads, for types that are no numbers.
    Target target(const Element& node, std::string_view name, const Scope& scope);

    /// A geometric property by the name that MaterialX has for it, such as "UV0".
    Value geometry(const std::string& property, const Element& at, const Scope& scope);
    /// The value 0 of a node that is not read; notes it, and why.
    Value refused(const Element& node, Type type, const Scope& scope, const std::string& reason);
    /// Notes what the recipe lacks of the material.
    void lose(const std::string& sentence);
    /// An attribute of the element or, where it is left out, of the nearest one around it that has
    /// it.
    std::string inherited(const Element& element, std::string_view attribute) const;

    const std::vector<std::string>& refusals() const { return refusals_; }
    const std::vector<std::string>& losses() const { return losses_; }

    NodeBuilder nodes;
    Arithmetic values{nodes};

  private:
    /// A node, its output and where it stands.
    using Place = std::tuple<const Element*, std::string, const Scope*>;

    Target follow(const Element& source, const Scope& scope, int hops);
    Target into_graph(const Element& graph, const Element& source, const Scope& inner, int hops);
    Target through_interface(const Element& source, const std::string& name, const Scope& scope,
                             int hops);
    Target to_node(const Element& source, const Scope& scope, int hops);
    const Element& named_node(const Element& source, const Scope& scope) const;
    const Scope& inner_scope(const Element& container, const Element* instance,
                             const Element* definition, const Scope& outer);
    Value value(const Target& target);
    Value evaluated(const Target& target);
    std::optional<Value> held(const Element& holder, const Scope& scope);
    Type declared_type(const Element& source) const;
    Value as_declared(const Value& value, const Element& source, const Target& from);
    void index(const Element& element);

    const Document& document_;
    Scope root_;
    std::map<std::tuple<const Element*, const Element*, const Scope*>, std::unique_ptr<Scope>>
        scopes_;
    std::map<const Element*, const Element*> parents_;
    std::map<Place, Value> known_;
    std::set<Place> open_;
    std::size_t evaluations_ = 0;
    std::vector<std::string> refusals_, losses_;
};

}  // namespace burl::materialx
