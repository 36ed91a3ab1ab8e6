// SPDX-License-Identifier: MIT
#include "edgewise/reports/page/chapters/chapters.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "edgewise/input/known_names.hpp"
#include "edgewise/reports/page/html.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/text/report_text.hpp"
#include "edgewise/store/palette.hpp"
#include "edgewise/store/schema.hpp"

namespace edgewise::reports {

namespace {

bool is_word_character(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \n"), last = text.find_last_not_of(" \n");
    return first == text.npos ? std::string() : text.substr(first, last - first + 1);
}

std::vector<std::string> parts_of(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream rest(text);
    for (std::string part; std::getline(rest, part, separator);)
        if (!trimmed(part).empty()) parts.push_back(trimmed(part));
    return parts;
}

/// The layouts of the data, described as the store describes them.
std::vector<Term> layout_terms(const ReportData& data) {
    std::set<std::string> used;
    for (const ReportCell* cell : data.swept()) used.insert(cell->layout);
    std::vector<Term> terms;
    for (const std::string& layout : used)
        if (auto line = data.meta_value(store::layout_key + layout)) {
            const std::size_t end = std::min(line->find("; "), line->size());
            terms.push_back({layout, {}, "stores " + line->replace(end, 2, "; derives "), true});
        }
    return terms;
}

std::string definition_html(const Term& term) {
    const std::string colour = term.is_layout
                                   ? fmt::format("<span class=\"swatch\" style=\"background:{}\"></span>",
                                                 store::layout_colour(term.name))
                                   : std::string();
    return fmt::format("<dt id=\"{}\">{}<dfn>{}</dfn></dt><dd>{}</dd>\n", term.id(), colour,
                       html_text(term.name), html_text(term.meaning));
}

}  // namespace

std::string Term::id() const {
    std::string id = is_layout ? "layout-" : "word-";
    for (const char c : name) id += is_word_character(c) ? c : '-';
    return id;
}

std::vector<Term> glossary_words() {
    std::vector<Term> terms;
    std::istringstream lines{std::string(report_text("glossary.md"))};
    for (std::string line; std::getline(lines, line);) {
        const std::size_t first = line.find('|'), second = line.find('|', first + 1);
        terms.push_back({trimmed(line.substr(0, first)),
                         parts_of(line.substr(first + 1, second - first - 1), ','),
                         trimmed(line.substr(second + 1))});
    }
    return terms;
}

Glossary::Glossary(const ReportData& data) : terms_(glossary_words()) {
    for (Term& layout : layout_terms(data)) terms_.push_back(std::move(layout));
    for (std::size_t i = 0; i < terms_.size(); ++i) {
        std::vector<Form>& forms = terms_[i].is_layout ? layouts_ : words_;
        forms.push_back({lower_case(terms_[i].name), i});
        for (const std::string& form : terms_[i].also) forms.push_back({lower_case(form), i});
    }
    std::ranges::stable_sort(words_,
                             [](const Form& a, const Form& b) { return a.text.size() > b.text.size(); });
}

const Glossary::Form* Glossary::word_at(const std::string& lower, std::size_t at) const {
    if (at > 0 && is_word_character(lower[at - 1])) return nullptr;
    const auto found = std::ranges::find_if(words_, [&](const Form& form) {
        const std::size_t end = at + form.text.size();
        return lower.compare(at, form.text.size(), form.text) == 0 &&
               (end == lower.size() || !is_word_character(lower[end]));
    });
    return found == words_.end() ? nullptr : &*found;
}

const Glossary::Form* Glossary::layout_in(const std::string& word) const {
    std::string name = word;
    for (const char* precision : {"_f64", "_f32", "_mixed"})
        if (name.ends_with(precision)) name.resize(name.size() - std::string(precision).size());
    const auto found = std::ranges::find(layouts_, name, &Form::text);
    return found == layouts_.end() ? nullptr : &*found;
}

std::string Glossary::html(const std::string& text, std::set<std::string>& linked) const {
    const std::string lower = lower_case(text);
    const auto once = [&](const Form* form, const std::string& shown) {
        if (!form || !linked.insert(terms_[form->term].id()).second) return html_text(shown);
        return fmt::format("<a class=\"term\" href=\"#{}\" title=\"{}\">{}</a>", terms_[form->term].id(),
                           html_text(terms_[form->term].meaning), html_text(shown));
    };
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t closing = text[at] == '`' ? text.find('`', at + 1) : text.npos;
        if (closing != text.npos) {
            const std::string code = text.substr(at + 1, closing - at - 1);
            out += "<code>" + once(layout_in(code), code) + "</code>";
            at = closing + 1;
            continue;
        }
        std::size_t end = at;
        while (end < text.size() && is_word_character(text[end])) ++end;
        if (const Form* word = word_at(lower, at)) {
            out += once(word, text.substr(at, word->text.size()));
            at += word->text.size();
            continue;
        }
        const std::string word = text.substr(at, std::max<std::size_t>(end - at, 1));
        out += once(word.find('_') == word.npos ? nullptr : layout_in(word), word);
        at += word.size();
    }
    return out;
}

std::string Glossary::list_html() const {
    std::string words, layouts;
    for (const Term& term : terms_) (term.is_layout ? layouts : words) += definition_html(term);
    std::string html = "<dl class=\"glossary\">\n" + words + "</dl>\n";
    if (layouts.empty()) return html + html_paragraph(prose("no_layouts.md"), "note");
    return html + "<h3>Layouts</h3>\n<dl class=\"glossary\">\n" + layouts + "</dl>\n";
}

}  // namespace edgewise::reports
