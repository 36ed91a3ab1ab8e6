// SPDX-License-Identifier: MIT
//
// Suggestions for misspelt names: every single edit of a known name finds that name, and a word that is far
// from all names finds none.
#include "edgewise/input/known_names.hpp"

#include <gmock/gmock.h>

namespace edgewise {
namespace {

const std::vector<std::string> layouts = {"aos",       "soa",        "lean",    "linked",
                                          "quantised", "points_soa", "hot_cold"};

TEST(KnownNames, CountsEdits) {
    EXPECT_EQ(edits_between("lean", "lean"), 0);
    EXPECT_EQ(edits_between("LEAN", "lean"), 0) << "case is no edit";
    EXPECT_EQ(edits_between("lean", "leen"), 1);
    EXPECT_EQ(edits_between("lean", "laen"), 1) << "neighbours swapped";
    EXPECT_EQ(edits_between("lean", "len"), 1);
    EXPECT_EQ(edits_between("", "lean"), 4);
    EXPECT_EQ(edits_between("kitten", "sitting"), 3);
}

/// Triangle inequality does not hold for this distance, but symmetry does.
TEST(KnownNames, CountsTheSameBothWays) {
    for (const std::string& a : layouts)
        for (const std::string& b : layouts) EXPECT_EQ(edits_between(a, b), edits_between(b, a)) << a << b;
}

TEST(KnownNames, FindsANameBehindEverySingleSlip) {
    int slips = 0;
    for (const std::string& name :
         {std::string("linked"), std::string("quantised"), std::string("hot_cold")}) {
        for (std::size_t i = 0; i < name.size(); ++i) {
            std::string left_out = name, replaced = name, doubled = name;
            left_out.erase(i, 1);
            replaced[i] = 'x';
            doubled.insert(i, 1, name[i]);
            for (const std::string& slip : {left_out, replaced, doubled}) {
                EXPECT_EQ(nearest_name(slip, layouts), name) << slip;
                ++slips;
            }
        }
    }
    EXPECT_EQ(slips, 3 * (6 + 9 + 8));
    EXPECT_EQ(nearest_name("AoS", layouts), "aos");
    EXPECT_EQ(nearest_name("points", layouts), "points_soa") << "what begins a name";
}

TEST(KnownNames, FindsNothingFarFromAll) {
    for (const char* far : {"", "x", "nope", "--bodies", "tetrahedron"})
        EXPECT_EQ(nearest_name(far, layouts), std::nullopt) << far;
    EXPECT_EQ(nearest_name("aos", {}), std::nullopt);
}

TEST(KnownNames, SayBoth) {
    EXPECT_EQ(unknown_name("layout", "lena", {"aos", "lean"}),
              "unknown layout 'lena'; did you mean 'lean'? known: aos, lean");
    EXPECT_EQ(unknown_name("layout", "nope", {"aos", "lean"}), "unknown layout 'nope'; known: aos, lean");
}

TEST(KnownNames, RefusesOnOneLineWhateverTheNameHolds) {
    const std::string line = unknown_name("member", "va\nry\t\x7f", {"vary"});
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
    EXPECT_NE(line.find("'va?ry??'"), std::string::npos) << line;
    EXPECT_LT(unknown_name("member", std::string(5000, 'x'), {"vary"}).size(), 300U);
}

}  // namespace
}  // namespace edgewise
