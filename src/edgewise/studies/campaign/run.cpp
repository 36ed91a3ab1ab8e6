// SPDX-License-Identifier: MIT
#include "edgewise/studies/campaign/block_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "edgewise/input/file_text.hpp"
#include "edgewise/input/json_text.hpp"
#include "edgewise/input/known_names.hpp"
#include "edgewise/input/output_file.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/scene/case_text.hpp"
#include "edgewise/scene/minimise.hpp"
#include "edgewise/truth/exact_body.hpp"

namespace edgewise::studies::campaign {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(FamilyTally, blocks, pairs, refused_pairs, separated, touching,
                                   overlapping, grazing, double_proofs, wide_proofs, exact_proofs, answers,
                                   refused, in_band, exact_answers, wrong, making_s, asking_s, proving_s,
                                   least_vertices, most_vertices)
/// All but the worst error, which may be no number.
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CellTally, answers, refused, in_band, wrong, worst_pair)

namespace {

/// Every member that is a sum.
constexpr std::uint64_t FamilyTally::*family_sums[] = {
    &FamilyTally::blocks,       &FamilyTally::pairs,         &FamilyTally::refused_pairs,
    &FamilyTally::separated,    &FamilyTally::touching,      &FamilyTally::overlapping,
    &FamilyTally::grazing,      &FamilyTally::double_proofs, &FamilyTally::wide_proofs,
    &FamilyTally::exact_proofs, &FamilyTally::answers,       &FamilyTally::refused,
    &FamilyTally::in_band,      &FamilyTally::exact_answers, &FamilyTally::wrong};
constexpr double FamilyTally::*family_seconds[] = {&FamilyTally::making_s, &FamilyTally::asking_s,
                                                   &FamilyTally::proving_s};

}  // namespace

void FamilyTally::add(const FamilyTally& other) {
    for (const auto member : family_sums) this->*member += other.*member;
    for (const auto member : family_seconds) this->*member += other.*member;
    const bool none =
        least_vertices == 0 || (other.least_vertices > 0 && other.least_vertices < least_vertices);
    if (none) least_vertices = other.least_vertices;
    most_vertices = std::max(most_vertices, other.most_vertices);
}

/// Adds sums. NaN counts as the worst error; of two equal worst errors the first pair is kept.
void CellTally::add(const CellTally& other) {
    answers += other.answers;
    refused += other.refused;
    in_band += other.in_band;
    wrong += other.wrong;
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
    nlohmann::json cells = nlohmann::json::object();
    for (const auto& [name, cell] : tally.cells) {
        cells[name] = cell;
        // JSON has no NaN and no infinity.
        cells[name]["worst_error"] =
            std::isfinite(cell.worst_error) ? nlohmann::json(cell.worst_error) : nlohmann::json();
    }
    return {{"families", tally.families}, {"cells", cells}};
}

Tally tally_of(const nlohmann::json& text) {
    Tally tally;
    for (const auto& [name, object] : text.at("families").items()) object.get_to(tally.families[name]);
    for (const auto& [name, object] : text.at("cells").items()) {
        CellTally& cell = tally.cells[name];
        object.get_to(cell);
        const nlohmann::json& worst = object.at("worst_error");
        cell.worst_error = worst.is_null() ? std::numeric_limits<double>::quiet_NaN() : worst.get<double>();
    }
    return tally;
}

namespace {

constexpr int file_version = 2;

CampaignProgress progress_of(const nlohmann::json& object) {
    if (object.at("version").get<int>() != file_version) throw std::invalid_argument("of another version");
    CampaignProgress progress;
    Question& question = progress.question;
    question.seed = object.at("seed").get<std::uint64_t>();
    question.pairs = object.at("pairs_wanted").get<std::uint64_t>();
    question.families = object.at("families_in_turn").get<std::vector<std::string>>();
    question.cells = object.at("cells_asked").get<std::vector<std::string>>();
    const auto nothing = [](const char*) -> const char* { return nullptr; };
    question.shard = sweep::parse_shard(object.at("shard").get<std::string>(), nothing).or_throw();
    question.of = object.at("program_and_bodies").get<std::string>();
    progress.next_block = object.at("next_block").get<std::uint64_t>();
    progress.seconds = object.at("seconds").get<double>();
    progress.tally = tally_of(object);
    const nlohmann::json written = to_json(progress);
    std::vector<std::string> known;
    for (const auto& [name, value] : written.items()) known.push_back(name);
    if (const std::string unknown = input::unknown_member(object, "a state", known); !unknown.empty())
        throw std::invalid_argument(unknown);
    return progress;
}

}  // namespace

std::uint64_t CampaignProgress::pairs() const {
    const FamilyTally all = tally.all_families();
    return all.pairs + all.refused_pairs;
}

nlohmann::json to_json(const CampaignProgress& progress) {
    const Question& question = progress.question;
    nlohmann::json object = to_json(progress.tally);
    object["version"] = file_version;
    object["seed"] = question.seed;
    object["pairs_wanted"] = question.pairs;
    object["families_in_turn"] = question.families;
    object["cells_asked"] = question.cells;
    object["shard"] = question.shard.text();
    object["program_and_bodies"] = question.of;
    object["next_block"] = progress.next_block;
    object["seconds"] = progress.seconds;
    return object;
}

