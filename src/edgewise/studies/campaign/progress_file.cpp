// SPDX-License-Identifier: MIT
#include "edgewise/studies/campaign/progress_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "edgewise/input/file_text.hpp"
#include "edgewise/input/json_text.hpp"
#include "edgewise/input/known_names.hpp"
#include "edgewise/input/output_file.hpp"
#include "edgewise/studies/campaign/pair_source.hpp"

namespace edgewise::studies::campaign {

namespace {

constexpr int file_version = 1;

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

std::uint64_t Question::blocks() const { return (pairs + pairs_per_block - 1) / pairs_per_block; }

std::uint64_t Question::pairs_of(std::uint64_t block) const {
    return std::min(pairs_per_block, pairs - block * pairs_per_block);
}

bool Question::is_part_of_same(const Question& other) const {
    Question mine = *this;
    mine.shard = other.shard;
    return mine == other;
}

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

}  // namespace edgewise::studies::campaign
