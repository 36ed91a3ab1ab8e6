// SPDX-License-Identifier: MIT
//
// `edgewise judge`: a pair as people post it, and who is wrong about it: what was read, exact answer, every
// algorithm's and every library's, a smaller pair that still fails, and a test case for either side.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <iostream>
#include <stdexcept>
#include <tuple>

#include "edgewise/bench/peers/peer_modules.hpp"
#include "edgewise/cli/options.hpp"
#include "edgewise/geometry/aabb.hpp"
#include "edgewise/input/file_text.hpp"
#include "edgewise/reports/tables/text_grid.hpp"
#include "edgewise/scene/case_text.hpp"
#include "edgewise/scene/dumps/dump.hpp"
#include "edgewise/studies/judge/pair_judge.hpp"

namespace edgewise::cli {

namespace {

using Json = nlohmann::json;

struct JudgeInput {
    std::string text;            ///< a file, or - for stdin
    std::string body_a, body_b;  ///< instead: names or mesh files
    std::string pose_a, pose_b;  ///< of body_a and body_b
    bool as_stored = false;      ///< of mesh files (scene::MeshReading)
};

/// Every point of a mesh file, because a pair is judged as it was given to the last bit; or a built-in body's
/// vertices.
scene::CaseBody body_called(const std::string& name, bool as_stored) {
    return {name, chosen_body({name, as_stored && scene::names_mesh_file(name)}, true).points, {}};
}

/// 3 numbers: a translation; 12 or 16: rows of a matrix with the translation last.
std::vector<double> pose_numbers(const std::string& text, const std::string& option) {
    auto numbers = scene::numbers_in(text);
    if (!numbers) throw std::invalid_argument(fmt::format("{} {}: {}", option, text, numbers.error));
    const std::size_t count = numbers->size();
    if (count != 3 && count != 12 && count != 16)
        throw std::invalid_argument(fmt::format(
            "{}: {} numbers; write x,y,z, or the 12 (or 16) numbers of a matrix, row by row", option, count));
    return *std::move(numbers);
}

Pose pose_from(const std::string& text, const std::string& option) {
    if (text.empty()) return {};
    const std::vector<double> m = pose_numbers(text, option);
    if (m.size() == 3) return {Mat3d::Identity(), {m[0], m[1], m[2]}};
    auto pose = scene::pose_from_rows(m, option);
    if (!pose.warning.empty()) warn(pose.warning + "; the nearest rotation is used");
    return std::move(pose).or_throw();
}

/// Refused on the command line already.
std::function<void(std::string)> is_pose(const char* option) {
    return [option](const std::string& text) { static_cast<void>(pose_numbers(text, option)); };
}

std::string text_from(const std::string& file) {
    if (file != "-") return input::read_file_text(file).or_throw();
    std::string text;
    char buffer[65536];
    while (std::cin.read(buffer, sizeof buffer), std::cin.gcount() > 0) {
        text.append(buffer, static_cast<std::size_t>(std::cin.gcount()));
        if (text.size() > input::most_text_bytes)
            throw std::invalid_argument(
                fmt::format("-: more than the {} bytes that are read of a text", input::most_text_bytes));
    }
    return text;
}

Json json_of(const Vec3d& v) { return {v.x(), v.y(), v.z()}; }

Json json_of(const scene::CaseBody& body) {
    const Aabb box = box_of(body.vertices);
    return {{"vertices", body.vertices.size()},
            {"faces", body.faces ? Json(body.faces->size()) : Json()},
            {"low", json_of(box.low)},
            {"high", json_of(box.high)},
            {"extent", json_of(box.sides())}};
}

Json json_of(const Pose& pose) {
    const scene::Turn turn = scene::turn_of(pose.rotation);
    return {{"translation", json_of(pose.translation)},
            {"axis", turn.degrees == 0 ? Json() : json_of(turn.axis)},
            {"degrees", turn.degrees}};
}

void add_judge_input(CLI::App& command, JudgeInput& input) {
    CLI::Option* const text = command.add_option(
        "pair", input.text, "a file, or - for stdin: a case line, or what FCL or Drake printed");
    CLI::Option* const a = add_shape_option(command, input.body_a, input.as_stored, "--a")->excludes(text);
    CLI::Option* const b = add_shape_option(command, input.body_b, input.as_stored, "--b");
    command.get_option("--as-stored")->needs(a);
    a->needs(b);
    b->needs(a);
    for (const auto& [name, pose, body] :
         {std::tuple("--pose-a", &input.pose_a, a), std::tuple("--pose-b", &input.pose_b, b)})
        command.add_option(name, *pose, "x,y,z, or a matrix of 12 or 16 numbers, row by row")
            ->type_name("NUMBERS")
            ->each(is_pose(name))
            ->needs(body);
}

scene::PastedPair read_judge_input(const JudgeInput& input) {
    if (input.text.empty() && input.body_a.empty())
        throw std::invalid_argument(
            "no pair: name a file or - for stdin, or --a and --b; --template prints a case to fill in");
    if (!input.text.empty()) {
        auto pasted = scene::read_pasted(text_from(input.text), input.text);
        if (!pasted.warning.empty())
            warn(fmt::format("{}: {}; the nearest rotation is used", input.text, pasted.warning));
        return std::move(pasted).or_throw();
    }
    scene::refuse_as_stored_without_mesh(input.as_stored, std::array{input.body_a, input.body_b});
    return {{"meshes", body_called(input.body_a, input.as_stored), body_called(input.body_b, input.as_stored),
             pose_from(input.pose_a, "--pose-a"), pose_from(input.pose_b, "--pose-b")},
            scene::names_mesh_file(input.body_a) && scene::names_mesh_file(input.body_b) ? "mesh files"
                                                                                         : "named bodies",
            std::nullopt};
}

Json read_json(const scene::PastedPair& pasted) {
    const scene::Case& pair = pasted.pair;
    return {{"a", json_of(pair.a)},
            {"pose_a", json_of(pair.pose_a)},
            {"b", json_of(pair.b)},
            {"pose_b", json_of(pair.pose_b)}};
}

void print_read(const scene::PastedPair& pasted) {
    const scene::Case& pair = pasted.pair;
    fmt::print("read: {}\n  A: {}\n     {}\n  B: {}\n     {}\n", pasted.format, scene::text_of(pair.a),
               scene::text_of(pair.pose_a), scene::text_of(pair.b), scene::text_of(pair.pose_b));
    std::fflush(stdout);  // before the verdict, and also where there is none
}

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
    Json json = {{"id", judged.pasted.pair.id},
                 {"format", judged.pasted.format},
                 {"read", read_json(judged.pasted)},
                 {"exact", json_of(judged.truth)},
                 {"answers", json_rows(judged.answers, [](const auto& answer) { return json_of(answer); })},
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