void write_progress(const CampaignProgress& progress, const std::string& path) {
    input::write_output(path, to_json(progress).dump(1) + "\n");
}

std::optional<CampaignProgress> read_progress(const std::string& path) {
    if (!std::filesystem::exists(path)) return std::nullopt;
    const std::string text = input::read_file_text(path).or_throw();
    try {
        return progress_of(input::parse_json(text).or_throw());
    } catch (const std::exception& problem) {
        throw std::invalid_argument(
            fmt::format("{}: no progress of a campaign ({}); name another file with --state, or remove it",
                        path, without_controls(problem.what())));
    }
}

bool run_campaign(const PairSource& source, std::span<const Cell> cells, CampaignProgress& progress,
                  const CampaignHooks& hooks, const std::atomic<bool>& stop) {
    BlockRun blocks(cells);
    const Question& question = progress.question;
    const std::uint64_t first = question.shard.first_of(question.blocks());
    progress.next_block = std::max(progress.next_block, first);
    while (!progress.is_done()) {
        if (stop) return false;
        const measure::Stopwatch watch;
        const std::uint64_t block = progress.next_block;
        blocks.run(source, block, question.pairs_of(block), progress.tally, hooks.on_failure);
        ++progress.next_block;
        progress.seconds += watch.elapsed_ns() / 1e9;
        hooks.on_block(progress);
    }
    return true;
}

CampaignProgress added_up(std::span<const CampaignProgress> parts) {
    if (parts.empty())
        throw std::invalid_argument("no parts of a campaign; name the files that --state wrote");
    CampaignProgress whole;
    whole.question = parts.front().question;
    whole.question.shard = {};
    whole.next_block = whole.question.blocks();
    std::set<std::uint64_t> seen;
    for (const CampaignProgress& part : parts) {
        const sweep::Shard& shard = part.question.shard;
        Question same = parts.front().question;
        same.shard = shard;
        if (part.question != same || shard.count != parts.front().question.shard.count)
            throw std::invalid_argument(
                "parts of different campaigns: seed, pairs, families, bodies, cells, program or shards differ");
        if (!seen.insert(shard.index).second)
            throw std::invalid_argument("shard " + shard.text() + " comes twice");
        whole.tally.add(part.tally);
        whole.seconds += part.seconds;
        if (!part.is_done()) whole.next_block = 0;
    }
    if (seen.size() < parts.front().question.shard.count) whole.next_block = 0;
    return whole;
}

namespace {

/// Returns an identifier like "wrong_distance_of_vclip_aos_f32_in_grazing".
std::string id_of(const Failure& failure) {
    std::string id =
        failure.what.substr(0, failure.what.find(':')) + " of " + failure.cell + " in " + failure.family;
    std::ranges::replace(id, ' ', '_');
    return id;
}

}  // namespace

scene::Case case_of(const PairSource& source, std::uint64_t pair) {
    const PairPlace place = PairPlace::of(pair);
    const Block block = source.block(place.block, place.number + 1);
    scene::Case result{fmt::format("pair {}", pair), block.case_a, block.case_b, {}, {}};
    if (block.refusal.empty()) std::tie(result.pose_a, result.pose_b) = block.poses[place.number];
    return result;
}

std::string what_is_wrong(const scene::Case& of, const Cell& cell) {
    Block block;
    auto a = scene::body_from_case(of.a), b = scene::body_from_case(of.b);
    if (!a || !b) return {};
    block.a = std::move(*a);
    block.b = std::move(*b);
    block.poses = {{of.pose_a, of.pose_b}};
    if (!truth::pair_error(block.a.vertices, of.pose_a, block.b.vertices, of.pose_b).empty()) return {};
    const scene::Workload workload = workload_of(block);
    const auto asker = cell.make_asker();
    if (!asker->load(workload).empty()) return {};
    const auto stored = asker->stored_bodies();
    truth::StoredPair pair(stored[0].vertices, stored[1].vertices);
    truth::ProvenPair known = pair.know(block.poses[0], Vec3d::Zero());
    const Distance answer = asker->answer().front();
    if (answer.status == Status::failed) return {};
    const truth::CheckedAnswer checked =
        check_answer(answer, cell, asker->margin(), pair, block.poses[0], known);
    return what_is_wrong(checked, answer, pair, block.poses[0], known);
}

std::string failing_line(const PairSource& source, const Failure& failure, const Cell& cell) {
    const scene::Case given = case_of(source, failure.pair);
    scene::Case small = scene::minimise(given, [&](const scene::Case& tried) {
                            return !what_is_wrong(tried, cell).empty();
                        }).pair;
    small.id = id_of(failure);
    const std::string still = what_is_wrong(small, cell);
    return scene::case_line(small,
                            fmt::format("campaign, pair {}, {}: {}", failure.pair, failure.cell,
                                        still.empty() ? failure.what + " (not seen again alone)" : still));
}

}  // namespace edgewise::studies::campaign
