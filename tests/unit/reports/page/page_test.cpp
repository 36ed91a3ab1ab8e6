// SPDX-License-Identifier: MIT
//
// The glossary: each word once, each used by the report, links where it is used, and layouts in the words of
// the store.
#include "edgewise/reports/page/chapters/chapters.hpp"

#include <gmock/gmock.h>
#include <zlib.h>

#include "edgewise/reports/page/html.hpp"
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
    EXPECT_THAT(list, HasSubstr("<dd>stores coordinates &amp; rings; derives every plane</dd>"));
    EXPECT_THAT(list, Not(HasSubstr("layout-soa")));
    EXPECT_THAT(Glossary(ReportData{}).list_html(), Not(HasSubstr("<h3>Layouts")));
}

// Packed data of the page unpack to the original text, by zlib and by hand.

std::string gunzipped(std::string packed, std::size_t size) {
    std::string text(size, '\0');
    z_stream stream{};
    EXPECT_EQ(inflateInit2(&stream, 15 + 16), Z_OK);
    stream.next_in = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = reinterpret_cast<Bytef*>(text.data());
    stream.avail_out = static_cast<uInt>(text.size());
    EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
    EXPECT_EQ(stream.total_out, size);
    inflateEnd(&stream);
    return text;
}

TEST(Packing, GzipUnpacksToTheSameTextAndIsTheSameBytes) {
    std::string text;
    for (int i = 0; i < 5000; ++i) text += "row " + std::to_string(i % 77) + "\n";
    const std::string packed = gzipped(text);
    EXPECT_LT(packed.size(), text.size() / 20);
    EXPECT_EQ(gunzipped(packed, text.size()), text);
    EXPECT_EQ(gzipped(text), packed);
    EXPECT_EQ(gunzipped(gzipped(""), 0), "");
}

/// The examples of RFC 4648, section 10.
TEST(Packing, Base64) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xff\xfe"), "//4=");
}

/// The digest of the empty text.
TEST(Packing, ScriptsAreKnownByTheirHash) {
    EXPECT_EQ(script_hash("e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"),
              "sha256-47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU=");
}

TEST(SafeSvg, SlimPicturesHaveOneLabelAndShortNumbers) {
    EXPECT_EQ(slim_svg(R"(<svg width="1"><path aria-label="a: 1.25" role="x" d="M1.2345,10.06L3,4"/></svg>)",
                       "A & B"),
              R"(<svg role="img" aria-label="A &amp; B" width="1"><path d="M1.2,10.0L3,4"/></svg>)");
    const std::string text = R"(<text>0.25, an aria-label of a class="b</text></svg>)";
    EXPECT_EQ(slim_svg("<svg x=\"1.25\">" + text, "A"),
              "<svg role=\"img\" aria-label=\"A\" x=\"1.2\">" + text)
        << "text is no coordinate and no attribute";
}

/// A wall at rest is like bodies at rest, not like a scene as slow without overlapping pairs, or one that
/// lacks figures or has tables of another kind.
TEST(StudyChapters, NameTheInventedSceneThatMovesMostLikeARecordedOne) {
    ReportData data;
    const auto add = [&](const char* scene, const char* parameters, double turn,
                         std::optional<double> overlapping) {
        ReportCell row;
        row.run = "coherence", row.scene = scene, row.shape = "box8";
        row.scene_parameters = parameters;
        for (const char* name : {"turn_median", "turn_p90", "way_median"})
            row.figures.push_back({{name, turn, "rad", "", ""}, "coherence"});
        for (const char* name : {"overlapping", "near", "very_near"})
            row.figures.push_back({{name, overlapping, "1", "", ""}, "coherence"});
        data.other_studies.push_back(row);
    };
    add("wall", R"({"recording":7.0})", 1e-5, 0.3);
    add("resting", "{}", 2e-5, 0.25);
    add("proximity", "{}", 1e-5, 0.0);
    add("tumble", "{}", 0.01, 0.3);
    add("cold", "{}", 1e-5, std::nullopt);
    add("pressure", R"({"own_tables":1.0})", 1e-5, 0.3);
    const std::vector<Chapter> chapters = study_chapters(data);
    ASSERT_EQ(chapters.size(), 1U);
    EXPECT_EQ(chapters[0].sentence, "wall moves most like resting.");
}

}  // namespace
}  // namespace edgewise::reports
