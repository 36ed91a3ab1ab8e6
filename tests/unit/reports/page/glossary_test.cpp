// SPDX-License-Identifier: MIT
//
// The glossary: each word once, each used by the report, links where it is used, and layouts in the words of
// the store.
#include "edgewise/reports/page/chapters/chapters.hpp"

#include <gmock/gmock.h>

#include "edgewise/reports/text/report_text.hpp"
#include "edgewise/store/schema.hpp"

namespace edgewise::reports {
namespace {

using testing::HasSubstr;
using testing::Not;

ReportData glossary_data() {
    ReportData data;
    ReportCell cell;
    cell.layout = "lean", cell.table = "lean_f32";
    data.cells = {cell};
    data.meta = {{std::string(store::layout_key) + "lean", "coordinates & rings; every plane"},
                 {std::string(store::layout_key) + "soa", "no cell is of it"}};
    return data;
}

std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

/// Returns all prose of the report and all text of its charts, in lower case.
std::string all_prose() {
    std::string text;
    for (const EmbeddedText& one : embedded_texts())
        if (one.name != "glossary.md" && (one.name.ends_with(".md") || one.name.ends_with(".vl.json")))
            text += lower(prose(one.name));
    return text;
}

TEST(Glossary, EveryWordIsExplainedOnceAndUsed) {
    const std::string text = all_prose();
    std::set<std::string> forms, ids;
    const std::vector<Term> words = glossary_words();
    ASSERT_GE(words.size(), 20U);
    for (const Term& term : words) {
        EXPECT_TRUE(ids.insert(term.id()).second) << term.name;
        EXPECT_GE(term.meaning.size(), 20U) << term.name;
        EXPECT_TRUE(term.meaning.ends_with('.')) << term.name;
        std::vector<std::string> of_term = term.also;
        of_term.push_back(term.name);
        bool used = false;
        for (const std::string& form : of_term) {
            EXPECT_TRUE(forms.insert(lower(form)).second) << form << " belongs to two terms";
            used = used || text.find(lower(form)) != text.npos;
        }
        EXPECT_TRUE(used) << "no text of the report says " << term.name;
    }
}

TEST(Glossary, LinksTheFirstUseOfEachTermAsAWholeWord) {
    const Glossary glossary(glossary_data());
    std::set<std::string> linked;
    const std::string html =
        glossary.html("Table types: a cell of a <cellar>; another cell. Knees & `edgewise sweep`.", linked);
    EXPECT_THAT(html, HasSubstr(">Table types</a>: a <a class=\"term\" href=\"#word-cell\""));
    EXPECT_THAT(html, HasSubstr(">cell</a> of a &lt;cellar&gt;; another cell."));
    EXPECT_THAT(html, HasSubstr(">Knees</a> &amp; <code>edgewise sweep</code>."));
    EXPECT_EQ(linked, (std::set<std::string>{"word-table-type", "word-cell", "word-knee"}));
    EXPECT_EQ(glossary.html("cells", linked), "cells") << "linked already";
}

TEST(Glossary, LayoutsAreInTheWordsOfTheStore) {
    const Glossary glossary(glossary_data());
    std::set<std::string> linked;
    EXPECT_THAT(glossary.html("V-Clip on lean_f32", linked), HasSubstr("href=\"#layout-lean\""));
    linked.clear();
    EXPECT_THAT(glossary.html("`lean`", linked), HasSubstr("<code><a class=\"term\" href=\"#layout-lean\""));
    linked.clear();
    EXPECT_EQ(glossary.html("a lean design on soa_f64", linked), "a lean design on soa_f64")
        << "a plain word, and a layout that no cell is of";
    const std::string list = glossary.list_html();
    EXPECT_THAT(list, HasSubstr("<dt id=\"layout-lean\">"));
    EXPECT_THAT(list, HasSubstr("<dd>coordinates &amp; rings; every plane</dd>"));
    EXPECT_THAT(list, Not(HasSubstr("layout-soa")));
    EXPECT_THAT(Glossary(ReportData{}).list_html(), Not(HasSubstr("<h3>Layouts")));
}

}  // namespace
}  // namespace edgewise::reports
