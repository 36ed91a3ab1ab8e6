// SPDX-License-Identifier: MIT
#include "edgewise/studies/campaign/tally.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace edgewise::studies::campaign {

namespace {

/// Every member that is a sum, by its name in files.
constexpr std::pair<const char*, std::uint64_t FamilyTally::*> family_sums[] = {
    {"blocks", &FamilyTally::blocks},
    {"pairs", &FamilyTally::pairs},
    {"refused_pairs", &FamilyTally::refused_pairs},
    {"separated", &FamilyTally::separated},
    {"touching", &FamilyTally::touching},
    {"overlapping", &FamilyTally::overlapping},
    {"grazing", &FamilyTally::grazing},
    {"double_proofs", &FamilyTally::double_proofs},
    {"wide_proofs", &FamilyTally::wide_proofs},
    {"exact_proofs", &FamilyTally::exact_proofs},
    {"answers", &FamilyTally::answers},
    {"refused", &FamilyTally::refused},
    {"in_band", &FamilyTally::in_band},
    {"exact_answers", &FamilyTally::exact_answers},
    {"wrong", &FamilyTally::wrong},
};
constexpr std::pair<const char*, double FamilyTally::*> family_seconds[] = {
    {"making_s", &FamilyTally::making_s},
    {"asking_s", &FamilyTally::asking_s},
    {"proving_s", &FamilyTally::proving_s},
};
constexpr std::pair<const char*, std::uint64_t CellTally::*> cell_sums[] = {
    {"answers", &CellTally::answers},
    {"refused", &CellTally::refused},
    {"in_band", &CellTally::in_band},
    {"wrong", &CellTally::wrong},
};

}  // namespace

void FamilyTally::add(const FamilyTally& other) {
    for (const auto& [name, member] : family_sums) this->*member += other.*member;
    for (const auto& [name, member] : family_seconds) this->*member += other.*member;
    const bool none =
        least_vertices == 0 || (other.least_vertices > 0 && other.least_vertices < least_vertices);
    if (none) least_vertices = other.least_vertices;
    most_vertices = std::max(most_vertices, other.most_vertices);
}

/// Adds sums. NaN counts as the worst error; of two equal worst errors the first pair is kept.
void CellTally::add(const CellTally& other) {
    for (const auto& [name, member] : cell_sums) this->*member += other.*member;
    const auto rank = [](double error) {
        return std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
    };
    const double mine = rank(worst_error), theirs = rank(other.worst_error);
    if (theirs > mine || (theirs == mine && theirs > 0 && other.worst_pair < worst_pair)) {
        worst_error = other.worst_error;
        worst_pair = other.worst_pair;
    }
}

void Tally::add(const Tally& other) {
    for (const auto& [name, tally] : other.families) families[name].add(tally);
    for (const auto& [name, tally] : other.cells) cells[name].add(tally);
}

FamilyTally Tally::all_families() const {
    FamilyTally all;
    for (const auto& [name, tally] : families) all.add(tally);
    return all;
}

nlohmann::json to_json(const Tally& tally) {
    nlohmann::json families = nlohmann::json::object(), cells = nlohmann::json::object();
    for (const auto& [name, family] : tally.families) {
        nlohmann::json& object = families[name];
        for (const auto& [key, member] : family_sums) object[key] = family.*member;
        for (const auto& [key, member] : family_seconds) object[key] = family.*member;
        object["least_vertices"] = family.least_vertices;
        object["most_vertices"] = family.most_vertices;
    }
    for (const auto& [name, cell] : tally.cells) {
        nlohmann::json& object = cells[name];
        for (const auto& [key, member] : cell_sums) object[key] = cell.*member;
        // JSON has no NaN and no infinity.
        object["worst_error"] =
            std::isfinite(cell.worst_error) ? nlohmann::json(cell.worst_error) : nlohmann::json();
        object["worst_pair"] = cell.worst_pair;
    }
    return {{"families", families}, {"cells", cells}};
}

Tally tally_of(const nlohmann::json& text) {
    Tally tally;
    for (const auto& [name, object] : text.at("families").items()) {
        FamilyTally& family = tally.families[name];
        for (const auto& [key, member] : family_sums) family.*member = object.at(key).get<std::uint64_t>();
        for (const auto& [key, member] : family_seconds) family.*member = object.at(key).get<double>();
        family.least_vertices = object.at("least_vertices").get<std::uint64_t>();
        family.most_vertices = object.at("most_vertices").get<std::uint64_t>();
    }
    for (const auto& [name, object] : text.at("cells").items()) {
        CellTally& cell = tally.cells[name];
        for (const auto& [key, member] : cell_sums) cell.*member = object.at(key).get<std::uint64_t>();
        const nlohmann::json& worst = object.at("worst_error");
        cell.worst_error = worst.is_null() ? std::numeric_limits<double>::quiet_NaN() : worst.get<double>();
        cell.worst_pair = object.at("worst_pair").get<std::uint64_t>();
    }
    return tally;
}

}  // namespace edgewise::studies::campaign
