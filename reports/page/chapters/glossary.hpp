// SPDX-License-Identifier: MIT
//
// The words of the report, each explained once and linked from where it is used. Words are those of
// glossary.md; layouts are described by their own line, which the sweep keeps in the store.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

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
    [[nodiscard]] std::string link(const Term& term, const std::string& text) const;

    std::vector<Term> terms_;
    std::vector<Form> words_, layouts_;  ///< words: the longest first
};

}  // namespace edgewise::reports
