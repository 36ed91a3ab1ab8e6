// SPDX-License-Identifier: MIT
//
// `edgewise query`: answers for pairs given in a case file, one JSON line each. A line that cannot be read or
// answered gets a line with status "failed" and the reason, so that no line is lost.
#include <fmt/format.h>

#include <fstream>
#include <iostream>
#include <new>
#include <stdexcept>

#include "edgewise/bench/certificates.hpp"
#include "edgewise/cli/options.hpp"
#include "edgewise/input/file_text.hpp"
#include "edgewise/scene/answer_claim.hpp"
#include "edgewise/scene/case_file.hpp"

namespace edgewise::cli {

namespace {

using Json = nlohmann::json;

/// A file of bad lines says the same a hundred thousand times.
constexpr std::size_t most_warnings = 10;

struct QueryArguments {
    std::string cases;
    std::string algorithm = "vclip";
    std::string table = "aos_f64";
    Needs needs = Needs::features;
    std::optional<double> margin;
    QueryOptions query;
};

/// Throws std::invalid_argument where one option leaves another without a meaning.
void check_needs(const QueryArguments& options) {
    if (options.margin && !has_margin(options.needs))
        throw std::invalid_argument("--margin goes with --needs nearer or within: give both");
    if (options.query.gap_tolerance != 0 && options.algorithm != "gjk")
        throw std::invalid_argument("--gap-tolerance is GJK's: add --algorithm gjk, or leave it out");
    if (has_margin(options.needs) && options.query.contact_tolerance != 0)
        throw std::invalid_argument(
            fmt::format("--needs {} asks for its --margin, not for contact: leave --contact-tolerance out",
                        to_string(options.needs)));
}

Json point_json(const Vec3d& p) { return {p.x(), p.y(), p.z()}; }

Json feature_json(const NamedFeature& feature) {
    return {{"kind", to_string(feature.kind)}, {"vertices", feature.vertices}};
}

/// All keys of an answer, with nothing in them yet.
Json empty_answer(const std::string& id) {
    Json line = {{"id", id}, {"status", "failed"}};
    for (const char* key :
         {"distance", "point_a", "point_b", "feature_a", "feature_b", "depth", "normal", "steps", "fallbacks",
          "refinements", "escapes", "nearer", "margin", "certificate", "stored_certificate", "error"}) {
        line[key] = nullptr;
    }
    return line;
}

Json failed_answer(const std::string& id, const std::string& error) {
    Json line = empty_answer(id);
    line["error"] = error;
    return line;
}

Json certificate_json(const truth::Certificate& certificate) {
    return {{"lower", certificate.lower}, {"upper", certificate.upper}};
}

Json answer_json(const std::string& id, const bench::NamedAnswer& answer, Needs needs) {
    Json line = empty_answer(id);
    const Distance& d = answer.distance;
    line["status"] = to_string(d.status);
    line["steps"] = d.steps;
    line["fallbacks"] = d.fallbacks;
    line["refinements"] = d.refinements;
    line["escapes"] = d.escapes;
    if (needs >= Needs::distance) line["distance"] = d.distance;
    const bool separated = d.status == Status::separated;
    if (needs >= (separated ? Needs::witnesses : Needs::depth)) {
        line["point_a"] = point_json(d.point_a);
        line["point_b"] = point_json(d.point_b);
    }
    if (needs >= Needs::features) {
        line["feature_a"] = feature_json(answer.feature_a);
        line["feature_b"] = feature_json(answer.feature_b);
    }
    if (needs >= Needs::depth && d.status == Status::overlapping) {
        line["depth"] = answer.depth;
        line["normal"] = point_json(answer.normal);
    }
    return line;
}

/// The cell that answers.
struct Respondent {
    const bench::TableType& type;
    std::unique_ptr<bench::Runner> runner;
};

/// Why the distance cannot be right, by the certificate of the bodies as stored; empty if it can be.
std::string contradiction(const bench::NamedAnswer& answer, const truth::Certificate& stored,
                          const scene::Query& query, const Respondent& by, const QueryArguments& options) {
    const auto band = scene::placed(by.runner->stored_bodies(), query).band(by.type.eps);
    const double allowed =
        studies::allowed_errors(by.type, options.algorithm).distance * band.scale + band.band;
    const double distance = answer.distance.distance,
                 given_away = options.query.contact_tolerance + options.query.gap_tolerance * distance;
    return bench::contradiction(distance, stored, allowed, allowed + given_away);
}

/// Both bodies' tables are built again for each case: cases rarely share bodies.
Json answer_case(const scene::Case& given, const Respondent& by, const QueryArguments& options) {
    bench::Runner& runner = *by.runner;
    const auto a = scene::body_from_case(given.a);
    if (!a) return failed_answer(given.id, a.error);
    const auto b = scene::body_from_case(given.b);
    if (!b) return failed_answer(given.id, b.error);
    const std::vector<Polyhedron> bodies = {*a, *b};
    if (const std::string error = runner.load(bodies); !error.empty()) return failed_answer(given.id, error);
    const scene::Query query{0, 1, 0, given.pose_a, given.pose_b};
    const bench::NamedAnswer answer = runner.answer(query);
    if (answer.distance.status == Status::failed || !std::isfinite(answer.distance.distance)) {
        return failed_answer(
            given.id,
            "the bodies are too large, too small or too far apart for this precision: use f64, "
            "or another unit");
    }
    const bool asks_margin = has_margin(options.needs);
    const double margin = asks_margin ? runner.margin(query) : 0;
    const bool nearer = answer.distance.distance < margin;
    const Needs needs = options.needs == Needs::within && nearer ? Needs::witnesses : options.needs;
    Json line = answer_json(given.id, answer, needs);
    if (asks_margin) line["margin"] = margin, line["nearer"] = nearer;
    if (needs < Needs::certificate) return line;
    const auto certificates = bench::certificates_of(answer, query, bodies, runner.stored_bodies(),
                                                     given.a.vertices, given.b.vertices);
    if (!certificates) return failed_answer(given.id, certificates.error);
    const std::string wrong = contradiction(answer, certificates->stored, query, by, options);
    if (!wrong.empty()) return failed_answer(given.id, wrong);
    line["certificate"] = certificate_json(certificates->given);
    line["stored_certificate"] = certificate_json(certificates->stored);
    return line;
}

/// A case that fails, however it does so, fails alone.
Json answer_alone(const scene::Case& given, const Respondent& by, const QueryArguments& options) {
    try {
        return answer_case(given, by, options);
    } catch (const std::bad_alloc&) {
        return failed_answer(given.id, "out of memory: ask for smaller bodies");
    } catch (const std::exception& problem) {
        return failed_answer(given.id, problem.what());
    }
}

Respondent chosen_respondent(const QueryArguments& options) {
    const auto types = bench::select_table_types(std::vector{options.table});
    if (types.size() != 1) {
        throw std::invalid_argument(fmt::format("--table takes one table type, such as {}; '{}' names {}",
                                                types.front()->name, options.table, types.size()));
    }
    static_cast<void>(bench::select_algorithms(std::vector{options.algorithm}));
    auto runner = types.front()->make_runner(options.algorithm);
    if (!runner) {
        throw std::invalid_argument(
            fmt::format("table type {} does not hold what {} needs", types.front()->name, options.algorithm));
    }
    // Answers are complete whatever is needed of them; questions about a margin have it of the runner.
    const Needs needs = options.needs;
    runner->configure({.query = options.query,
                       .needs = has_margin(needs) ? needs : Needs::witnesses,
                       .margin = options.margin.value_or(bench::usual_margin)});
    return {*types.front(), std::move(runner)};
}

struct Asked {
    std::size_t lines = 0, unreadable = 0, failed = 0;

