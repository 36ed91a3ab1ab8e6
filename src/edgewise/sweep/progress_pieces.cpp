// SPDX-License-Identifier: MIT
#include "edgewise/sweep/progress_pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "edgewise/input/json_text.hpp"
#include "edgewise/store/schema.hpp"

namespace edgewise::sweep {

namespace {

/// Among the seconds that a store keeps: reports leave these keys out, and no run is called so.
std::string key_start() { return std::string(store::took_key) + "progress "; }

void keep_worse(ProgressDeviation& worst, double shown, double truth) {
    const double relative = shown / truth - 1;
    if (std::abs(relative) > std::abs(worst.relative)) worst = {truth, relative};
}

}  // namespace

std::string progress_key(std::size_t place, const std::string& name) {
    return fmt::format("{}{:06} {}", key_start(), place, name);
}

std::string progress_value(std::span<const ProgressPiece> pieces) {
    nlohmann::json json = nlohmann::json::array();
    for (const ProgressPiece& piece : pieces) json.push_back({piece.what, piece.expected, piece.took});
    return input::json_text(json);
}

std::vector<ProgressPiece> progress_pieces(std::span<const std::pair<std::string, std::string>> meta) {
    std::vector<ProgressPiece> pieces;
    for (const auto& [key, value] : meta) {
        if (!key.starts_with(key_start())) continue;
        const auto json = input::json_or_null(value);
        for (const auto& piece : json) {
            if (!piece.is_array() || piece.size() != 3 || !piece[0].is_string() || !piece[1].is_number() ||
                !piece[2].is_number())
                continue;
            const std::size_t name = key.find(' ', key_start().size()) + 1;
            pieces.push_back({key.substr(name) + ": " + piece[0].get<std::string>(), piece[1].get<double>(),
                              piece[2].get<double>()});
        }
    }
    return pieces;
}

ProgressDeviation worst_deviation(std::span<const ProgressPiece> pieces, double from) {
    double all_expected = 0, all_took = 0;
    for (const ProgressPiece& piece : pieces) {
        all_expected += piece.expected;
        all_took += piece.took;
    }
    ProgressDeviation worst;
    if (!(all_took > 0 && all_expected > 0)) return worst;
    double shown = 0, truth = 0;
    for (const ProgressPiece& piece : pieces) {
        const double next_shown = shown + piece.expected / all_expected,
                     next_truth = truth + piece.took / all_took;
        if (truth < from && next_truth > from)
            keep_worse(worst, shown + (next_shown - shown) * (from - truth) / (next_truth - truth), from);
        if (next_truth >= from) keep_worse(worst, next_shown, next_truth);
        shown = next_shown;
        truth = next_truth;
    }
    return worst;
}

}  // namespace edgewise::sweep
