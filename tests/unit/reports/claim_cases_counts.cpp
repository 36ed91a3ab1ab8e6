// SPDX-License-Identifier: MIT
//
// Cases of the claims about numbers of bodies, failures, tolerances and the algorithms' work.
#include <cmath>

#include "claim_cases.hpp"

namespace edgewise::reports {

namespace {

std::function<ReportData(double)> bodies(const std::function<MadeFigures(double, double)>& figures) {
    return [=](double x) {
        ReportData data;
        for (const double count : {10., 100., 1000.})
            for (const std::string& algorithm : both_algorithms)
                add_cell(data, {"paper_bodies", "cube8", algorithm, "bodies", count}, figures(count, x));
        return data;
    };
}

std::function<ReportData(double)> power_of_bodies(const std::vector<std::string>& names) {
    return bodies([=](double count, double exponent) {
        MadeFigures figures;
        for (const std::string& name : names) figures.push_back({name, std::pow(count, exponent)});
        return figures;
    });
}

std::function<ReportData(double)> failures(const std::string& figure, const std::string& checked) {
    return [=](double count) {
        ReportData data;
        for (const std::string& algorithm : both_algorithms)
            data.cells.push_back(
                make_cell({"static", "cube8", algorithm}, {{figure, count}, {checked, 1e6}}));
        return data;
    };
}

void add_family(ReportData& data, const std::string& algorithm, const std::string& table,
                const MadeFigures& figures) {
    MadeFigures all = figures;
    all.push_back({"stability.cases", 1e5});
    data.stability.push_back(make_cell({"stability", "random_fuzz", algorithm, "", 0, table}, all));
}

std::function<ReportData(double)> family(const std::string& figure, const MadeFigures& others = {}) {
    return [=](double count) {
        ReportData data;
        MadeFigures figures = others;
        figures.push_back({"stability." + figure, count});
        for (const std::string& algorithm : both_algorithms) add_family(data, algorithm, "aos_f64", figures);
        return data;
    };
}

ReportData telling(double times_more) {
    ReportData data;
    add_family(data, "vclip", "aos_f64", {{"stability.failures_at_0e+00", 100 * times_more}});
    add_family(data, "gjk", "aos_f64", {{"stability.failures_at_0e+00", 100}});
    return data;
}

/// A query takes 1 ns.
std::function<ReportData(double)> building(const std::string& algorithm) {
    return [=](double ns) {
        ReportData data;
        MadeFigures figures = made_time(1);
        figures.push_back({"build.build_ns", ns});
        add_angular(data, 386, algorithm, [&](int) { return figures; });
        return data;
    };
}

/// Refitted or built; a query takes 10 ns.
std::function<ReportData(double)> making_ready(const std::string& figure) {
    return [=](double vclip) {
        ReportData data;
        for (const std::string& algorithm : both_algorithms) {
            MadeFigures figures = made_time(10);
            figures.push_back({figure, algorithm == "vclip" ? 100 * vclip : 100});
            add_angular(data, 386, algorithm, [&](int) { return figures; });
        }
        return data;
    };
}

/// GJK's grow with the square root everywhere: it is shown, and decides nothing.
std::function<ReportData(double)> sizes(const std::string& scene, const std::string& algorithm,
                                        const std::function<MadeFigures(double, double)>& figures) {
    return [=](double x) {
        ReportData data;
        for (const int vertices : {8, 38, 386, 6146}) {
            add_cell(data, {scene, made_shape(vertices), algorithm}, figures(vertices, x));
            if (algorithm != "gjk")
                add_cell(data, {scene, made_shape(vertices), "gjk"}, figures(vertices, 0.5));
        }
        return data;
    };
}

/// The climb at `kind` 1: a logarithm; at 0: a power.
MadeFigures climb(double vertices, double kind) {
    return {{"work.vertices_per_support", kind > 0 ? 2 + 3 * std::log(vertices) : std::sqrt(vertices)}};
}

ReportData neighbours(double share) {
    ReportData data;
    for (const int vertices : {8, 38, 386})
        add_angular(data, vertices, "gjk", [=](int) {
            return MadeFigures{{"work.support_near", share}, {"work.support_unchanged", share}};
        });
    return data;
}

ReportData early(double subsets) {
    const MadeFigures figures = {{"work.subsets_tried", subsets},
                                 {"work.accepted_1", 0.1},
                                 {"work.accepted_2", 0.2},
                                 {"work.accepted_3", 0.6},
                                 {"work.accepted_4", 0.1}};
    ReportData data;
    add_cell(data, {"paper_static", "cube8", "gjk"}, figures);
    add_angular(data, 8, "gjk", [&](int) { return figures; });
    return data;
}

std::vector<ClaimCase> scalability_cases() {
    const auto slowing = bodies([](double count, double x) { return made_time(count == 1000 ? x : 1); });
    return {
        {"tests_linear_in_bodies", power_of_bodies({"cost.pairs_per_step"}), 1, 1.5},
        {"sweep_work_linear", power_of_bodies({"cost.moves_per_step", "cost.box_tests_per_step"}), 1, 1.67},
        {"step_linear_in_bodies", power_of_bodies({"cost.step_ns"}), 1, 1.67},
        {"more_bodies_slow_queries", slowing, 1.5, 0.9, 1.05}};
}

std::vector<ClaimCase> robustness_cases() {
    return {{"zero_failures_control",
             failures("error.control_disagreements_outside_band", "error.control_checked"), 0, 1},
            {"zero_failures_exact", failures("error.wrong_verdicts", "error.checked"), 0, 1},
            {"zero_failures_hard_families", family("wrong_outside_band"), 0, 1},
            {"robustness_metric_tells_apart", telling, 2, 1},
            {"tolerance_1e5_harmless", family("failures_at_1e-05", {{"stability.failures_at_0e+00", 0}}), 100,
             1e4}};
}

}  // namespace

std::vector<ClaimCase> count_cases() {
    std::vector<ClaimCase> cases = scalability_cases();
    for (const ClaimCase& one : robustness_cases()) cases.push_back(one);
    const auto power_of_time = [](double n, double x) { return made_time(std::pow(n, x)); };
    const auto power_of_steps = [](double n, double x) {
        return MadeFigures{{"error.mean_steps.warm", std::pow(n, x)}};
    };
    const auto power_of_climb = [](double n, double x) {
        return MadeFigures{{"work.vertices_per_support", std::pow(n, x)}};
    };
    for (const ClaimCase& one : std::vector<ClaimCase>{
             {"preprocessing_substantial", building("vclip"), 1000, 10, 100},
             {"deformation_favours_gjk", making_ready("build.refit_ns"), 2, 0.5, 1},
             {"fracturing_favours_gjk", making_ready("build.build_ns"), 4, 1, 2.1},
             {"vclip_time_constant", sizes("paper_complexity", "vclip", power_of_time), 0.02, 0.5, 0.1},
             {"vclip_steps_constant", sizes("paper_complexity", "vclip", power_of_steps), 0.02, 0.5},
             {"hill_climbing_logarithmic", sizes("paper_cold", "gjk", climb), 1, 0},
             {"hill_climbing_beats_scan", sizes("paper_cold", "gjk", power_of_climb), 0.5, 1},
             {"support_unchanged_or_near", neighbours, 0.95, 0.2},
             {"subdistance_accepts_early", early, 3, 14}})
        cases.push_back(one);
    return cases;
}

}  // namespace edgewise::reports
