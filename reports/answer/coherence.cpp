// SPDX-License-Identifier: MIT
#include "edgewise/reports/answer/coherence.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "edgewise/reports/answer/scene_words.hpp"
#include "edgewise/reports/scene_label.hpp"

namespace edgewise::reports {

namespace {

constexpr double classes_per_decade = 2;

/// Returns the nearest power of the root of ten: 0.001, 0.0032, 0.01 ...
double class_of(double turn) {
    return std::pow(10, std::round(classes_per_decade * std::log10(turn)) / classes_per_decade);
}

}  // namespace

std::string Coherence::text() const {
    if (start == Start::fresh) return kind + ", every pair new";
    if (start == Start::random) return kind + ", random turns";
    return turn == 0 ? kind + ", no turn" : fmt::format("{}, {:.1g} rad", kind, turn);
}

std::optional<Coherence> coherence_of(const ReportCell& cell) {
    const std::string kind = scene_kind(cell);
    if (kind == "static" || kind == "cold" || kind == "gap")
        return Coherence{Coherence::Start::fresh, 0, kind};
    if (parameter_of(cell, "random_orientation") == 1) return Coherence{Coherence::Start::random, 0, kind};
    const auto turn = parameter_of(cell, "rotation_step");
    if (!turn || !(*turn >= 0)) return std::nullopt;
    return Coherence{Coherence::Start::turned, *turn == 0 ? 0 : class_of(*turn), kind};
}

double distance_from_class(const ReportCell& cell, const Coherence& coherence) {
    if (coherence.turn == 0) return 1;
    const double turn = parameter_of(cell, "rotation_step").value_or(coherence.turn);
    return std::max(turn / coherence.turn, coherence.turn / turn);
}

std::optional<int> tables_class(const ReportCell& cell) {
    if (!has_own_tables(cell)) return -1;
    const auto bodies = parameter_of(cell, "bodies");
    if (!bodies || !(*bodies >= 1)) return std::nullopt;
    int power = 0;
    for (double next = 10; *bodies >= next; next *= 10) ++power;
    return power;
}

std::string tables_class_text(int of) {
    if (of < 0) return "one shared table";
    const double first = std::pow(10, of);
    return fmt::format("{:.0f} to {:.0f} tables", of == 0 ? 2 : first, 10 * first - 1);
}

}  // namespace edgewise::reports