    [[nodiscard]] std::size_t bad() const { return unreadable + failed; }
    /// Bad input only if it is nothing else: a line that fails takes none of the others with it.
    [[nodiscard]] int exit_code() const {
        if (unreadable == lines) return exit_bad_input;
        return bad() > 0 ? exit_check_failed : exit_done;
    }
};

/// Prints an answer for every line.
Asked ask(scene::CaseReader& reader, const Respondent& by, const QueryArguments& options) {
    Asked asked;
    while (const auto line = reader.next()) {
        ++asked.lines;
        const Json answer =
            *line ? answer_alone(**line, by, options) : failed_answer(reader.id(), line->error);
        if (!*line) {
            ++asked.unreadable;
        } else if (answer["status"] == "failed") {
            ++asked.failed;
        }
        if (!answer["error"].is_null() && asked.bad() <= most_warnings) {
            const auto error = answer["error"].get<std::string>();
            const std::string where = fmt::format("{}:{}: ", options.cases, reader.line());
            warn(error.starts_with(where) ? error : where + error);
        }
        print_json(answer);
    }
    return asked;
}

int run_query(const QueryArguments& options, bool /*Json*/) {
    check_needs(options);
    const Respondent by = chosen_respondent(options);
    std::ifstream file;
    if (options.cases != "-") {
        if (const std::string wrong = input::what_is_wrong_with(options.cases); !wrong.empty())
            throw std::invalid_argument(
                fmt::format("cannot read {}: {}; - reads standard input", options.cases, wrong));
        file.open(options.cases);
    }
    scene::CaseReader reader(options.cases == "-" ? std::cin : file, options.cases);
    const Asked asked = ask(reader, by, options);
    if (asked.bad() > most_warnings)
        warn(fmt::format(
            "and {} more: {} lines could not be read, {} had no answer; each answer's line says why",
            asked.bad() - most_warnings, asked.unreadable, asked.failed));
    if (const std::string note = reader.rotation_note(); !note.empty()) warn(note);
    if (asked.lines == 0)
        throw std::invalid_argument(fmt::format(
            "{}: no case in it; a case is one line of JSON, and --help shows one", options.cases));
    return asked.exit_code();
}

}  // namespace

void add_query(CLI::App& app, Context& context) {
    auto [command, options] =
        add_command(app, context, "query", "Answers for given pairs, one JSON line each", run_query);
    command->add_option("cases", options.cases, "case file, one JSON object per line; - reads stdin")
        ->required();
    add_algorithm_option(*command, options.algorithm);
    add_table_option(*command, options.table, "--table,--layout");
    add_needs_option(
        *command, [&needs = options.needs](Needs asked) { needs = asked; }, options.needs);
    add_margin_option(*command, options.margin);
    add_sub_distance_option(*command, options.query.sub_distance);
    add_number(*command, "--contact-tolerance", options.query.contact_tolerance, input::from_0,
               "bodies as near as this or nearer are touching, in the bodies' own unit");
    add_number(*command, "--gap-tolerance", options.query.gap_tolerance, {0, 0.999},
               "GJK ends when the squared distance is known to this relative width");
}

}  // namespace edgewise::cli
