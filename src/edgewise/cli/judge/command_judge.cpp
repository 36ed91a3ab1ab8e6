// SPDX-License-Identifier: MIT
//
// `edgewise judge`: a pair as people post it, and who is wrong about it: what was read, exact answer, every
// algorithm's and every library's, a smaller pair that still fails, and a test case for either side.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "edgewise/bench/peers/peer_modules.hpp"
#include "edgewise/cli/judge/judge_input.hpp"
#include "edgewise/cli/options.hpp"
#include "edgewise/input/count.hpp"
#include "edgewise/reports/tables/text_grid.hpp"
#include "edgewise/scene/case_text.hpp"
#include "edgewise/studies/judge/pair_judge.hpp"

namespace edgewise::cli {

namespace {

using Json = nlohmann::json;

struct JudgeArguments {
    JudgeInput input;
    std::vector<std::string> layouts = {"all"}, algorithms = {"all"}, peers;
    std::vector<std::string> said;  ///< LIBRARY=DISTANCE
    bool as_given = false;          ///< no smaller pair is looked for
    bool tests = false;             ///< C++ for FCL and Bullet
    bool case_to_fill_in = false;   ///< nothing is judged
};

scene::ReportedAnswer said_answer(const std::string& text) {
    const std::size_t equals = text.find('=');
    const bool named = equals != text.npos && equals > 0;
    const auto distance = input::parse_number(named ? std::string_view(text).substr(equals + 1) : "");
    if (!distance)
        throw std::invalid_argument(fmt::format(
            "--said {}: write LIBRARY=DISTANCE, a depth as a negative distance, as in --said fcl=3.1622",
            text));
    return {text.substr(0, equals) + ", as reported", "", *distance};
}

/// Those that are asked for; without a word those that there are.
std::vector<const bench::TableType*> chosen_peers(const std::vector<std::string>& names) {
    if (!names.empty()) return bench::select_peer_types(names);
    std::vector<const bench::TableType*> all;
    for (const bench::TableType& peer : bench::peer_types()) all.push_back(&peer);
    return all;
}

struct Judged {
    scene::PastedPair pasted;
    studies::PairTruth truth;
    std::vector<studies::JudgedResponse> answers;
    std::optional<studies::SmallerPair> smaller;
    std::vector<std::string> wrong;  ///< names of those whose answers are wrong

