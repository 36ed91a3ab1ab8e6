// SPDX-License-Identifier: MIT
#include "edgewise/measure/record/comparison.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "edgewise/input/json_text.hpp"

namespace edgewise::measure {

namespace {

constexpr const char* outcome_names[] = {"over", "worse",  "changed", "missing",
                                         "new",  "better", "within",  "equal"};
constexpr std::size_t most_lines = 20;  ///< of one outcome that does not fail; the rest is counted

const char* name_of(Outcome outcome) { return outcome_names[static_cast<std::size_t>(outcome)]; }

Outcome outcome_of(const RecordRow& was, const RecordRow& is, const FigureRecord& old) {
    if (was.text != is.text) return Outcome::changed;
    const auto soft = old.bound_of(was.figure, &Limit::soft), hard = old.bound_of(was.figure, &Limit::hard);
    if (hard && (is.has_interval ? is.low : is.value) > *hard) return Outcome::over;
    const bool may_grow = hard && !soft;
    if (!soft && !hard && !old.slack) return was.value == is.value ? Outcome::equal : Outcome::changed;
    if (was.has_interval || is.has_interval) {
        const double limit = 1 + soft.value_or(old.slack.value_or(0));
        if (is.low > was.high * limit) return may_grow ? Outcome::within : Outcome::worse;
        return is.high < was.low / limit ? Outcome::better : Outcome::within;
    }
    if (is.value == was.value) return Outcome::equal;
    if (is.value < was.value) return Outcome::better;
    return may_grow || is.value <= was.value * (1 + soft.value_or(0)) ? Outcome::within : Outcome::worse;
}

/// Rows of one record, by cell and figure. Conditions of what was measured are rows of words.
class RowsByName {
  public:
    explicit RowsByName(const FigureRecord& record) {
        for (const auto& [name, value] : record.of)
            rows_.push_back({.figure = "of." + name, .text = value.empty() ? "''" : value});
        rows_.insert(rows_.end(), record.rows.begin(), record.rows.end());
        for (const RecordRow& row : rows_) by_name_[row.cell][row.figure] = &row;
    }

    [[nodiscard]] const std::vector<RecordRow>& rows() const { return rows_; }
    [[nodiscard]] bool has_cell(const std::string& cell) const { return by_name_.contains(cell); }
    [[nodiscard]] const RecordRow* find(const RecordRow& row) const {
        const auto cell = by_name_.find(row.cell);
        if (cell == by_name_.end()) return nullptr;
        const auto figure = cell->second.find(row.figure);
        return figure == cell->second.end() ? nullptr : figure->second;
    }

