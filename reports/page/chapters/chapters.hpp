// SPDX-License-Identifier: MIT
//
// The report's chapters: one question each, in its reader's words, with one sentence that answers it from the
// store. This folder decides the content and order of each.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "edgewise/reports/answer/answer.hpp"
#include "edgewise/reports/body/body_heat.hpp"
#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/compare/comparison.hpp"
#include "edgewise/reports/reader.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

/// A part of a chapter after its paragraph, in the order of the members.
struct ChapterBlock {
    std::string title = {}, paragraph = {};
    std::string section = {};          ///< not empty: the charts of this section
    std::string elements = {};         ///< of the page, before the grids
    std::vector<TextGrid> grids = {};  ///< long ones show their first rows, and all on demand
    std::string fold = {};             ///< not empty: made when this line is opened
};

/// A fold with one long table.
[[nodiscard]] ChapterBlock folded(TextGrid grid, const std::string& what);

struct Chapter {
    std::string id, title;
    std::string paragraph = {};  ///< how to read what follows
    std::vector<ChapterBlock> blocks = {};
    std::string link = {};      ///< its name where the page lists all chapters; the title where empty
    std::string sentence = {};  ///< answer to its question from the store, with figures; shown first
};

[[nodiscard]] std::vector<Chapter> report_chapters(const Answer& answer, const ReportData& data,
                                                   const std::vector<Chart>& charts);

/// Chapters of the studies without one of their own, by name: one grid each, as the store describes it.
[[nodiscard]] std::vector<Chapter> study_chapters(const ReportData& data);

[[nodiscard]] Chapter break_even_chapter(const Answer& answer, const ReportData& data);

/// Returns the cells of one body and of one kind of tables; all bodies if `shape` is empty, both kinds if
/// `own_tables` is null.
inline constexpr std::pair<const char*, std::optional<bool>> offered_tables[] = {
    {"both", std::nullopt}, {"own", true}, {"shared", false}};
[[nodiscard]] ReportData part_of(const ReportData& data, const std::string& shape,
                                 std::optional<bool> own_tables);

/// Returns the maps for the bodies, limits and tables that the bar offers, as JSON: {"SHAPE LIMIT TABLES":
/// html}, with names as in answers_data.
[[nodiscard]] std::string break_even_data(const ReportData& data);

/// Returns what chapters state of one body, of one kind of tables, or of both, as JSON: {"SHAPE TABLES": {id
/// of the chapter: text}}. If nothing was measured, the text says so and has the command that measures it.
[[nodiscard]] std::string statements_data(const ReportData& data);

/// `other`: what the other store is called.
[[nodiscard]] Chapter compare_chapter(const StoreComparison& comparison, double slack,
                                      const std::string& other);

/// Number of checked answers, wrong verdicts, and the worst error of each precision.
[[nodiscard]] std::string errors_sentence(const ReportData& data);
/// Instructions per query of the baseline; or why they were not counted.
[[nodiscard]] std::string counters_sentence(const ReportData& data);
/// How much of the largest table is what, and what the smallest takes.
[[nodiscard]] std::string bytes_sentence(const ReportData& data);
/// Lines of a query and the cache below which a scene thrashes: of the baseline and of the fewest.
[[nodiscard]] std::string misses_sentence(const ReportData& data);
/// What V-Clip's table costs to build and to refit: of the baseline and of the fewest lines per query.
[[nodiscard]] std::string layouts_sentence(const ReportData& data);
/// How time grows from the smallest to the largest built-in body.
[[nodiscard]] std::string times_sentence(const Answer& answer, const ReportData& data);
/// How many cells are on a front of time and error.
[[nodiscard]] std::string fronts_sentence(const ReportData& data);
/// Cases, wrong verdicts outside the band, differing ones inside.
[[nodiscard]] std::string stability_sentence(const ReportData& data);
/// Compares the fastest other library with the fastest cell of ours.
[[nodiscard]] std::string peers_sentence(const Answer& answer);
/// How often the replacement policy changes a ranking by misses.
[[nodiscard]] std::string policy_sentence(const ReportData& data);

// The chapter on which fields of a record travel together.

/// Nothing where the fields run was not made.
[[nodiscard]] std::optional<Chapter> fields_chapter(const ReportData& data);

// The words of the report, each explained once and linked from where it is used. Words are those of
// glossary.md; layouts are described by their own line, which the sweep keeps in the store.

struct Term {
    std::string name;
    std::vector<std::string> also;  ///< other forms of the word
    std::string meaning;
    bool is_layout = false;

    /// Returns the id of its element: "word-table-type", "layout-lean".
    [[nodiscard]] std::string id() const;
};

/// The words of glossary.md, in its order.
[[nodiscard]] std::vector<Term> glossary_words();

class Glossary {
  public:
    /// The words, then the layouts of this data.
    explicit Glossary(const ReportData& data);

    [[nodiscard]] const std::vector<Term>& terms() const { return terms_; }

    /// Returns a text as HTML: text between backticks is code, and the first use of each term is a link. A
    /// layout is known with a precision (lean_f32) or between backticks. `linked`: ids of terms that are
    /// linked already; those of this text are added.
    [[nodiscard]] std::string html(const std::string& text, std::set<std::string>& linked) const;

    /// All of them, as lists of definitions.
    [[nodiscard]] std::string list_html() const;

  private:
    struct Form {
        std::string text;  ///< in lower case
        std::size_t term;
    };

    /// The longest form that begins here and ends with a word; null where there is none.
    [[nodiscard]] const Form* word_at(const std::string& lower, std::size_t at) const;
    [[nodiscard]] const Form* layout_in(const std::string& word) const;

    std::vector<Term> terms_;
    std::vector<Form> words_, layouts_;  ///< words: the longest first
};

}  // namespace edgewise::reports
