// SPDX-License-Identifier: MIT
//
// The checks themselves: each finds a planted fault, and accepts what is allowed.
#include <gtest/gtest.h>

#include "house.hpp"

namespace edgewise::house {
namespace {

using Rule = Violations (*)(const Files& files);

/// Returns the violations of `rule` in one file, as text.
std::string verdict(Rule rule, const std::string& path, const std::string& text) {
    return to_text(rule({source_file(path, text)}));
}

std::string including(const std::string& name) { return "// a\n#include \"" + name + "\"\n"; }

std::string verdict_on(const std::string& path, const std::string& include) {
    return verdict(forbidden_includes, path, including(include));
}

TEST(DependencyRule, CatchesPlantedViolations) {
    EXPECT_EQ(verdict_on("src/edgewise/geometry/vec.hpp", "edgewise/table/ring.hpp"),
              "src/edgewise/geometry/vec.hpp:2: geometry may not include table (edgewise/table/ring.hpp)\n");
    const char* const forbidden[][2] = {
        {"src/edgewise/algorithms/vclip/x.hpp", "edgewise/truth/dyadic.hpp"},
        {"src/edgewise/algorithms/gjk.hpp", "edgewise/layouts/aos.hpp"},
        {"src/edgewise/cli/main.cpp", "edgewise/probes/time.hpp"},
        {"layouts/aos.hpp", "edgewise/algorithms/gjk.hpp"},
        {"probes/time.hpp", "edgewise/sweep/work.hpp"},
        {"reports/page/page.cpp", "edgewise/sweep/work.hpp"},
        {"src/edgewise/measure/machine/machine.hpp", "edgewise/table/ring.hpp"},
        {"src/edgewise/table/ring.hpp", "ring_edge.hpp"},
        {"src/edgewise/table/ring.hpp", "edgewise/kitchen/sink.hpp"},
        {"src/edgewise/kitchen/sink.hpp", "edgewise/geometry/vec.hpp"}};
    for (const auto& [path, include] : forbidden) EXPECT_NE(verdict_on(path, include), "") << path;
}

TEST(DependencyRule, LetsPassWhatIsAllowed) {
    const char* const allowed[][2] = {
        {"src/edgewise/sweep/run.cpp", "edgewise/geometry/vec.hpp"},
        {"src/edgewise/cli/main.cpp", "edgewise/measure/machine/machine.hpp"},
        {"probes/error.hpp", "edgewise/geometry/vec.hpp"},
        {"reports/page/page.cpp", "edgewise/store/schema.hpp"},
        {"src/edgewise/algorithms/vclip/x.hpp", "edgewise/algorithms/vclip/y.hpp"},
        {"tests/unit/x_test.cpp", "geometry_bodies.hpp"}};
    for (const auto& [path, include] : allowed) EXPECT_EQ(verdict_on(path, include), "");
}

TEST(IncludeCycles, AreFoundThroughSeveralFiles) {
    EXPECT_EQ(
        to_text(include_cycles({source_file("src/edgewise/table/a.hpp", including("edgewise/table/b.hpp")),
                                source_file("src/edgewise/table/b.hpp", including("edgewise/table/c.hpp")),
                                source_file("src/edgewise/table/c.hpp", including("edgewise/table/a.hpp")),
                                source_file("src/edgewise/table/d.hpp", including("edgewise/table/a.hpp"))})),
        "src/edgewise/table/c.hpp:2: includes itself through edgewise/table/a.hpp\n");
}

TEST(LongFunctions, AreCountedToTheLine) {
    const auto of_function = [](const std::string& before, const std::string& head, std::size_t lines) {
        const std::string indentation(head.find_first_not_of(' '), ' ');
        std::string text = before + head + " {\n";
        for (std::size_t i = 2; i < lines; ++i) text += i % 2 ? "\n" : "#define A\n";
        return verdict(long_functions, "x.cpp", text + indentation + "}\n");
    };
    for (const char* head : {"int f()", "    C()\n        : a_{a}, b_(a)"}) {
        EXPECT_EQ(of_function("class C {\n", head, longest_function - 1), "");
        EXPECT_NE(of_function("class C {\n", head, longest_function + 1), "");
    }
    EXPECT_EQ(of_function("", "int f()", longest_function), "");
    EXPECT_EQ(of_function("int a;\n", "int f()", longest_function + 1), "x.cpp:2: a function of 41 lines\n");
    EXPECT_NE(of_function("template <class T>\n", "int f()", longest_function), "");
    const std::string lines(longest_function, '\n');
    EXPECT_EQ(verdict(long_functions, "x.cpp", "namespace a {\n" + lines + "}  // namespace a\n"), "");
    EXPECT_EQ(verdict(long_functions, "x.cpp", "struct A {\n" + lines + "};\n"), "");
}

TEST(FileRules, CatchPlantedViolations) {
    const std::string slash = "/";  // in pieces: this file is checked as well
    const struct {
        Rule rule;
        const char* path;
        std::string text;
        bool is_wrong;
    } cases[] = {
        {missing_licences, "src/edgewise/x.hpp", "#pragma once\n", true},
        {missing_licences, "tests/go", "#!/bin/sh\n", true},
        {missing_licences, "README.md", "# x\n", false},
        {long_files, "src/edgewise/x.hpp", std::string(longest_file + 1, '\n'), true},
        {long_files, "src/edgewise/x.hpp", std::string(longest_file, '\n'), false},
        {foreign_matter, "a.sh", "cd " + slash + "home/me\n", true},
        {foreign_matter, "a.sh", std::string("curl registry") + ".npm\n", true},
        {foreign_matter, "vega.min.js", "", true},
        {foreign_matter, "src/edgewise/x.hpp", std::string("// Copy") + "right (c) 1999 Somebody\n", true},
        {foreign_matter, "src/edgewise/x.hpp", "// fine\n", false},
        {own_flattening, "a.hpp", "__attribute__" + std::string("((flatten, noinline)) void run() {"), true},
        {own_flattening, "a.hpp", "[" + std::string("[gnu::flatten]] void run() {"), true},
        {own_flattening, "a.hpp", "__attribute__" + std::string("((no_sanitize(\"address\"))) void f() {"),
         true},
        {own_flattening, "a.hpp", "EDGEWISE_QUERY_LOOP void run() {", false},
        {own_flattening, "a.hpp", "// Flattened, as the tree is.", false},
    };
    for (const auto& [rule, path, text, is_wrong] : cases)
        EXPECT_EQ(!verdict(rule, path, text).empty(), is_wrong) << path << ": " << text.substr(0, 100);
}

TEST(LongReadme, IsCountedInWords) {
    const auto of_words = [](std::size_t words) {
        std::string text;
        for (std::size_t i = 0; i < words; ++i) text += i % 9 ? "word " : "word\n";
        return verdict(long_readme, "README.md", text) + verdict(long_readme, "docs/README.md", text + text);
    };
    EXPECT_EQ(of_words(readme_words), "");
    EXPECT_EQ(of_words(readme_words + 1), "README.md:0: 901 words\n");
}

TEST(TypesNamedTwice, AreSeenAcrossHeadersOfOneNamespace) {
    const auto of_second = [](const std::string& text) {
        return to_text(types_named_twice(
            {source_file("src/edgewise/a.hpp", "namespace edgewise {\nstruct Grid {\n};\n}\n"),
             source_file("src/edgewise/b.hpp", "namespace " + text + "}\n")}));
    };
    EXPECT_EQ(of_second("edgewise {\nclass Grid final : A {\n};\n"),
              "src/edgewise/b.hpp:2: edgewise::Grid is also in src/edgewise/a.hpp\n");
    EXPECT_EQ(of_second("edgewise {\nstruct Grid;\nstruct Grid<int> {\n};\n"), "");
    EXPECT_EQ(of_second("other {\nstruct Grid {\n};\n"), "");
}

TEST(StdHeaders, AreIncludedWhereTheirNamesStand) {
    const auto of = [](const std::string& path, const std::string& text) {
        return verdict(missing_std_headers, path, text);
    };
    EXPECT_EQ(of("src/edgewise/table/a.hpp", "std::vector<int> v;\nstd::vector<int> w;\n"),
              "src/edgewise/table/a.hpp:1: vector needs #include <vector>\n");
    EXPECT_EQ(of("layouts/a.hpp", "void f() { assert(x); }\n"),
              "layouts/a.hpp:1: assert needs #include <cassert>\n");
    EXPECT_NE(of("layouts/a.hpp", "std::chrono::seconds s;\n"), "") << "not in the table";
    EXPECT_EQ(of("layouts/a.hpp", "#include <vector>\n// std::string\nstd::vector<int> v;\n"), "");
    EXPECT_EQ(of("layouts/a.hpp", "static_assert(true);\nconst char* a = \"std::string\";\n"), "");
    EXPECT_EQ(of("src/edgewise/cli/a.hpp", "std::vector<int> v;\n"), "") << "not installed";
}

TEST(DeadMentions, AreFilesThatACommentNamesAndTheTreeLacks) {
    const auto of = [](const std::string& line) {
        return to_text(dead_mentions({source_file("src/edgewise/table/ring.hpp", line + "\n"),
                                      source_file("tests/contract/type.hpp.in", "")}));
    };
    const std::string slashes = "// ";  // in two pieces: this file is checked as well
    EXPECT_EQ(of(slashes + "See rings.hpp."), "src/edgewise/table/ring.hpp:1: there is no rings.hpp\n");
    EXPECT_NE(of(slashes + "(rings/ring.hpp)"), "");
    EXPECT_EQ(of(slashes + "(ring.hpp), table/ring.hpp and edgewise/src/edgewise/table/ring.hpp"), "");
    EXPECT_EQ(of(slashes + "edgewise/table/ring.hpp, and type.hpp, which is generated"), "");
    EXPECT_EQ(of(slashes + "the file NAME.hpp, ../ring.hpp"), "");
    EXPECT_EQ(of("#include \"rings.hpp\""), "");
}

}  // namespace
}  // namespace edgewise::house
