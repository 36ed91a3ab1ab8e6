// SPDX-License-Identifier: MIT
//
// Names of figures: written, looked up and read back.
#include "edgewise/store/vocabulary.hpp"

#include <gtest/gtest.h>

#include <set>

namespace edgewise::store {
namespace {

constexpr FigureName misses("caches.{machine}.{level}.misses_per_query");

TEST(Vocabulary, NamesEachFigureOnceWithAUnitAndAMeaning) {
    std::set<std::string_view> keys;
    for (const auto part : vocabulary_parts) {
        for (const FigureInfo& info : part) {
            EXPECT_TRUE(keys.insert(info.key).second) << info.key;
            EXPECT_NE(info.key.find('.'), std::string_view::npos) << info.key;
            EXPECT_FALSE(info.unit.empty() || info.meaning.empty()) << info.key;
        }
    }
    EXPECT_GT(keys.size(), 150U);
}

/// A figure that is made is found again, filled or not.
TEST(Vocabulary, FindsWhatItMakes) {
    for (const auto part : vocabulary_parts) {
        for (const FigureInfo& info : part) {
            std::string name(info.name());
            for (std::size_t open; (open = name.find('{')) != std::string::npos;)
                name.replace(open, name.find('}') + 1 - open, "x1");
            EXPECT_EQ(find_figure(info.probe(), name), &info) << info.key;
        }
    }
    EXPECT_EQ(find_figure("time", "al_ns"), nullptr);
    EXPECT_EQ(find_figure("caches", "all_ns"), nullptr);
    EXPECT_EQ(find_figure("caches", "zen5..misses_per_query"), nullptr);
}

TEST(Vocabulary, FillsBracesInOrder) {
    EXPECT_EQ(misses.of("zen5/random", "L1D").name(), "zen5/random.L1D.misses_per_query");
    EXPECT_EQ(misses.of("zen5").name(), "zen5.{level}.misses_per_query");
    const measure::Figure made = figure(misses.of("zen5", "L2"), 1.5);
    EXPECT_EQ(made.name, "zen5.L2.misses_per_query");
    EXPECT_EQ(made.unit, "misses");
    EXPECT_EQ(made.value, 1.5);
    const measure::Figure none = no_figure("time.all_ns", "why", "what to do");
    EXPECT_FALSE(none.value);
    EXPECT_EQ(none.reason, "why");
    EXPECT_EQ(none.remedy, "what to do");
}

TEST(Vocabulary, ReadsBackWhatFillsBraces) {
    const FigureName of_zen5 = misses.of("zen5");
    EXPECT_EQ(of_zen5.value_in("caches", "zen5.L2.misses_per_query"), "L2");
    EXPECT_EQ(of_zen5.value_in("reuse", "zen5.L2.misses_per_query"), std::nullopt);
    EXPECT_EQ(of_zen5.value_in("caches", "zen5.misses_per_query"), std::nullopt);
    EXPECT_EQ(of_zen5.value_in("caches", "zen4.L2.misses_per_query"), std::nullopt);
    EXPECT_EQ(of_zen5.value_in("caches", "zen5.L2.emptied_misses_per_query"), std::nullopt);
    EXPECT_EQ(of_zen5.value_in("caches", "zen5.L2.misses_per_query.warm"), std::nullopt);
    constexpr FigureName curve("reuse.line_misses_at_2^{power}");
    EXPECT_EQ(curve.value_in("reuse", "line_misses_at_2^10"), "10");
    EXPECT_EQ(curve.value_in("reuse", "line_misses_at_2^10.cold"), std::nullopt) << "another population";
    EXPECT_EQ(FigureName("reuse.page_misses_at_2^{power}").value_in("reuse", "page_misses_at_2^15"), "15");
}

}  // namespace
}  // namespace edgewise::store