    /// False if every answer was refused.
    [[nodiscard]] bool is_compared() const {
        return std::ranges::any_of(
            answers, [](const auto& answer) { return answer.is != studies::AnswerIs::refused; });
    }
};

/// `said`: judged with the others.
Judged judge(const JudgeArguments& options, const scene::PastedPair& pasted,
             std::vector<scene::ReportedAnswer> said) {
    Judged judged;
    judged.pasted = pasted;
    const scene::Case& pair = judged.pasted.pair;
    judged.truth = studies::truth_of(pair).or_throw();
    const auto respondents =
        studies::respondents_of(bench::select_table_types(options.layouts),
                                bench::select_algorithms(options.algorithms), chosen_peers(options.peers));
    judged.answers = studies::ask_all(respondents, pair, judged.truth);
    if (judged.pasted.reported) said.insert(said.begin(), *judged.pasted.reported);
    for (const scene::ReportedAnswer& reported : said)
        judged.answers.push_back(studies::judge_reported(reported, pair, judged.truth));
    for (const auto& answer : judged.answers)
        if (answer.wrong()) judged.wrong.push_back(answer.who);
    if (options.as_given) return judged;
    for (const studies::Respondent& respondent : respondents) {
        if (std::ranges::find(judged.wrong, respondent.name()) == judged.wrong.end()) continue;
        judged.smaller = studies::smaller_pair(respondent, pair);
        if (judged.smaller) break;
    }
    return judged;
}

/// What a test wants of a pair.
scene::ExpectedAnswer expected_of(const studies::PairTruth& truth) {
    return {truth.exact.distance, truth.depth};
}

/// The pair that goes into tests: the smaller one where there is one.
std::pair<const scene::Case&, const studies::PairTruth&> tested(const Judged& judged) {
    if (judged.smaller) return {judged.smaller->found.pair, judged.smaller->truth};
    return {judged.pasted.pair, judged.truth};
}

std::string line_of(const Judged& judged) {
    const auto& [pair, truth] = tested(judged);
    const std::string source = judged.smaller
                                   ? judged.pasted.format + ", made smaller for " + judged.smaller->answer.who
                                   : judged.pasted.format;
    return scene::case_line(pair, source, expected_of(truth));
}

Json json_of(const studies::JudgedResponse& answer) {
    return {{"who", answer.who},
            {"same", answer.same},
            {"status", answer.status},
            {"distance", or_null(answer.distance)},
            {"depth", or_null(answer.depth)},
            {"verdict", to_string(answer.is)},
            {"wrong", answer.wrong()},
            {"error", answer.error},
            {"beyond", answer.beyond},
            {"error_of_given", answer.of_given},
            {"why", or_null(answer.why)}};
}

Json json_of(const studies::PairTruth& truth) {
    return {{"verdict", to_string(truth.exact.verdict)},
            {"distance", truth.exact.distance},
            {"depth", or_null(truth.depth)},
            {"scale", truth.band.scale},
            {"band", truth.band.band},
            {"certificate", truth.certificate ? Json{{"lower", truth.certificate->lower},
                                                     {"upper", truth.certificate->upper}}
                                              : Json()},
            {"no_certificate", or_null(truth.no_certificate)}};
}

Json json_of(const Judged& judged, bool tests) {
    Json answers = Json::array();
    for (const auto& answer : judged.answers) answers.push_back(json_of(answer));
    Json json = {{"id", judged.pasted.pair.id},
                 {"format", judged.pasted.format},
                 {"read", read_json(judged.pasted)},
                 {"exact", json_of(judged.truth)},
                 {"answers", answers},
                 {"compared", judged.is_compared()},
                 {"wrong", judged.wrong},
                 {"case", Json::parse(line_of(judged))},
                 {"smaller", nullptr}};
    if (judged.smaller)
        json["smaller"] = {{"of", judged.smaller->answer.who},
                           {"answer", json_of(judged.smaller->answer)},
                           {"exact", json_of(judged.smaller->truth)},
                           {"tried", judged.smaller->found.tried},
                           {"at_limit", judged.smaller->found.at_limit}};
    if (!tests) return json;
    const auto& [pair, truth] = tested(judged);
    const auto fcl = scene::fcl_test(pair, expected_of(truth));
    json["tests"] = {{"fcl", fcl ? Json(*fcl) : Json()},
                     {"no_fcl", or_null(fcl.error)},
                     {"bullet", scene::bullet_test(pair, expected_of(truth))}};
    return json;
}

void print_truth(const studies::PairTruth& truth, const std::string& name) {
    fmt::print("{}: {}", name, to_string(truth.exact.verdict));
    if (truth.depth) {
        fmt::print(", depth {}\n", *truth.depth);
    } else {
        fmt::print(", distance {}\n", truth.exact.distance);
    }
    if (truth.certificate) {
        fmt::print("certificate: the distance lies in [{}, {}]\n", truth.certificate->lower,
                   truth.certificate->upper);
    } else {
        fmt::print("certificate: none: {}\n", truth.no_certificate);
    }
    fmt::print("scale {:.4g}; a verdict nearer to grazing than {:.2g} is left to rounding (double)\n",
               truth.band.scale, truth.band.band);
}

std::string number_text(const std::optional<double>& value) {
    return value ? fmt::format("{:.10g}", *value) : "-";
}

void print_answers(const std::vector<studies::JudgedResponse>& answers) {
    reports::TextGrid table{"", reports::columns_of("who|says|#distance|#depth|#error|verdict")};
    for (const auto& answer : answers) {
        const std::string who =
            answer.same.empty() ? answer.who : fmt::format("{} + {}", answer.who, answer.same.size());
        std::string verdict(to_string(answer.is));
        if (answer.wrong()) verdict = "WRONG: " + answer.why;
        if (answer.wrong() && answer.beyond > 0)
            verdict += fmt::format(" ({:.3g} beyond what is allowed)", answer.beyond);
        if (!answer.wrong() && !answer.why.empty()) verdict += ": " + answer.why;
        table.add(who, answer.status, number_text(answer.distance), number_text(answer.depth),
                  answer.distance ? fmt::format("{:.2g}", answer.error) : "-", verdict);
    }
    fmt::print("\n{}'+ n': so many further table types give the same answer to the bit; --json names them\n",
               grid_text(table));
}

void print_smaller(const Judged& judged) {
    if (!judged.smaller) return;
    const auto& found = judged.smaller->found;
    const scene::CaseSize before = size_of(judged.pasted.pair), after = size_of(found.pair);
    fmt::print("\nsmaller, {} still wrong: {} vertices of {}, {} digits of {} ({} pairs tried{})\n",
               judged.smaller->answer.who, after.vertices, before.vertices, after.digits, before.digits,
               found.tried, found.at_limit ? ", at the limit" : "");
    print_truth(judged.smaller->truth, "exact");
    print_answers({judged.smaller->answer});
}

void print_tests(const Judged& judged) {
    const auto& [pair, truth] = tested(judged);
    const auto fcl = scene::fcl_test(pair, expected_of(truth));
    fmt::print("\n// for FCL\n{}\n// for Bullet\n{}", fcl ? *fcl : "// none: " + fcl.error + "\n",
               scene::bullet_test(pair, expected_of(truth)));
}

std::string conclusion(const Judged& judged) {
    if (!judged.is_compared()) return "nothing was compared: every answer was refused";
    if (!judged.wrong.empty()) return fmt::format("wrong: {}", fmt::join(judged.wrong, ", "));
    return "nobody is wrong";
}

void print_judged(const Judged& judged, bool tests) {
    print_truth(judged.truth, "exact");
    print_answers(judged.answers);
    print_smaller(judged);
    fmt::print("\nfor a case file of Edgewise:\n{}\n", line_of(judged));
    if (tests) print_tests(judged);
    fmt::print("\n{}\n", conclusion(judged));
}

int run_judge(const JudgeArguments& options, bool json) {
    if (options.case_to_fill_in) {
        fmt::print("{}\n", scene::case_template);
        return exit_done;
    }
    std::vector<scene::ReportedAnswer> said;
    for (const std::string& text : options.said) said.push_back(said_answer(text));
    const scene::PastedPair pasted = read_judge_input(options.input);
    if (!json) print_read(pasted);
    const Judged judged = judge(options, pasted, std::move(said));
    if (json) {
        fmt::print("{}\n", input::json_text(json_of(judged, options.tests)));
    } else {
        print_judged(judged, options.tests);
    }
    return judged.wrong.empty() && judged.is_compared() ? exit_done : exit_check_failed;
}

}  // namespace

void add_judge(CLI::App& app, Context& context) {
    auto [command, options] = add_command(
        app, context, "judge",
        "A pair as people post it, and who is wrong about it; exit code 1 where somebody is", run_judge);
    add_judge_input(*command, options.input);
    add_layouts_option(*command, options.layouts);
    add_algorithms_option(*command, options.algorithms);
    add_names(*command, "--peers", options.peers,
              "these other libraries; every one that is built if not given");
    command
        ->add_option("--said", options.said,
                     "what a library printed, judged with the others; a depth is a negative distance")
        ->type_name("LIBRARY=NUMBER")
        ->each([](const std::string& text) { static_cast<void>(said_answer(text)); });
    command->add_flag("--as-given", options.as_given, "look for no smaller pair that still fails");
    command->add_flag("--template", options.case_to_fill_in, "print a case to fill in, and judge nothing");
    command->add_flag("--tests", options.tests, "also the pair as a test in C++ for FCL and for Bullet");
}

}  // namespace edgewise::cli
