// SPDX-License-Identifier: MIT
#include "edgewise/reports/answer/gaps.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

namespace edgewise::reports {

namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Returns "# cases at #e-#" for "3 cases at 1e-6", so that reasons that differ in numbers are equal.
std::string without_numbers(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (!is_digit(c) && !(c == '.' && !out.empty() && out.back() == '#'))
            out += c;
        else if (out.empty() || out.back() != '#')
            out += '#';
    }
    return out;
}

struct Found {
    Gap gap;
    std::set<std::string> probes, reasons;
};

}  // namespace

Gaps gaps_of(const ReportData& data) {
    Gaps all;
    std::map<std::pair<std::string, std::string>, Found> found;
    for (const auto* cells : {&data.cells, &data.from_files, &data.stability, &data.paging, &data.thrash,
                              &data.effort, &data.fields, &data.other_studies, &data.peers}) {
        for (const ReportCell& cell : *cells) {
            for (const store::FigureRow& figure : cell.figures) {
                ++(figure.value ? all.measured : all.missing);
                if (figure.value) continue;
                Found& one = found[{without_numbers(figure.reason), without_numbers(figure.remedy)}];
                if (one.gap.figures++ == 0) one.gap.remedy = figure.remedy, one.gap.reason = figure.reason;
                one.probes.insert(figure.probe);
                one.reasons.insert(figure.reason);
            }
        }
    }
    for (auto& [key, one] : found) {
        if (one.reasons.size() > 1) one.gap.reason = key.first, one.gap.remedy = key.second;
        one.gap.probes.assign(one.probes.begin(), one.probes.end());
        all.gaps.push_back(std::move(one.gap));
    }
    std::stable_sort(all.gaps.begin(), all.gaps.end(),
                     [](const Gap& a, const Gap& b) { return a.figures > b.figures; });
    return all;
}

}  // namespace edgewise::reports
