// SPDX-License-Identifier: MIT
//
// Further axes: read, written back the same, and refused with what is known.
#include "edgewise/sweep/axes.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace edgewise::sweep {
namespace {

std::string error_of(const char* text) {
    try {
        static_cast<void>(parse_axes(text));
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

TEST(Axes, ReadBackAsTheyAreWritten) {
    for (const char* text :
         {"", "contact_tolerance=0.001", "gap_tolerance=1e-06", "contact_tolerance=1e+20+gap_tolerance=0.01",
          "order=bfs", "order=spatial", "order=rcm", "sharing=per_instance", "sharing=shared",
          "allocator=jemalloc", "batch=yes", "start=cold", "sub_distance=johnson", "hardening=off",
          "needs=verdict", "needs=certificate", "needs=nearer+margin=0.1", "needs=nearer+margin=0.02",
          "gap_tolerance=0.5+order=bfs+sharing=shared+allocator=libc"}) {
        EXPECT_EQ(parse_axes(text).text(), text);
    }
    EXPECT_EQ(parse_axes("gap_tolerance=0.010+contact_tolerance=1").text(),
              "contact_tolerance=1+gap_tolerance=0.01");
    EXPECT_EQ(parse_axes("gap_tolerance=0").text(), "");
    EXPECT_EQ(parse_axes("order=given+allocator=arena").text(), "");
    EXPECT_EQ(parse_axes("needs=witnesses").text(), "");
    EXPECT_EQ(parse_axes("sub_distance=cofactors").text(), "");
    EXPECT_EQ(parse_axes("sub_distance=johnson").query.sub_distance, SubDistanceSolver::johnson);
    EXPECT_TRUE(parse_axes("needs=verdict").query.verdict_only);
    EXPECT_FALSE(parse_axes("needs=depth").query.verdict_only);
    EXPECT_EQ(parse_axes("needs=nearer").text(), "needs=nearer+margin=0.1") << "a condition of its figures";
    EXPECT_EQ(parse_axes("margin=2+needs=nearer").margin, 2);
    EXPECT_FALSE(parse_axes("needs=nearer").query.verdict_only) << "bounds come from whole distances";
}

TEST(Axes, ConcernOnlyWhatTheyChange) {
    EXPECT_FALSE(Axes{}.concerns("gjk"));
    EXPECT_TRUE(parse_axes("gap_tolerance=0.1").concerns("gjk"));
    EXPECT_FALSE(parse_axes("gap_tolerance=0.1").concerns("vclip"));
    EXPECT_TRUE(parse_axes("sub_distance=johnson").concerns("gjk"));
    EXPECT_FALSE(parse_axes("sub_distance=johnson").concerns("vclip"));
    EXPECT_TRUE(parse_axes("contact_tolerance=0.1").concerns("vclip"));
    EXPECT_TRUE(parse_axes("order=bfs").concerns("vclip"));
    EXPECT_TRUE(parse_axes("batch=yes").concerns("vclip"));
    EXPECT_TRUE(parse_axes("start=cold").concerns("vclip"));
    EXPECT_TRUE(parse_axes("hardening=off").concerns("vclip"));
    EXPECT_FALSE(parse_axes("hardening=off").concerns("gjk"));
    EXPECT_EQ(parse_axes("hardening=on").text(), "");
    EXPECT_THROW(static_cast<void>(parse_axes("hardening=maybe")), std::invalid_argument);
    EXPECT_TRUE(parse_axes("allocator=libc").concerns("gjk"));
}

TEST(Axes, BadOnesAreOneClearLine) {
    for (const char* text : {"gap_tolerance", "gap_tolerance=", "gap_tolerance=1", "gap_tolerance=-0.1",
                             "gap_tolerance=nan", "gap_tolerance=0.1x", "contact_tolerance=inf"}) {
        EXPECT_NE(error_of(text).find("wants a number from 0"), std::string::npos) << text << error_of(text);
    }
    EXPECT_NE(error_of("order=random").find("wants given|bfs|spatial|rcm"), std::string::npos);
    EXPECT_NE(error_of("sharing").find("wants shared|per_instance"), std::string::npos);
    EXPECT_NE(error_of("allocator=mine").find("wants arena|jemalloc|libc"), std::string::npos);
    EXPECT_NE(error_of("margin=0.1").find("write both"), std::string::npos);
    EXPECT_NE(error_of("needs=nearer+batch=yes").find("leave batch out"), std::string::npos);
    EXPECT_NE(error_of("batch=maybe").find("no|yes"), std::string::npos);
    EXPECT_NE(error_of("start=warm").find("kept|cold"), std::string::npos);
    EXPECT_NE(error_of("sub_distance=volumes").find("wants cofactors|johnson"), std::string::npos);
    EXPECT_NE(error_of("needs=verdict+margin=0.1").find("write both"), std::string::npos);
    EXPECT_NE(error_of("needs=nearer+margin=0").find("above 0"), std::string::npos);
    EXPECT_NE(error_of("needs=nearer+margin=x").find("wants a number"), std::string::npos);
    EXPECT_NE(error_of("needs=nearer+contact_tolerance=1").find("leave contact_tolerance out"),
              std::string::npos);
    EXPECT_NE(error_of("speed=3").find("unknown; known: "), std::string::npos);
}

}  // namespace
}  // namespace edgewise::sweep