  private:
    std::vector<RecordRow> rows_;
    std::map<std::string, std::map<std::string, const RecordRow*>> by_name_;
};

/// Rows of `from` that `other` lacks; a cell that is not there at all is one row without figure.
void add_lone_rows(const RowsByName& from, const RowsByName& other, Outcome outcome, RecordComparison& into) {
    std::set<std::string> cells;
    for (const RecordRow& row : from.rows()) {
        if (other.find(row)) continue;
        ComparedRow lone{row, row, outcome};
        if (!row.cell.empty() && !other.has_cell(row.cell)) {
            if (!cells.insert(row.cell).second) continue;
            lone.was.figure = lone.is.figure = "";
        }
        into.rows.push_back(std::move(lone));
    }
}

std::string value_text(const RecordRow& row) {
    if (!row.text.empty()) return row.text;
    return row.has_interval ? fmt::format("{:.4g} [{:.4g}, {:.4g}]", row.value, row.low, row.high)
                            : fmt::format("{}", row.value);
}

std::string rows_text(const RecordComparison& comparison) {
    std::string text;
    std::map<Outcome, std::size_t> shown;
    for (const ComparedRow& row : comparison.rows) {
        if (row.outcome >= Outcome::within) break;
        if (comparison.fails(row) || shown[row.outcome]++ < most_lines) text += to_text(row);
    }
    for (const auto& [outcome, count] : shown)
        if (count > most_lines)
            text += fmt::format("and {} more {} (--json)\n", count - most_lines, name_of(outcome));
    return text;
}

std::string conditions_text(const RecordComparison& comparison) {
    std::string text;
    std::vector<std::string> same;
    for (const ComparedCondition& condition : comparison.conditions) {
        if (condition.same())
            same.push_back(condition.what);
        else
            text += fmt::format("possible cause: {}: was {}, is {}\n", condition.what, condition.was,
                                condition.is);
    }
    return same.empty()
               ? text
               : text + fmt::format("excluded as causes, being the same: {}\n", fmt::join(same, ", "));
}

nlohmann::ordered_json value_json(const RecordRow& row) {
    if (!row.text.empty()) return row.text;
    if (row.has_interval) return {row.low, row.value, row.high};
    return row.value;
}

nlohmann::ordered_json row_json(const ComparedRow& row) {
    nlohmann::ordered_json json = {{"outcome", name_of(row.outcome)},
                                   {"cell", row.is.cell},
                                   {"figure", row.is.figure},
                                   {"was", nullptr},
                                   {"is", nullptr}};
    if (row.outcome != Outcome::added) json["was"] = value_json(row.was);
    if (row.outcome != Outcome::missing) json["is"] = value_json(row.is);
    if (!row.note.empty()) json["note"] = row.note;
    return json;
}

std::vector<ComparedCondition> compare_conditions(const Conditions& was, const Conditions& is) {
    std::vector<ComparedCondition> all;
    for (const auto& [name, value] : was) all.push_back({name, value, "?"});
    for (const auto& [name, value] : is) {
        const auto found = std::ranges::find(all, name, &ComparedCondition::what);
        if (found == all.end())
            all.push_back({name, "?", value});
        else
            found->is = value;
    }
    return all;
}

}  // namespace

std::size_t RecordComparison::count(Outcome outcome) const {
    return static_cast<std::size_t>(std::ranges::count(rows, outcome, &ComparedRow::outcome));
}

std::size_t RecordComparison::compared() const {
    return rows.size() - count(Outcome::missing) - count(Outcome::added);
}

bool RecordComparison::fails(const ComparedRow& row) const {
    return row.outcome <= Outcome::changed || (must_stay && row.outcome <= Outcome::added);
}

bool RecordComparison::passed() const {
    return faults.empty() && compared() > 0 &&
           std::ranges::none_of(rows, [&](const ComparedRow& row) { return fails(row); });
}

int RecordComparison::exit_code() const {
    if (count(Outcome::over) > 0) return 3;
    return passed() ? 0 : 1;
}

RecordComparison compare(const FigureRecord& was, const FigureRecord& is) {
    RecordComparison found{!was.slack, {}, compare_conditions(was.with, is.with)};
    const RowsByName before(was), after(is);
    for (const RecordRow& row : before.rows()) {
        const RecordRow* now = after.find(row);
        if (!now) continue;
        found.rows.push_back({row, *now, outcome_of(row, *now, was)});
        if (found.rows.back().outcome == Outcome::over)
            found.rows.back().note = fmt::format("hard limit {}", *was.bound_of(row.figure, &Limit::hard));
        if (!row.note.empty() || !now->note.empty())
            found.rows.back().note = fmt::format("was {}; is {}", row.note, now->note);
    }
    add_lone_rows(before, after, Outcome::missing, found);
    add_lone_rows(after, before, Outcome::added, found);
    std::ranges::stable_sort(found.rows, [&](const ComparedRow& a, const ComparedRow& b) {
        const auto weight = [&](const ComparedRow& row) { return was.slack ? -row.least_change() : 0; };
        return std::tuple(a.outcome, weight(a)) < std::tuple(b.outcome, weight(b));
    });
    return found;
}

std::string to_text(const ComparedRow& row) {
    std::string line = fmt::format("{}: {}{}{}", name_of(row.outcome), row.is.cell,
                                   row.is.cell.empty() || row.is.figure.empty() ? "" : ": ", row.is.figure);
    const bool is_cell = row.is.figure.empty();
    if (!is_cell)
        line +=
            fmt::format(": was {}, is {}", row.outcome == Outcome::added ? "nothing" : value_text(row.was),
                        row.outcome == Outcome::missing ? "nothing" : value_text(row.is));
    const bool in_both = row.outcome != Outcome::missing && row.outcome != Outcome::added;
    if (in_both && row.is.has_interval && row.was.has_interval)
        line +=
            fmt::format(", x {:.3f} [{:.3f}, {:.3f}]", row.change(), row.least_change(), row.most_change());
    return line + "\n" + (row.note.empty() ? "" : "    " + row.note + "\n");
}

std::string to_text(const RecordComparison& comparison, const std::string& old_name) {
    std::string text = rows_text(comparison) + conditions_text(comparison), counts;
    for (const std::string& fault : comparison.faults) text += "failed: " + fault + "\n";
    for (std::size_t i = 0; i < std::size(outcome_names); ++i)
        if (const std::size_t count = comparison.count(static_cast<Outcome>(i)); count > 0)
            counts += fmt::format("{}{} {}", counts.empty() ? ": " : ", ", count, outcome_names[i]);
    const char* verdict = comparison.passed()          ? "passed"
                          : comparison.compared() == 0 ? "failed, nothing in common"
                                                       : "failed";
    return text +
           fmt::format("{}: {}; {} rows compared{}\n", old_name, verdict, comparison.compared(), counts);
}

std::string to_json(const RecordComparison& comparison) {
    nlohmann::ordered_json json = {{"passed", comparison.passed()}, {"compared", comparison.compared()}};
    for (std::size_t i = 0; i < std::size(outcome_names); ++i)
        json[outcome_names[i]] = comparison.count(static_cast<Outcome>(i));
    json["rows"] = json["conditions"] = nlohmann::ordered_json::array();
    for (const ComparedRow& row : comparison.rows)
        if (row.outcome != Outcome::equal) json["rows"].push_back(row_json(row));
    for (const ComparedCondition& condition : comparison.conditions)
        json["conditions"].push_back(
            {{"what", condition.what}, {"was", condition.was}, {"is", condition.is}});
    json["faults"] = comparison.faults;
    return input::json_text(json) + "\n";
}

}  // namespace edgewise::measure
