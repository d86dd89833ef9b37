// Random steps of building, one after the other, on every preset and material: whatever they are,
// the recipe is one that its check accepts and that reads back, and undo leads home.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "app/edit/clip.h"
#include "app/edit/lists.h"
#include "app/edit/look.h"
#include "app/edit/node_graph.h"
#include "app/edit/node_kinds.h"
#include "app/edit/steps.h"
#include "app/editor/session/history.h"
#include "app/recipe/edit/recipe_json.h"
#include "tests/app/edit/edit_cases.h"

namespace burl {
namespace {

/// Somebody who builds without a plan.
class RandomBuilder {
  public:
    RandomBuilder(Recipe recipe, std::uint32_t seed) : recipe_(std::move(recipe)), random_(seed) {}

    /// Takes one step; one that is refused changes nothing.
    void step() {
        graph_ = node_graph(recipe_);
        try {
            GraphEdit edit = any();
            EXPECT_FALSE(edit.words.empty());
            recipe_ = std::move(edit.recipe);
            ++taken;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::usage) << error.what();
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        }
    }

    const Recipe& recipe() const { return recipe_; }
    std::string node() {
        return graph_.nodes[std::max<std::size_t>(1, below(graph_.nodes.size()))].place;
    }
    std::size_t taken = 0;

  private:
    std::size_t below(std::size_t count) { return count == 0 ? 0 : random_() % count; }
    bool lonely() const { return graph_.nodes.size() < 2; }

    std::string input() {
        const GraphNodeView& node = graph_.nodes[below(graph_.nodes.size())];
        if (node.inputs.empty()) return "material.metallic";
        return node.inputs[below(node.inputs.size())].place;
    }
    std::string place() { return lonely() || below(2) == 0 ? input() : node(); }
    std::string kind() {
        const auto table = graph_table();
        return std::string(table[below(table.size())].name);
    }
    std::string channel() {
        return std::string(enum_names<Channel>[below(enum_names<Channel>.size())]);
    }
    std::string name() {
        static constexpr std::array names{"rings", "a b", "grain", "", "#x", "a.b", "fbm", "é"};
        return names[below(names.size())];
    }
    std::vector<std::string> places() {
        std::vector<std::string> some;
        for (std::size_t n = 1 + below(4); n > 0; --n) some.push_back(place());
        return some;
    }

    GraphEdit any() {
        switch (below(lonely() ? 4 : 17)) {
            case 0:
                return add_node(recipe_, input(), kind());
            case 1:
                return add_node(recipe_, below(3) == 0 ? "" : place(), kind());
            case 2:
                return add_channel(recipe_, below(4) == 0 ? "height" : channel());
            case 3:
                return add_layer(recipe_, input(), below(2) == 0 ? "screen" : "soft_light");
            case 4:
                return delete_nodes(recipe_, places());
            case 5:
                return replace_node(recipe_, place(), kind());
            case 6:
            case 7:
                return connect(recipe_, node(), input());
            case 8:
                return move_node(recipe_, place(), input());
            case 9:
                return disconnect(recipe_, place());
            case 10:
                return name_node(recipe_, place(), name());
            case 11:
                return inline_name(recipe_, graph_.nodes[below(graph_.nodes.size())].name);
            case 12:
                return group_nodes(recipe_, places(), name());
            case 13:
                return remove_channel(recipe_, below(4) == 0 ? "height" : channel());
            case 14:
                return paste_nodes(recipe_, below(3) == 0 ? "" : place(),
                                   copy_nodes(recipe_, places()));
            case 15:
                return change_layers();
            default:
                return change_terms();
        }
    }

    GraphEdit change_layers() {
        const std::string at = place();
        const std::size_t count = std::max<std::size_t>(1, layers_at(recipe_, at).size());
        return below(2) == 0 ? remove_layer(recipe_, at, below(count))
                             : move_layer(recipe_, at, below(count), below(count));
    }

    GraphEdit change_terms() {
        std::string field = node();
        std::size_t terms = 1;
        for (const GraphNodeView& one : graph_.nodes)
            if (one.type == "field") field = one.place, terms = std::max<std::size_t>(1, one.terms);
        if (below(3) == 0) return add_term(recipe_, field, below(terms + 1));
        return below(2) == 0 ? remove_term(recipe_, field, below(terms))
                             : move_term(recipe_, field, below(terms), below(terms));
    }

    Recipe recipe_;
    NodeGraph graph_;
    std::mt19937 random_;
};

void build(const std::string& name, std::size_t steps, std::uint32_t seed) {
    SCOPED_TRACE(fmt::format("{}, seed {}", name, seed));
    const Recipe first = load_recipe(name);
    EditHistory history(first, name);
    RandomBuilder builder(first, seed);
    for (std::size_t i = 0; i < steps && !testing::Test::HasFailure(); ++i) {
        builder.step();
        SCOPED_TRACE(i);
        EXPECT_EQ(parse_recipe(to_json(builder.recipe()), "written"), builder.recipe());
        history.change(builder.recipe());
    }
    EXPECT_GT(builder.taken, steps / 4);
    while (history.can_undo()) history.undo();
    EXPECT_EQ(history.recipe(), first);
    while (history.can_redo()) history.redo();
    EXPECT_EQ(history.recipe(), builder.recipe());
}

class RandomBuilding : public testing::TestWithParam<std::string> {};

// With 86 recipes they are more than 2,000 steps.
TEST_P(RandomBuilding, KeepsRecipesValid) {
    build(GetParam(), 24, 1);
}

class LongRandomBuilding : public testing::TestWithParam<std::string> {};

TEST_P(LongRandomBuilding, KeepsRecipesValid) {
    for (std::uint32_t seed = 2; seed < 4; ++seed) build(GetParam(), 100, seed);
}

std::string test_name(const testing::TestParamInfo<std::string>& test) {
    std::string name = test.param;
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(All, RandomBuilding, testing::ValuesIn(test::all_recipes()), test_name);
INSTANTIATE_TEST_SUITE_P(LongAll, LongRandomBuilding, testing::ValuesIn(test::all_recipes()),
                         test_name);

}  // namespace
}  // namespace burl
