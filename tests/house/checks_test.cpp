// SPDX-License-Identifier: MIT
//
// The checks themselves: each catches what was planted for it, and lets pass what it should.
#include <gtest/gtest.h>

#include "dependency_rule.hpp"
#include "file_rules.hpp"
#include "function_spans.hpp"
#include "std_headers.hpp"
#include "text_rules.hpp"

namespace edgewise::house {
namespace {

std::string including(const std::string& name) { return "// a\n#include \"" + name + "\"\n"; }

std::string verdict_on(const std::string& path, const std::string& include) {
    return to_text(forbidden_includes({source_file(path, including(include))}));
}

TEST(DependencyRule, CatchesPlantedViolations) {
    EXPECT_EQ(verdict_on("src/edgewise/geometry/vec.hpp", "edgewise/table/ring.hpp"),
              "src/edgewise/geometry/vec.hpp:2: geometry may not include table (edgewise/table/ring.hpp)\n");
    EXPECT_NE(verdict_on("src/edgewise/algorithms/vclip/x.hpp", "edgewise/truth/dyadic.hpp"), "");
    EXPECT_NE(verdict_on("src/edgewise/algorithms/gjk.hpp", "edgewise/layouts/aos.hpp"), "");
    EXPECT_NE(verdict_on("src/edgewise/cli/main.cpp", "edgewise/probes/time.hpp"), "");
    EXPECT_NE(verdict_on("layouts/aos.hpp", "edgewise/algorithms/gjk.hpp"), "");
    EXPECT_NE(verdict_on("probes/time.hpp", "edgewise/sweep/run.hpp"), "");
    EXPECT_NE(verdict_on("reports/page/page.cpp", "edgewise/sweep/run.hpp"), "");
    EXPECT_NE(verdict_on("src/edgewise/measure/machine/cpu.hpp", "edgewise/table/ring.hpp"), "");
    EXPECT_NE(verdict_on("src/edgewise/table/ring.hpp", "ring_edge.hpp"), "");
    EXPECT_NE(verdict_on("src/edgewise/table/ring.hpp", "edgewise/kitchen/sink.hpp"), "");
    EXPECT_NE(verdict_on("src/edgewise/kitchen/sink.hpp", "edgewise/geometry/vec.hpp"), "");
}

TEST(DependencyRule, LetsPassWhatIsAllowed) {
    EXPECT_EQ(verdict_on("src/edgewise/sweep/run.cpp", "edgewise/geometry/vec.hpp"), "");
    EXPECT_EQ(verdict_on("src/edgewise/cli/main.cpp", "edgewise/measure/machine/cpu.hpp"), "");
    EXPECT_EQ(verdict_on("probes/error.hpp", "edgewise/geometry/vec.hpp"), "");
    EXPECT_EQ(verdict_on("reports/page/page.cpp", "edgewise/store/schema.hpp"), "");
    EXPECT_EQ(verdict_on("src/edgewise/algorithms/vclip/x.hpp", "edgewise/algorithms/vclip/y.hpp"), "");
    EXPECT_EQ(verdict_on("tests/unit/x_test.cpp", "geometry_bodies.hpp"), "");
}

TEST(IncludeCycles, AreFoundThroughSeveralFiles) {
    const std::vector<SourceFile> files = {
        source_file("src/edgewise/table/a.hpp", including("edgewise/table/b.hpp")),
        source_file("src/edgewise/table/b.hpp", including("edgewise/table/c.hpp")),
        source_file("src/edgewise/table/c.hpp", including("edgewise/table/a.hpp")),
        source_file("src/edgewise/table/d.hpp", including("edgewise/table/a.hpp")),
    };
    EXPECT_EQ(to_text(include_cycles(files)),
              "src/edgewise/table/c.hpp:2: includes itself through edgewise/table/a.hpp\n");
}

TEST(FunctionSpans, GoFromTheNameToTheBrace) {
    const SourceFile file = source_file("x.cpp", R"code(
namespace a {
/// What it does {
int one(int x) {
    const auto inner = [](int y) {
        return y;
    };
    return inner(x) + '}' + 1'000;
}
struct Two {
  public:
    Two(int a)
        : a_{a}, b_(a) {
        if (a) {
            b_ = a;
        }
    }
    int a_ = {}, b_;
};
const std::vector<int> three = {
    f(1),
};
const char* four = R"(} {)";
template <class T>
concept Five = requires(T t) {
    t.x();
};
}  // namespace a
)code");
    const auto spans = function_spans(file.lines);
    ASSERT_EQ(spans.size(), 2u);
    EXPECT_EQ(spans[0].first, 4u);
    EXPECT_EQ(spans[0].last, 9u);
    EXPECT_EQ(spans[1].first, 12u);
    EXPECT_EQ(spans[1].last, 17u);
}

TEST(LongFunctions, AreCountedToTheLine) {
    const auto function_of = [](std::size_t lines) {
        std::string text = "int f() {\n";
        for (std::size_t i = 2; i < lines; ++i) text += "    g();\n";
        return source_file("src/edgewise/x.cpp", text + "}\n");
    };
    EXPECT_TRUE(long_functions({function_of(longest_function)}).empty());
    EXPECT_EQ(to_text(long_functions({function_of(longest_function + 1)})),
              "src/edgewise/x.cpp:1: a function of 41 lines\n");
}

TEST(FileRules, CatchPlantedViolations) {
    EXPECT_EQ(missing_licences({source_file("src/edgewise/x.hpp", "#pragma once\n")}).size(), 1u);
    EXPECT_EQ(missing_licences({source_file("tests/go", "#!/bin/sh\n")}).size(), 1u);
    EXPECT_EQ(missing_licences({source_file("README.md", "# x\n")}).size(), 0u);
    EXPECT_EQ(long_files({source_file("src/edgewise/x.hpp", std::string(longest_file + 1, '\n'))}).size(),
              1u);
    EXPECT_EQ(long_files({source_file("src/edgewise/x.hpp", std::string(longest_file, '\n'))}).size(), 0u);
    EXPECT_EQ(foreign_matter({source_file("a.sh",
                                          "cd /ho"
                                          "me/me\n")})
                  .size(),
              1u);
    EXPECT_EQ(foreign_matter({source_file("a.sh",
                                          "curl regis"
                                          "try.npm\n")})
                  .size(),
              1u);
    EXPECT_EQ(foreign_matter({source_file("vega.min.js", "")}).size(), 1u);
    EXPECT_EQ(foreign_matter({source_file("src/edgewise/x.hpp",
                                          "// Copy"
                                          "right (c) 1999 Somebody\n")})
                  .size(),
              1u);
    EXPECT_EQ(foreign_matter({source_file("src/edgewise/x.hpp", "// fine\n")}).size(), 0u);
}

TEST(TypesNamedTwice, AreSeenAcrossHeadersOfOneNamespace) {
    const auto header = [](const char* path, const std::string& text) {
        return source_file(path, "namespace edgewise {\n" + text + "}\n");
    };
    const SourceFile first = header("src/edgewise/a.hpp", "struct Grid {\n};\n");
    EXPECT_EQ(
        to_text(types_named_twice({first, header("src/edgewise/b.hpp", "class Grid final : A {\n};\n")})),
        "src/edgewise/b.hpp:2: edgewise::Grid is also in src/edgewise/a.hpp\n");
    EXPECT_TRUE(
        types_named_twice({first, header("src/edgewise/b.hpp", "struct Grid;\nstruct Grid<int> {\n};\n")})
            .empty());
    EXPECT_TRUE(types_named_twice(
                    {first, source_file("src/edgewise/b.hpp", "namespace other {\nstruct Grid {\n};\n}\n")})
                    .empty());
}

TEST(StdHeaders, AreIncludedWhereTheirNamesStand) {
    const auto verdict = [](const std::string& path, const std::string& text) {
        return to_text(missing_std_headers({source_file(path, text)}));
    };
    EXPECT_EQ(verdict("src/edgewise/table/a.hpp", "std::vector<int> v;\nstd::vector<int> w;\n"),
              "src/edgewise/table/a.hpp:1: vector needs #include <vector>\n");
    EXPECT_EQ(verdict("layouts/a.hpp", "void f() { assert(x); }\n"),
              "layouts/a.hpp:1: assert needs #include <cassert>\n");
    EXPECT_NE(verdict("layouts/a.hpp", "std::chrono::seconds s;\n"), "") << "not in the table";
    EXPECT_EQ(verdict("layouts/a.hpp", "#include <vector>\n// std::string\nstd::vector<int> v;\n"), "");
    EXPECT_EQ(verdict("layouts/a.hpp", "static_assert(true);\nconst char* a = \"std::string\";\n"), "");
    EXPECT_EQ(verdict("src/edgewise/cli/a.hpp", "std::vector<int> v;\n"), "") << "not installed";
}

TEST(OwnFlattening, IsSeenInEitherSpelling) {
    const auto verdict = [](const std::string& line) {
        return to_text(own_flattening({source_file("src/edgewise/table/ring.hpp", line + "\n")}));
    };
    const std::string what =
        "src/edgewise/table/ring.hpp:1: flatten or no_sanitize: use EDGEWISE_QUERY_LOOP\n";
    EXPECT_EQ(verdict("[[nodiscard]] __attribute__(("
                      "flatten, noinline)) Distance run() {"),
              what);
    EXPECT_EQ(verdict("[[gnu::"
                      "flatten]] void run() {"),
              what);
    EXPECT_EQ(verdict("__attribute__((noinline, "
                      "no_sanitize(\"address\"))) void run() {"),
              what);
    EXPECT_EQ(verdict("EDGEWISE_QUERY_LOOP void run() {"), "");
    EXPECT_EQ(verdict("// Flattened, as the tree is."), "");
}

TEST(DeadMentions, AreFilesThatACommentNamesAndNobodyHas) {
    const auto verdict = [](const std::string& line) {
        return to_text(dead_mentions({source_file("src/edgewise/table/ring.hpp", line + "\n"),
                                      source_file("tests/contract/type.hpp.in", "")}));
    };
    const std::string slashes = "// ";  // in two pieces: this file is checked as well
    EXPECT_EQ(verdict(slashes + "See rings.hpp."), "src/edgewise/table/ring.hpp:1: there is no rings.hpp\n");
    EXPECT_NE(verdict(slashes + "(rings/ring.hpp)"), "");
    EXPECT_EQ(verdict(slashes + "(ring.hpp), table/ring.hpp and edgewise/src/edgewise/table/ring.hpp"), "");
    EXPECT_EQ(verdict(slashes + "edgewise/table/ring.hpp, and type.hpp, which is generated"), "");
    EXPECT_EQ(verdict(slashes + "the file NAME.hpp, ../ring.hpp"), "");
    EXPECT_EQ(verdict("#include \"rings.hpp\""), "");
}

TEST(LongReadme, IsCountedInLinesAndWords) {
    const auto verdict = [](std::size_t lines, const std::string& line) {
        std::string text;
        for (std::size_t i = 0; i < lines; ++i) text += line + "\n";
        return long_readme({source_file("README.md", text), source_file("docs/README.md", text + text)})
            .size();
    };
    EXPECT_EQ(verdict(readme_lines, "a b c d e f g"), 0u);
    EXPECT_EQ(verdict(readme_lines + 1, ""), 1u);
    EXPECT_EQ(verdict(100, "a b c d e f g h i j"), 1u);
}

TEST(LongClasses, AreCountedToTheLine) {
    const auto class_of = [](const std::string& opening, std::size_t lines) {
        std::string text = opening + " {\n";
        for (std::size_t i = 2; i < lines; ++i) text += i % 2 ? "    void f() { g(); }\n" : "    int a_{};\n";
        return source_file("src/edgewise/x.hpp", "namespace a {\n" + text + "};\n}\n");
    };
    EXPECT_TRUE(long_classes({class_of("class A final : B<C>", longest_class)}).empty());
    EXPECT_EQ(to_text(long_classes({class_of("class A final : B<C>", longest_class + 1)})),
              "src/edgewise/x.hpp:2: a class of 151 lines\n");
    EXPECT_EQ(long_classes({class_of("template <class T>\nstruct A", longest_class)}).size(), 1u);
    EXPECT_TRUE(long_classes({class_of("namespace b", 2 * longest_class)}).empty());
    EXPECT_TRUE(long_classes({class_of("enum class A", 2 * longest_class)}).empty());
}

}  // namespace
}  // namespace edgewise::house
