// Documents that are wrong, or that say what no recipe holds: one sentence with file and line.
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/materialx/materialx.h"
#include "app/recipe/edit/recipe_json.h"
#include "atlas/base/error.h"

namespace burl {
namespace {

using testing::HasSubstr;

std::string in_root(const std::string& content) {
    return "<?xml version=\"1.0\"?>\n<materialx version=\"1.38\">\n" + content + "\n</materialx>\n";
}

/// A document whose surface has the output `out` of a graph as its base colour.
std::string with_graph(const std::string& graph, const std::string& surface = "") {
    return in_root("<nodegraph name=\"NG\">\n" + graph +
                   "\n</nodegraph>\n<standard_surface name=\"SR\" type=\"surfaceshader\">"
                   "<input name=\"base_color\" type=\"color3\" nodegraph=\"NG\" output=\"out\"/>" +
                   surface +
                   "</standard_surface>\n<surfacematerial name=\"M\" type=\"material\"><input "
                   "name=\"surfaceshader\" type=\"surfaceshader\" "
                   "nodename=\"SR\"/></surfacematerial>");
}

/// A graph of one node, which is its output.
std::string of_node(const std::string& node) {
    return with_graph(node + "\n<output name=\"out\" type=\"color3\" nodename=\"n\"/>");
}

struct Problem {
    ExitCode code = ExitCode::ok;
    std::string sentence;
};

/// The error of a document, whether its own or that of the recipe it becomes.
Problem problem_of(const std::string& text, const std::string& path = "bad.mtlx") {
    try {
        parse_recipe(recipe_of_materialx(text, path).json, "bad.mtlx");
    } catch (const Error& error) {
        return {error.code(), error.what()};
    }
    return {};
}

struct Wrong {
    const char* name;
    std::string text;
    ExitCode code;
    std::string sentence;  ///< a part of it
};

const std::string add_of = "<add name=\"n\" type=\"color3\"><input name=\"in1\" type=\"color3\" ";

const std::vector<Wrong>& wrong_documents() {
    static const std::vector<Wrong> all{
        {"NoXml", "<materialx version=\"1.38\"", ExitCode::invalid_file, "bad.mtlx:1: no XML"},
        {"Empty", "", ExitCode::invalid_file, "bad.mtlx:1: no XML"},
        {"Unclosed", in_root("<nodegraph name=\"a\">"), ExitCode::invalid_file,
         "bad.mtlx:4: no XML"},
        {"OtherRoot", "<glTF/>", ExitCode::invalid_file, "the root is <glTF>"},
        {"OldVersion", "<materialx version=\"1.36\"/>", ExitCode::invalid_file,
         "the version is \"1.36\", must be 1.38 or 1.39"},
        {"NoVersion", "<materialx/>", ExitCode::invalid_file, "must be 1.38 or 1.39"},
        {"NoMaterial", in_root(""), ExitCode::invalid_file, "there is no surfacematerial"},
        {"NoShader", in_root("<surfacematerial name=\"M\" type=\"material\"/>"),
         ExitCode::invalid_file, "bad.mtlx:3: the material \"M\" has no surface shader"},
        {"AttributeTwice", in_root("<add name=\"a\" name=\"b\"/>"), ExitCode::invalid_file,
         "bad.mtlx:3: <add> has \"name\" twice"},
        {"NoNode", of_node(add_of + "nodename=\"gone\"/></add>"), ExitCode::invalid_file,
         "bad.mtlx:4: there is no node \"gone\" in this node graph"},
        {"NoGraph",
         in_root("<standard_surface name=\"S\" type=\"surfaceshader\">\n<input "
                 "name=\"base_color\" type=\"color3\" nodegraph=\"gone\"/></standard_surface>"),
         ExitCode::invalid_file, "bad.mtlx:4: there is no node graph \"gone\""},
        {"NoOutput", with_graph("<output name=\"other\" type=\"color3\" nodename=\"n\"/>"),
         ExitCode::invalid_file, "the node graph \"NG\" has no output \"out\""},
        {"NoInterface", of_node(add_of + "interfacename=\"gone\"/></add>"), ExitCode::invalid_file,
         "bad.mtlx:4: there is no interface input \"gone\""},
        {"Circle", of_node(add_of + "nodename=\"n\"/></add>"), ExitCode::invalid_file,
         "bad.mtlx:4: NG/n is made of itself"},
        {"InterfaceCircle",
         with_graph("<input name=\"a\" type=\"color3\" nodegraph=\"NG\" output=\"out\"/>"
                    "<output name=\"out\" type=\"color3\" interfacename=\"a\"/>"),
         ExitCode::invalid_file, "circle, or too far"},
        {"WrongType",
         with_graph("<noise3d name=\"n\" type=\"float\"/>\n<output name=\"out\" "
                    "type=\"color3\" nodename=\"n\"/>"),
         ExitCode::invalid_file,
         "bad.mtlx:7: \"base_color\" is of type color3, but NG/n gives float"},
        {"UnknownType",
         of_node("<add name=\"n\" type=\"color3\"><input name=\"in1\" "
                 "type=\"colour\" value=\"1\"/></add>"),
         ExitCode::invalid_file, "\"in1\" is of type \"colour\""},
        {"WrongValue", of_node(add_of + "value=\"1, 2\"/></add>"), ExitCode::invalid_file,
         "bad.mtlx:4: \"in1\" is \"1, 2\", must be a value of type color3"},
        {"OtherSize",
         of_node("<add name=\"n\" type=\"color3\"><input name=\"in1\" "
                 "type=\"vector2\" value=\"1, 2\"/></add>"),
         ExitCode::invalid_file, "bad.mtlx:4: \"in1\" of n is of type vector2, must be color3"},
        {"OtherShaderInput",
         in_root("<standard_surface name=\"S\" type=\"surfaceshader\"><input "
                 "name=\"base_color\" type=\"vector2\" value=\"1, "
                 "2\"/></standard_surface>"),
         ExitCode::invalid_file, "\"base_color\" of S is of type vector2, must be color3"},
        {"OtherResult",
         of_node("<position name=\"p\" type=\"vector3\"/><normalize name=\"n\" "
                 "type=\"float\"><input name=\"in\" type=\"vector3\" "
                 "nodename=\"p\"/></normalize>"),
         ExitCode::invalid_file, "\"in\" of n is of type vector3, must be float"},
        {"NotANumber", of_node(add_of + "value=\"nan, 0, 0\"/></add>"), ExitCode::invalid_file,
         "must be a value of type color3"},
        {"TooLarge", of_node(add_of + "value=\"1e30, 0, 0\"/></add>"), ExitCode::invalid_file,
         "must be a value of type color3"},
        {"ColorSpace", of_node(add_of + "value=\"1, 0, 0\" colorspace=\"mine\"/></add>"),
         ExitCode::invalid_file, "the colour space \"mine\" is not known"},
        {"NotRead", of_node("<blur name=\"n\" type=\"color3\"/>"), ExitCode::unsupported,
         "NG/n (line 4): blur is not read"},
        {"OtherSurface", in_root("<gooch_shade name=\"S\" type=\"surfaceshader\"/>"),
         ExitCode::unsupported, "the surface gooch_shade is not read"},
        {"SecondUvs",
         of_node("<texcoord name=\"t\" type=\"vector2\"><input name=\"index\" "
                 "type=\"integer\" value=\"1\"/></texcoord><convert name=\"n\" "
                 "type=\"color3\"><input name=\"in\" type=\"vector2\" "
                 "nodename=\"t\"/></convert>"),
         ExitCode::unsupported, "other than the first set are not read"},
        {"WarpedImage",
         of_node("<noise3d name=\"w\" type=\"vector2\"/><image name=\"n\" type=\"color3\"><input "
                 "name=\"file\" type=\"filename\" value=\"a.png\"/><input name=\"texcoord\" "
                 "type=\"vector2\" nodename=\"w\"/></image>"),
         ExitCode::unsupported, "its texture coordinates are no linear map"},
        {"Jpeg2000",
         of_node("<image name=\"n\" type=\"color3\"><input name=\"file\" "
                 "type=\"filename\" value=\"a.jp2\"/></image>"),
         ExitCode::unsupported, "a.jp2 is no PNG, JPEG or WebP"}};
    return all;
}

class WrongDocument : public testing::TestWithParam<Wrong> {};

TEST_P(WrongDocument, GetsOneSentenceWithItsPlace) {
    const Wrong& wrong = GetParam();
    const Problem problem = problem_of(wrong.text);
    EXPECT_EQ(problem.code, wrong.code) << problem.sentence;
    EXPECT_THAT(problem.sentence, HasSubstr(wrong.sentence));
    EXPECT_EQ(problem.sentence.find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(All, WrongDocument, testing::ValuesIn(wrong_documents()),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(MaterialXDocument, ListsAllNodesThatAreNotRead) {
    const Problem problem = problem_of(with_graph(
        "<blur name=\"a\" type=\"color3\"/><hextiledimage name=\"b\" type=\"color3\"/>\n"
        "<mix name=\"n\" type=\"color3\"><input name=\"bg\" type=\"color3\" nodename=\"a\"/><input "
        "name=\"fg\" type=\"color3\" nodename=\"b\"/><input name=\"mix\" type=\"float\" "
        "value=\"0.5\"/></mix><output name=\"out\" type=\"color3\" nodename=\"n\"/>"));
    EXPECT_EQ(problem.code, ExitCode::unsupported);
    EXPECT_THAT(problem.sentence, HasSubstr("NG/a (line 4): blur is not read; NG/b"));
}

/// A graph that adds a colour to itself, `count` times over.
std::string chain(int count) {
    std::string graph =
        "<position name=\"p\" type=\"vector3\"/><convert name=\"n0\" "
        "type=\"color3\"><input name=\"in\" type=\"vector3\" "
        "nodename=\"p\"/></convert>\n";
    for (int k = 1; k <= count; ++k)
        graph += fmt::format(
            "<add name=\"n{0}\" type=\"color3\"><input name=\"in1\" type=\"color3\" "
            "nodename=\"n{1}\"/><input name=\"in2\" type=\"color3\" nodename=\"n{1}\"/></add>\n",
            k, k - 1);
    return graph + fmt::format("<output name=\"out\" type=\"color3\" nodename=\"n{}\"/>", count);
}

TEST(MaterialXDocument, NodesUsedTwiceDoNotMultiply) {
    // Written out as a tree, these were 2^21 nodes.
    EXPECT_EQ(problem_of(with_graph(chain(20))).sentence, "");
}

TEST(MaterialXDocument, TheLimitsOfRecipesAreSentences) {
    EXPECT_THAT(problem_of(with_graph(chain(60))).sentence,
                HasSubstr("nodes are nested more than 64 deep"));
    EXPECT_THAT(problem_of(with_graph(chain(2000))).sentence,
                HasSubstr("more than 400 nodes hang on each other"));
}

/// A definition of a node that uses two of the one before.
std::string doubling(int k) {
    return fmt::format(
        "<nodedef name=\"ND_d{0}\" node=\"d{0}\"><input name=\"in\" type=\"color3\" "
        "value=\"0,0,0\"/><output name=\"out\" type=\"color3\"/></nodedef>\n<nodegraph "
        "name=\"NG_d{0}\" nodedef=\"ND_d{0}\"><d{1} name=\"a\" type=\"color3\"><input name=\"in\" "
        "type=\"color3\" interfacename=\"in\"/></d{1}><d{1} name=\"b\" type=\"color3\"><input "
        "name=\"in\" type=\"color3\" nodename=\"a\"/></d{1}><output name=\"out\" type=\"color3\" "
        "nodename=\"b\"/></nodegraph>\n",
        k, k - 1);
}

TEST(MaterialXDocument, DefinitionsThatMultiplyOrUseThemselvesEnd) {
    std::string bomb = with_graph(
        "<d25 name=\"n\" type=\"color3\"/><output name=\"out\" type=\"color3\" nodename=\"n\"/>");
    std::string definitions;
    for (int k = 1; k <= 25; ++k) definitions += doubling(k);
    for (std::size_t at = definitions.find("d0 name"); at != std::string::npos;
         at = definitions.find("d0 name"))
        definitions.replace(at, 2, "absval");
    for (std::size_t at = definitions.find("</d0>"); at != std::string::npos;
         at = definitions.find("</d0>"))
        definitions.replace(at, 5, "</absval>");
    bomb.insert(bomb.find("<nodegraph"), definitions);
    EXPECT_EQ(problem_of(bomb).code, ExitCode::invalid_file);

    std::string self = with_graph(
        "<d1 name=\"n\" type=\"color3\"/><output name=\"out\" type=\"color3\" nodename=\"n\"/>");
    std::string own = doubling(1);
    for (std::size_t at = own.find("<d0"); at != std::string::npos; at = own.find("<d0"))
        own.replace(at, 3, "<d1");
    for (std::size_t at = own.find("</d0"); at != std::string::npos; at = own.find("</d0"))
        own.replace(at, 4, "</d1");
    self.insert(self.find("<nodegraph"), own);
    EXPECT_EQ(problem_of(self).code, ExitCode::invalid_file);
}

TEST(MaterialXDocument, ElementsAreNotTooDeep) {
    std::string deep;
    for (int k = 0; k < 100000; ++k) deep += "<a>";
    for (int k = 0; k < 100000; ++k) deep += "</a>";
    EXPECT_THAT(problem_of(in_root(deep)).sentence, HasSubstr("more than 64 deep"));
}

TEST(MaterialXDocument, TextIsUtf8) {
    const auto with_name = [](const std::string& name) {
        return of_node("<constant name=\"n\" type=\"color3\" doc=\"" + name + "\"/>");
    };
    EXPECT_EQ(problem_of(with_name("gr\xc3\xbcn")).code, ExitCode::ok);
    const Problem latin = problem_of(with_name("gr\xfcn"));
    EXPECT_EQ(latin.code, ExitCode::invalid_file);
    EXPECT_THAT(latin.sentence, HasSubstr(":4: the text is not UTF-8"));
}

TEST(MaterialXDocument, CutAnywhereItIsRefusedOrRead) {
    const std::string whole = with_graph(chain(2));
    for (std::size_t length = 0; length < whole.size(); length += 7) {
        const ExitCode code = problem_of(whole.substr(0, length)).code;
        EXPECT_TRUE(code == ExitCode::invalid_file) << length;
    }
}

const std::string two_materials = in_root(
    "<standard_surface name=\"A\" type=\"surfaceshader\"><input name=\"base_color\" "
    "type=\"color3\" value=\"0.5, 0.5, 0.5\"/></standard_surface><standard_surface "
    "name=\"B\" type=\"surfaceshader\"/><surfacematerial name=\"oak\" "
    "type=\"material\"><input name=\"surfaceshader\" type=\"surfaceshader\" "
    "nodename=\"A\"/></surfacematerial><surfacematerial name=\"iron\" "
    "type=\"material\"><input name=\"surfaceshader\" type=\"surfaceshader\" "
    "nodename=\"B\"/></surfacematerial>");

TEST(MaterialXDocument, OfSeveralMaterialsOneIsNamed) {
    const Problem none = problem_of(two_materials, "a.mtlx");
    EXPECT_EQ(none.code, ExitCode::usage);
    EXPECT_THAT(none.sentence, HasSubstr("2 materials; choose one by a.mtlx#NAME, NAME being oak, "
                                         "iron"));
    EXPECT_THAT(problem_of(two_materials, "a.mtlx#ash").sentence,
                HasSubstr("there is no material \"ash\""));
    EXPECT_EQ(parse_recipe(recipe_of_materialx(two_materials, "a.mtlx#oak").json, "a").name, "oak");
}

TEST(MaterialXDocument, PathsOfDocuments) {
    EXPECT_TRUE(names_materialx("a/b.mtlx"));
    EXPECT_TRUE(names_materialx("b.mtlx#oak"));
    EXPECT_FALSE(names_materialx("b.json"));
    EXPECT_FALSE(names_materialx("b.mtlx.json"));
    EXPECT_EQ(materialx_path("a/b.mtlx#oak").file, "a/b.mtlx");
    EXPECT_EQ(materialx_path("a/b.mtlx#oak").material, "oak");
    EXPECT_EQ(materialx_path("a#b.json").file, "a#b.json");
}

}  // namespace
}  // namespace burl
