// SPDX-License-Identifier: MIT
//
// A machine's record, to be given to others: processor, caches, and time ratios of layouts with their
// intervals. It holds no absolute time, no name of a host, user or file, and nothing of bodies and scenes
// that do not come with Edgewise. Its cells are named "scene parameters shape algorithm table".
#pragma once

#include <string>
#include <string_view>

#include "edgewise/measure/cache/cache_machine.hpp"
#include "edgewise/measure/record/record.hpp"
#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

inline constexpr const char* machine_kind = "machine";
inline constexpr const char* ratio_figure = "time ratio";  ///< to the record's baseline

/// Throws std::runtime_error, one line, where nothing of the store was timed.
[[nodiscard]] measure::FigureRecord measured_record(const ReportData& data);

/// Of a machine whose caches the sweep modelled: modelled memory time over that of the same algorithm on
/// `modelled_baseline`. Throws std::runtime_error, one line, where the store has no such figures.
[[nodiscard]] measure::FigureRecord modelled_record(const ReportData& data,
                                                    const measure::CacheMachine& machine);
inline constexpr std::string_view modelled_baseline = "aos_f64";

}  // namespace edgewise::reports
