// SPDX-License-Identifier: MIT
//
// One ranker: from one store the first screen, the map, report.md, the terminal and `advise --store` name the
// same winner, ties and intervals, for every scene, body and error limit. Each output is parsed; the oracle
// looks at the stored cells alone.
#include <fmt/core.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <regex>

#include "answer_cells.hpp"
#include "edgewise/reports/answer/answer_text.hpp"
#include "edgewise/reports/answer/decision.hpp"
#include "edgewise/reports/page/chapters/chapters.hpp"
#include "edgewise/reports/page/page.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/store/store.hpp"

namespace edgewise::reports {
namespace {

/// By scene label; "" where nothing is known to be within the error, else each cell with its interval, the
/// winner first: "V-Clip on aos_f64 1.00 [0.98, 1.02]; ...".
using TieSets = std::map<std::string, std::string>;

const std::string question_scenes[] = {R"({"bodies":100,"rotation_step":0.001})",
                                       R"({"bodies":100,"rotation_step":0.1})",
                                       R"({"bodies":50,"own_tables":1,"rotation_step":0.01})",
                                       R"({"bodies":600,"own_tables":1,"rotation_step":0.1})"};

/// Parameters of a synthetic store: the factor from cell to cell in time, the spread of rounds, the own
/// variation of the baseline, the errors of cells, and the fractions of cells that are missing or failed.
struct StoreKind {
    double step, spread, own_variation;
    std::vector<double> errors;
    double missing, failed;
};
const StoreKind clear_winners{1.3, 0.002, 0.004, {1e-15}, 0, 0},
    many_ties{1.015, 0.03, 0.2, {1e-15, 1e-9}, 0, 0},
    errors_and_gaps{1.05, 0.02, 0.2, {1e-15, 1e-9, 1e-7, 1e-5, 1e-3}, 0.3, 0.1};

ReportCell made_cell(const StoreKind& kind, double ratio, const TimedCell& names, const std::string& scene,
                     const std::string& shape, std::mt19937& random) {
    std::uniform_real_distribution<double> spread(0, kind.spread), part(0, 1);
    TimedCell made = names;
    for (const double from : {-1.0, -0.5, 0.0, 0.5, 1.0})
        made.ratios.push_back(ratio * (1 + from * spread(random)));
    std::ranges::sort(made.ratios);
    made.error = kind.errors[random() % kind.errors.size()];
    if (part(random) < kind.failed) made.status = store::CellStatus::failed;
    return answer_cell(made, scene, shape);
}

/// Two bodies in four scenes; both algorithms on three layouts in two precisions.
ReportData made_store(const StoreKind& kind, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> part(0, 1);
    ReportData data;
    for (const std::string& scene : question_scenes) {
        for (const char* shape : {"cube8", "sphere386"}) {
            std::vector<double> ratios;
            for (int i = 0; i < 12; ++i) ratios.push_back(0.4 * std::pow(kind.step, i));
            std::ranges::shuffle(ratios, random);
            for (const char* algorithm : {"vclip", "gjk"}) {
                for (const char* layout : {"aos", "lean", "quantised"}) {
                    for (const char* precision : {"f64", "f32"}) {
                        double ratio = ratios.back();
                        ratios.pop_back();
                        if (std::string(algorithm) + layout + precision == "vclipaosf64")
                            ratio = 1 + kind.own_variation * (2 * part(random) - 1);
                        if (part(random) < kind.missing) continue;
                        data.cells.push_back(
                            made_cell(kind, ratio, {algorithm, layout, precision, {}}, scene, shape, random));
                    }
                }
            }
        }
    }
    return data;
}

/// Written to a file and read again.
ReportData stored(const ReportData& made) {
    const std::string path =
        (std::filesystem::temp_directory_path() / fmt::format("one_ranker_{}.db", getpid())).string();
    std::filesystem::remove(path);
    {
        store::Store store(path);
        store.put_build({"b", "abc", "g++", "-O3", "Release", R"({"cpu":"Test CPU"})"});
        store.set_meta("build", "b");
        for (const ReportCell& cell : made.cells) {
            ReportCell row = cell;
            row.table = cell.layout + "_" + cell.precision;
            store.put_cell("b", row, row.figures);
            std::vector<std::pair<std::string, measure::Round>> rounds;
            for (const measure::Round& round : cell.rounds) rounds.emplace_back(cell.hash, round);
            store.put_round("b", rounds);
        }
    }
    ReportData data = read_report(path);
    std::filesystem::remove(path);
    return data;
}

struct Expected {
    std::string name;
    double ratio, low, high;
};

/// By the rule as ranking.hpp has it, from stored figures and rounds.
std::string expected_of(const std::vector<const ReportCell*>& cells, double limit) {
    std::vector<Expected> within;
    double factor = 1;
    for (const ReportCell* cell : cells) {
        if (!cell->is_timed()) continue;
        std::vector<double> ratios;
        for (const measure::Round& round : cell->rounds)
            ratios.push_back(round.timing.separated().value() / round.baseline.separated().value());
        std::ranges::sort(ratios);
        const double ratio = cell->figure(store::all_time.ratio).value.value();
        if (cell->algorithm == "vclip" && cell->table == "aos_f64") factor = std::max(ratio, 1 / ratio);
        if (cell->figure("error.worst_error_given").value.value() > limit) continue;
        within.push_back({(cell->algorithm == "vclip" ? "V-Clip on " : "GJK on ") + cell->table, ratio,
                          ratios.front(), ratios.back()});
    }
    std::ranges::stable_sort(within, {}, &Expected::ratio);
    std::string ties;
    for (const Expected& one : within)
        if (one.low <= within.front().high || one.ratio <= within.front().ratio * factor)
            ties += fmt::format("{}{} {:.2f} [{:.2f}, {:.2f}]", ties.empty() ? "" : "; ", one.name, one.ratio,
                                one.low, one.high);
    return ties;
}

TieSets expected(const ReportData& data, const std::string& shape, double limit) {
    std::map<std::string, std::vector<const ReportCell*>> scenes;
    for (const ReportCell& cell : data.cells)
        if (cell.shape == shape) scenes[cell.scene_label].push_back(&cell);
    TieSets sets;
    for (const auto& [label, cells] : scenes) sets[label] = expected_of(cells, limit);
    return sets;
}

/// Every match of label and tie set; "nothing is known to be within the error" is the empty set.
TieSets parsed(const std::string& text, const std::regex& pattern) {
    TieSets sets;
    for (std::sregex_iterator found(text.begin(), text.end(), pattern), end; found != end; ++found) {
        std::string set = (*found)[2];
        std::smatch head;
        if (std::regex_search(set, head, std::regex("^(alone: |[0-9]+ tie: )"))) {
            const std::string body = head.suffix();
            const auto count = static_cast<std::size_t>(std::count(body.begin(), body.end(), ';')) + 1;
            EXPECT_EQ(head.str(), count == 1 ? "alone: " : fmt::format("{} tie: ", count));
            set = body;
        }
        sets[(*found)[1]] = set.find("within") == set.npos ? set : "";
    }
    return sets;
}

TieSets on_first_screen(std::string html) {
    html = std::regex_replace(html, std::regex("<details class=\"ties\"><summary>([0-9]+ tie)</summary>"),
                              "$1: ");
    return parsed(
        html, std::regex("<th scope=\"row\">(.*?)<br>.*?<td><b>(?:nothing is known to be within the error</b>"
                         "<br><small>|[^<]*</b>(?:<br><small>)?)([^<]*)<"));
}

TieSets on_map(const std::string& html, const std::string& shape) {
    return parsed(html,
                  std::regex("<g data-shape=\"" + shape +
                             "\" data-scene=\"([^\"]*)\"><title>[^<]*?(?:\\. |: )((?:alone|[0-9]+ tie): "
                             "[^<]*?\\](?=; [0-9.]+ ns)|no table type is known to be within)"));
}

TieSets in_markdown(std::string text) {
    std::erase(text, '\\');  // of escaped brackets
    return parsed(text, std::regex("\n\\| ([^|]*) \\| [^|]* \\| (?:each|shared) \\| [^|]* \\| ([^|]*) \\|"));
}

TieSets on_terminal(const std::string& text, const std::string& shape) {
    return parsed(text, std::regex("\n  (.*), " + shape + ": (.*)"));
}

TieSets in_json(const nlohmann::json& json) {
    TieSets sets;
    for (const auto& scene : json["scenes"]) {
        std::string& set = sets[scene["scene"]];
        for (const auto& one : scene["cells"]) {
            if (!one["ties"]) continue;
            const auto& ratio = one["time_ratio"];
            set +=
                fmt::format("{}{} on {} {:.2f} [{:.2f}, {:.2f}]", set.empty() ? "" : "; ",
                            one["algorithm"] == "vclip" ? "V-Clip" : "GJK", one["table"].get<std::string>(),
                            ratio[1].get<double>(), ratio[0].get<double>(), ratio[2].get<double>());
        }
    }
    return sets;
}

/// Every fact of the decision table is on the first screen, in report.md and on the terminal.
void check_decisions(const ReportData& data, const Answer& answer, const std::string& html) {
    const double limit = answer.question.error_limit;
    const DecisionTable table = Decisions(data).table(limit, answer.shape);
    ASSERT_EQ(table.rows.size(), 1U);
    const std::string terminal = terminal_text(answer, data),
                      markdown = report_markdown(data, answer, {}, "");
    for (const Decision& one : {table.rows.front().shared, table.rows.front().own}) {
        EXPECT_THAT(html,
                    testing::HasSubstr("<b>" + (one.take.empty() ? "nothing is recommended" : one.take)));
        for (const std::string& fact : one.facts) EXPECT_THAT(html, testing::HasSubstr(html_text(fact)));
        EXPECT_THAT(terminal, testing::HasSubstr(one.text()));
        EXPECT_THAT(markdown, testing::HasSubstr(" | " + markdown_text(one.text()) + " |"));
    }
    EXPECT_THAT(terminal, testing::HasSubstr(table.sentence));
    EXPECT_THAT(html, testing::HasSubstr(html_text(table.sentence)));
    for (const std::string& change : table.changes) {
        EXPECT_THAT(terminal, testing::HasSubstr(change));
        EXPECT_THAT(html, testing::HasSubstr(html_text(change)));
    }
}

struct Seen {
    std::size_t alone = 0, tied = 0, none = 0;
};

std::string html_of(const nlohmann::json& screens, const std::string& question) {
    std::string html;
    for (const std::size_t line : screens["answers"][question]["html"])
        html += screens["lines"][line].get<std::string>() + "\n";
    return html;
}

void check_store(const ReportData& data, Seen& seen) {
    const auto screens = nlohmann::json::parse(answers_data(data)),
               maps = nlohmann::json::parse(break_even_data(data));
    for (const char* shape : {"cube8", "sphere386"}) {
        for (const double limit : offered_limits) {
            SCOPED_TRACE(fmt::format("{} {}", shape, limit));
            const TieSets wanted = expected(data, shape, limit);
            const Answer answer = answer_of(data, {.error_limit = limit, .shape = shape});
            const std::string question = fmt::format("{} {} both ", shape, limit_text(limit));
            EXPECT_EQ(on_first_screen(html_of(screens, question)), wanted);
            EXPECT_EQ(on_map(maps[fmt::format(" {} both", limit_text(limit))], shape), wanted);
            EXPECT_EQ(in_markdown(report_markdown(data, answer, {}, "")), wanted);
            EXPECT_EQ(on_terminal(terminal_text(answer, data), shape), wanted);
            EXPECT_EQ(in_json(answer_json(answer)), wanted);
            check_decisions(data, answer, html_of(screens, question));
            for (const auto& [label, set] : wanted)
                ++(set.empty() ? seen.none : set.find(';') == set.npos ? seen.alone : seen.tied);
        }
    }
}

TEST(OneRanker, NamesTheSameWinnersTiesAndIntervalsInEveryOutput) {
    Seen clear, ties, gaps;
    for (unsigned seed = 1; seed <= 2; ++seed) {
        check_store(stored(made_store(clear_winners, seed)), clear);
        check_store(stored(made_store(many_ties, seed)), ties);
        check_store(stored(made_store(errors_and_gaps, seed)), gaps);
    }
    EXPECT_EQ(clear.tied + clear.none, 0U);
    EXPECT_EQ(ties.none, 0U);
    EXPECT_GT(ties.tied, 10 * ties.alone);
    EXPECT_GT(gaps.none, 0U);
    EXPECT_GT(gaps.alone, 5U);
    EXPECT_GT(gaps.tied, 5U);
    fmt::print("{} {} {}; {} {} {}\n", ties.alone, ties.tied, ties.none, gaps.alone, gaps.tied, gaps.none);
}

}  // namespace
}  // namespace edgewise::reports
