// SPDX-License-Identifier: MIT
#include "edgewise/cli/parts/figures_of_merit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "edgewise/store/rows.hpp"

namespace edgewise::cli {

namespace {

/// Adds up logarithms.
struct GeometricMean {
    double sum = 0;
    std::size_t count = 0;
};

double total(const store::StoredBuild& stored, const store::FigureName& name) {
    double sum = 0;
    for (const store::StoredCell& cell : stored.cells) sum += cell.figure(name).value.value_or(0);
    return sum;
}

std::size_t cells_that_are(const store::StoredBuild& stored, store::CellStatus status) {
    return static_cast<std::size_t>(std::ranges::count_if(
        stored.cells, [&](const store::StoredCell& cell) { return cell.status == status; }));
}

}  // namespace

void print_figures_of_merit(const std::string& store) {
    const store::StoredBuild stored = store::read_build(store);
    fmt::print("FOM cells_verified = {} cells\n", cells_that_are(stored, store::CellStatus::verified));
    fmt::print("FOM cells_failed = {} cells\n", cells_that_are(stored, store::CellStatus::failed));
    fmt::print("FOM answers_checked = {:.0f} queries\n",
               total(stored, "error.checked") + total(stored, "stability.cases"));
    fmt::print("FOM answers_wrong = {:.0f} queries\n",
               total(stored, "error.wrong_answers") + total(stored, "stability.wrong_answers"));
    std::map<std::string, GeometricMean> ratios;
    for (const store::StoredCell& cell : stored.cells) {
        const auto ratio = cell.figure("time.all_ratio").value;
        if (!cell.verified() || !cell.axes.empty() || !ratio || !(*ratio > 0)) continue;
        GeometricMean& mean = ratios[cell.algorithm + "." + cell.table];
        mean.sum += std::log(*ratio);
        ++mean.count;
    }
    for (const auto& [name, mean] : ratios)
        fmt::print("FOM time_ratio.{} = {:.4f} 1\n", name,
                   std::exp(mean.sum / static_cast<double>(mean.count)));
}

}  // namespace edgewise::cli
