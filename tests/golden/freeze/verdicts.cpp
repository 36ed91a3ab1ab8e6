// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>

#include "corpus.hpp"
#include "edgewise/bench/registry.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "frozen.hpp"
#include "judged_case.hpp"

namespace edgewise::golden {

namespace {

struct Subject {
    const bench::TableType& type;
    std::string algorithm;
    std::unique_ptr<bench::Runner> runner;
};

/// Every precision, and every way to store a body.
std::vector<Subject> subjects() {
    std::vector<Subject> all;
    for (const std::string name :
         {"aos_f64", "aos_f32", "aos_mixed", "lean_f64", "points_soa_f32", "quantised_f32"}) {
        const bench::TableType& type = bench::table_type_called(name);
        for (const std::string& algorithm : type.algorithms)
            all.push_back({type, algorithm, type.make_runner(algorithm)});
    }
    return all;
}

/// "separated 1.5", "overlapping 0 WRONG", "refused".
std::string verdict(const Subject& subject, const scene::Case& given) {
    const double eps = subject.type.eps;
    const JudgedCase judged = judge_case(*subject.runner, {eps}, given);
    if (!judged.answered) return "refused";
    const Distance answer =
        subject.runner->answer(scene::Query{0, 1, 0, given.pose_a, given.pose_b}).distance;
    return fmt::format("{} {:.17g}{}", to_string(answer.status), answer.distance,
                       judged.complaints.empty() ? "" : " WRONG");
}

}  // namespace

void add_verdicts(Texts& texts) {
    const std::vector<Subject> all = subjects();
    std::string& text = texts["verdicts.txt"];
    text = "case";
    for (const Subject& subject : all) text += fmt::format(" | {} {}", subject.type.name, subject.algorithm);
    text += '\n';
    for (const scene::Case& given : corpus()) {
        text += given.id;
        for (const Subject& subject : all) text += " | " + verdict(subject, given);
        text += '\n';
    }
}

}  // namespace edgewise::golden
