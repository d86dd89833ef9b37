// The text of documents: what XML reserves, names, and numbers.
#include "app/materialx/write/xml.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace burl::materialx {
namespace {

TEST(MaterialXText, EscapesWhatXmlReserves) {
    XmlElement root{"a", {{"x", "<\"&'>\n\x01"}}};
    root.add({"b", {}, {}, "one -- two"});
    EXPECT_EQ(xml_text(root),
              "<?xml version=\"1.0\"?>\n"
              "<a x=\"&lt;&quot;&amp;'&gt;&#10;?\">\n"
              "  <!-- one - - two -->\n"
              "  <b />\n"
              "</a>\n");
}

TEST(MaterialXText, NamesAreOfLettersDigitsAndUnderscores) {
    EXPECT_EQ(element_name("teapot marble"), "teapot_marble");
    EXPECT_EQ(element_name("3 worlds"), "_3_worlds");
    EXPECT_EQ(element_name(""), "_");
    EXPECT_EQ(element_name("\xc3\xa4<"), "___");
}

TEST(MaterialXText, NumbersReadBackAsTheSameFloats) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> mantissa(-1.0, 1.0);
    for (int k = 0; k < 10000; ++k) {
        const double number = std::ldexp(mantissa(random), k % 60 - 30);
        EXPECT_EQ(std::stof(value_text(number)), float(number));
    }
    EXPECT_EQ(value_text(0.1), "0.1");
}

}  // namespace
}  // namespace burl::materialx
