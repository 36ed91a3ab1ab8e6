// SPDX-License-Identifier: MIT
//
// Cases of the claims about cost functions, speed, coherence and complexity.
#include "claim_cases.hpp"

namespace edgewise::reports {

namespace {

ReportData of_static(const std::function<double(const std::string&, int)>& ns) {
    ReportData data;
    for (const std::string& algorithm : both_algorithms)
        for (const int vertices : {4, 8, 38, 386})
            add_cell(data, {"paper_static", made_shape(vertices), algorithm},
                     made_time(ns(algorithm, vertices)));
    return data;
}

ReportData static_gjk(double ns) {
    return of_static([=](const std::string& algorithm, int) { return algorithm == "gjk" ? ns : 1; });
}

void add_linear(ReportData& data, double slowest_gjk) {
    for (const double step : {0.05, 0.25, 0.5}) {
        add_cell(data, {"paper_linear_8", "cube8", "vclip", "step_in_dimensions", step}, made_time(1));
        add_cell(data, {"paper_linear_8", "cube8", "gjk", "step_in_dimensions", step},
                 made_time(step == 0.5 ? slowest_gjk : 1.5));
    }
}

ReportData linear(double slowest_gjk) {
    ReportData data;
    add_linear(data, slowest_gjk);
    return data;
}

std::function<ReportData(double)> angular(int vertices) {
    return [=](double gjk) {
        ReportData data;
        add_angular_time(data, vertices, "vclip", 1);
        add_angular_time(data, vertices, "gjk", gjk);
        return data;
    };
}

ReportData comparable(double gjk) {
    ReportData data;
    add_linear(data, 1.2);
    for (const int vertices : {8, 38}) {
        add_angular_time(data, vertices, "vclip", 1);
        add_angular_time(data, vertices, "gjk", gjk);
    }
    return data;
}

MadeFigures steps_and_time(double value) {
    MadeFigures figures = made_time(value);
    for (const char* start : {"cold", "warm"})
        figures.push_back({std::string("error.mean_steps.") + start, value});
    return figures;
}

/// Returns cells with cold starts and cells with warm starts for the same pairs. A warm start makes V-Clip
/// faster by the factor `gain` and does not change GJK.
ReportData caching(double gain) {
    ReportData data;
    for (const std::string& algorithm : both_algorithms)
        for (const int vertices : {8, 38, 386})
            for (const double step : {1.0 / 60, 0.5})
                for (const std::string table : {"aos_f64", "aos_f64 start=cold"})
                    add_cell(data,
                             {"paper_caching", made_shape(vertices), algorithm, "rotation_step", step, table},
                             steps_and_time(algorithm == "vclip" && table != "aos_f64" ? gain : 1));
    return data;
}

ReportData speed(double fastest) {
    ReportData data;
    for (const std::string& algorithm : both_algorithms)
        add_angular(data, 8, algorithm, [=](int number) {
            return MadeFigures{{"error.mean_steps.warm", number == 7 ? fastest : number == 8 ? 0.1 : 1}};
        });
    return data;
}

ReportData kept(double share) {
    ReportData data;
    for (const int vertices : {8, 38, 386})
        add_angular(data, vertices, "vclip", [=](int) { return MadeFigures{{"work.unchanged", share}}; });
    return data;
}

ReportData proximity(double vclip) {
    ReportData data;
    for (const std::string& algorithm : both_algorithms) {
        for (const int vertices : {8, 38, 386}) {
            add_cell(data, {"paper_proximity", made_shape(vertices), algorithm},
                     made_time(algorithm == "vclip" ? vclip : 1));
            add_angular_time(data, vertices, algorithm, 1);
        }
    }
    return data;
}

/// Returns a function from the time at the largest size to report data; times at other sizes are 1.
std::function<ReportData(double)> growth(const std::vector<std::string>& algorithms,
                                         const std::vector<int>& sizes) {
    return [=](double most) {
        ReportData data;
        for (const std::string& algorithm : algorithms)
            for (const int vertices : sizes)
                add_angular_time(data, vertices, algorithm, vertices == sizes.back() ? most : 1);
        return data;
    };
}

ReportData erratic(double fall) {
    ReportData data;
    add_angular_time(data, 386, "gjk", 1);
    add_angular(data, 386, "vclip", [=](int number) { return made_time(number % 2 ? 1 : 1 / fall); });
    return data;
}

}  // namespace

std::vector<ClaimCase> speed_cases() {
    const auto slower = [](double vclip) { return angular(386)(1 / vclip); };
    return {
        {"simplest_bodies_fastest",
         [](double x) { return of_static([=](const std::string&, int n) { return n < 38 ? 1 : x; }); }, 2,
         0.5, 1},
        {"static_gjk_faster", static_gjk, 0.8, 1.2, 1},
        {"static_ratio", static_gjk, 1 / 1.16, 1, 1.1 / 1.16},
        {"linear_vclip_faster", linear, 1.3, 0.8, 1},
        {"angular_vclip_faster_8", angular(8), 1.3, 0.8, 1},
        {"angular_vclip_faster_38", angular(38), 1.3, 0.8, 1},
        {"angular_vclip_faster_386", angular(386), 1.3, 0.8, 1},
        {"times_comparable", comparable, 1.3, 3, 2},
        {"caching_favours_vclip", caching, 2, 0.5, 1},
        {"caching_favours_vclip_in_steps", caching, 2, 0.5},
        {"speed_costs_steps", speed, 2, 0.9},
        {"last_answer_kept", kept, 0.9, 0.1},
        {"proximity_divides", proximity, 2, 1.05, 1.25},
        {"both_scale_8_to_38", growth(both_algorithms, {8, 38}), 1.4, 3, 2},
        {"gjk_flat_to_386", growth({"gjk"}, {8, 38, 386}), 1.5, 4, 2},
        {"vclip_slower_at_386", slower, 2, 0.5, 1},
        {"vclip_rises_at_386", growth({"vclip"}, {38, 386}), 12, 2, 6},
        {"vclip_erratic_at_386", erratic, 2, 1, 1.2},
    };
}

}  // namespace edgewise::reports
