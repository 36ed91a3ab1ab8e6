// SPDX-License-Identifier: MIT
//
// Chart specifications as files: what names stand for, that data is never read as a name, and that every file
// of the report is whole.
#include "edgewise/reports/charts/spec_file.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "edgewise/reports/text/report_text.hpp"

namespace edgewise::reports {
namespace {

ChartJson filled(const char* spec, const char* slots = "{}") {
    ChartJson file =
        ChartJson::parse(R"({"parts": {"axis": {"field": "ns", "title": "$title"}, "title": "time"}})");
    file["spec"] = ChartJson::parse(spec);
    return fill_spec(file, ChartJson::parse(slots));
}

TEST(SpecFile, NamesStandForPartsSlotsAndWhatIsAroundThem) {
    EXPECT_EQ(filled(R"({"y": "$axis"})"), ChartJson::parse(R"({"y": {"field": "ns", "title": "time"}})"));
    EXPECT_EQ(filled(R"(["$title"])", R"({"title": "slot"})"), ChartJson::parse(R"(["slot"])"));
    EXPECT_EQ(filled(R"({"$let": {"title": "inner"}, "$with": "$axis", "field": "low"})"),
              ChartJson::parse(R"({"field": "low", "title": "inner"})"));
    EXPECT_EQ(filled(R"([0, "$*rows", 3])", R"({"rows": [1, 2]})"), ChartJson::parse("[0, 1, 2, 3]"));
    EXPECT_EQ(filled(R"([{"$each": "$panels", "at": "$x"}])", R"({"panels": [{"x": 1}, {"x": 2}]})"),
              ChartJson::parse(R"([{"at": 1}, {"at": 2}])"));
    EXPECT_EQ(filled(R"({"a": null, "b": "$absent"})"), ChartJson::parse(R"({"a": null})"));
}

TEST(SpecFile, DataIsNeverReadAsANameAndAnUnknownNameIsAnError) {
    const char* rows = R"({"values": ["$title", {"$with": "$axis"}, "$nothing"]})";
    EXPECT_EQ(filled(R"("$values")", rows), ChartJson::parse(rows)["values"]);
    EXPECT_THROW((void)filled(R"("$nothing")"), std::out_of_range);
}

TEST(ReportTexts, AreAllThereAndWhole) {
    std::size_t charts = 0;
    for (const EmbeddedText& text : embedded_texts()) {
        EXPECT_EQ(report_text(text.name), text.text) << text.name;
        EXPECT_TRUE(!text.name.ends_with(".json") || ChartJson::accept(text.text)) << text.name;
        EXPECT_FALSE(text.name.ends_with(".md") && prose(text.name).empty()) << text.name;
        charts += text.name.ends_with(".vl.json");
    }
    EXPECT_GE(charts, 15U);
}

}  // namespace
}  // namespace edgewise::reports
