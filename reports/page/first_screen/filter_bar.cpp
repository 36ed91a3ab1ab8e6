// SPDX-License-Identifier: MIT
#include "edgewise/reports/page/first_screen/filter_bar.hpp"

#include <fmt/core.h>

#include <set>

#include "edgewise/reports/answer/ranking.hpp"
#include "edgewise/reports/page/html.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/reports/text/report_text.hpp"

namespace edgewise::reports {

namespace {

std::string scene_options(const ReportData& data) {
    std::string options = html_option("", "all", true);
    for (const std::string& label : scene_labels(data)) options += html_option(label, label);
    return options;
}

std::string shape_options(const ReportData& data) {
    std::string options = html_option("", "all", true);
    for (const auto& [vertices, shape] : shapes_by_vertices(data))
        options += html_option(shape, fmt::format("{} ({})", vertices, shape));
    return options;
}

std::string algorithm_options(const ReportData& data) {
    std::string options = html_option("", "all", true);
    std::set<std::string> algorithms;
    for (const ReportCell* cell : data.swept()) algorithms.insert(cell->algorithm);
    for (const std::string& algorithm : algorithms)
        options += html_option(algorithm, algorithm_title(algorithm));
    return options;
}

std::string precision_options(const ReportData& data) {
    std::string options = html_option("", "all", true);
    std::set<std::string> precisions;
    for (const ReportCell* cell : data.swept()) precisions.insert(cell->precision);
    for (const std::string& precision : precisions) options += html_option(precision, precision);
    return options;
}

}  // namespace

std::string filter_bar_html(const ReportData& data) {
    return fmt::format(
        fmt::runtime(report_text("page.filter.html")),
        fmt::arg("scene", html_select("filter-scene", "scene", scene_options(data))),
        fmt::arg("shape", html_select("filter-shape", "vertices", shape_options(data))),
        fmt::arg("algorithm", html_select("filter-algorithm", "algorithm", algorithm_options(data))),
        fmt::arg("precision", html_select("filter-precision", "precision", precision_options(data))));
}

}  // namespace edgewise::reports
