#include "app/base/messages.h"

#include <vector>

#include <gtest/gtest.h>

namespace burl {
namespace {

TEST(NearestWord, CountsEdits) {
    const std::vector<std::string_view> words{"amplitude", "frequency", "phase", "gain"};
    EXPECT_EQ(nearest_word("amplitde", words), "amplitude");
    EXPECT_EQ(nearest_word("gian", words), "gain");
    EXPECT_EQ(nearest_word("Phase", words), "phase");
    EXPECT_EQ(nearest_word("zzzzzz", words), "");
    EXPECT_EQ(nearest_word("brightness", words), "");  // shares letters with all of them
    EXPECT_EQ(nearest_word("x", std::vector<std::string_view>()), "");
}

TEST(NearestWord, CountsAnExchangeOfNeighboursAsOne) {
    const std::vector<std::string_view> words{"opal", "oak"};
    EXPECT_EQ(nearest_word("oka", words), "oak");
    EXPECT_EQ(nearest_word("oka", std::vector<std::string>{"opal", "oak"}).size(), 3U);
}

}  // namespace
}  // namespace burl
