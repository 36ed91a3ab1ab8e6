// SPDX-License-Identifier: MIT
//
// Rows of the study of figure 8 in the store (studies/thrash): which combinations of what the paper leaves
// open give the four facts that the figure states, and the cells that were made real.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "edgewise/reports/reader.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

/// The only processor with every setting in the store.
inline constexpr const char* region_machine = "pentium2_deschutes";

/// Which facts hold, as thrash.facts adds them.
inline constexpr unsigned rises = 1, takes_as_long = 2, spares_gjk = 4, erratic = 8;
inline constexpr unsigned all_but_erratic = rises | takes_as_long | spares_gjk, all_facts = 15;

struct ScoredSetting {
    double bodies = 0, memory_mib = 0, fault_ns = 0;
    unsigned facts = 0;

    [[nodiscard]] bool has(unsigned wanted) const { return (facts & wanted) == wanted; }
};

/// A row of the factorial.
struct ThrashRow {
    const ReportCell* cell = nullptr;
    std::string mechanism, machine;
    double intensity = 0, time_step = 0;
    bool own_tables = false;
    std::vector<ScoredSetting> settings;  ///< of the region's machine alone

    [[nodiscard]] std::size_t count(unsigned wanted) const;
    /// "whole table transform", "builds 0.01".
    [[nodiscard]] std::string name() const;
    /// "aos_f64, own tables, steps of 1/60 s".
    [[nodiscard]] std::string tables() const;
};
[[nodiscard]] std::vector<ThrashRow> thrash_rows(const ReportData& data);

/// A curve of a cell made real.
struct RealisedRow {
    const ReportCell* cell = nullptr;
    int number = 0;
    std::string what;  ///< "1: 200 bodies, 24 MiB, 4000 us a fault; aos_f64, ..."
    struct Point {
        double speed, measured_us, predicted_us;
        std::optional<double> measured_faults, predicted_faults, model_us;
    };
    std::vector<Point> points;

    [[nodiscard]] double longest_measured() const;
    /// Returns the larger ratio of measured and predicted, in either direction.
    [[nodiscard]] double worst_ratio() const;
};
[[nodiscard]] std::vector<RealisedRow> realised_rows(const ReportData& data);

/// What can be said of figure 8: which mechanisms can make it, which cannot, which the paper's words favour,
/// and what remains unknown. Empty where the study was not run.
[[nodiscard]] std::string settled_paragraph(const ReportData& data);

[[nodiscard]] TextGrid mechanism_grid(const ReportData& data);
[[nodiscard]] TextGrid realised_grid(const ReportData& data);

}  // namespace edgewise::reports
