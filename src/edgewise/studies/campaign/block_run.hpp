// SPDX-License-Identifier: MIT
//
// Runs one block of pairs through every cell: asks, proves and tallies. Every pair is asked twice: cold, and
// warm, in time order, with the pair's cache kept from pose to pose.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "edgewise/algorithms/distance.hpp"
#include "edgewise/bench/registry.hpp"
#include "edgewise/scene/case_file.hpp"
#include "edgewise/scene/workload.hpp"
#include "edgewise/studies/campaign/pair_source.hpp"
#include "edgewise/sweep/shard.hpp"
#include "edgewise/truth/checked_answer.hpp"

namespace edgewise::studies::campaign {

// The cells of a campaign: an algorithm on a table type, one of each class of equal answers, in all its ways
// (query_kinds). Most table types give the same bits as another (shared arithmetic, other memory); the
// program compares its own answers, over pairs of every family, to find which do.

/// Answers the queries of a cell. The tests have one that gives wrong answers on purpose.
class Asker {
  public:
    Asker() = default;
    Asker(const Asker&) = delete;
    Asker& operator=(const Asker&) = delete;
    virtual ~Asker() = default;

    /// Returns an error line if the bodies cannot be stored, else "". The workload must outlive the queries.
    [[nodiscard]] virtual std::string load(const scene::Workload& workload) = 0;
    /// Answers every query of the workload: from cold, or warm where the workload says so.
    [[nodiscard]] virtual std::vector<Distance> answer() = 0;
    [[nodiscard]] virtual std::span<const Polyhedron> stored_bodies() const = 0;
    /// Sum of the loaded bodies' radii, or the margin within which their distance is asked; empty:
    /// neither. It may be 0, of two points.
    [[nodiscard]] virtual std::optional<double> margin() const { return std::nullopt; }
};

struct Cell {
    std::string name;           ///< "gjk aos_f64", "gjk aos_f64 johnson"
    double eps = 0;             ///< rounding step of the arithmetic
    double error_allowed = 0;   ///< over scale, beyond the band
    bool verdict_only = false;  ///< its distances are bounds, and not checked
    bool rounded = false;       ///< its distances count from the margin on
    std::function<std::unique_ptr<Asker>()> make_asker;
    std::vector<std::string> as_well{};  ///< cells with the same answers
};

/// Returns every algorithm on every table type that supports it, in each of its ways.
[[nodiscard]] std::vector<Cell> cells_of(std::span<const bench::TableType* const> types,
                                         std::span<const std::string> algorithms);

/// Returns the first cell of each class of equal answers (status, distance, witness points, normal).
[[nodiscard]] std::vector<Cell> one_of_each_class(std::vector<Cell> cells);

/// Checks an answer against the exact one. `margin`: Asker::margin.
[[nodiscard]] truth::CheckedAnswer check_answer(const Distance& answer, const Cell& cell,
                                                std::optional<double> margin, const truth::StoredPair& stored,
                                                const truth::PosesOfPair& poses, truth::ProvenPair& known);

/// Returns what is wrong with the answer; empty if it is right.
[[nodiscard]] std::string what_is_wrong(const truth::CheckedAnswer& checked, const Distance& answer,
                                        const truth::StoredPair& stored, const truth::PosesOfPair& poses,
                                        truth::ProvenPair& known);

// What a campaign keeps of its pairs: sums and worst cases, by family and by cell. Two parts of a campaign
// add up to the whole in every figure but seconds.

/// Tally of one family. Pairs are counted once, proofs once for each storage that holds other bodies,
/// answers once for each cell.
struct FamilyTally {
    std::uint64_t blocks = 0, pairs = 0;
    std::uint64_t refused_pairs = 0;                      ///< of bodies that no table holds
    std::uint64_t least_vertices = 0, most_vertices = 0;  ///< of either body
    /// Pairs, as the first storage holds them; grazing: of unknown verdict, within the band in double.
    std::uint64_t separated = 0, touching = 0, overlapping = 0, grazing = 0;
    std::uint64_t double_proofs = 0, wide_proofs = 0, exact_proofs = 0;
    std::uint64_t answers = 0, refused = 0, in_band = 0;
    std::uint64_t exact_answers = 0;  ///< answers that needed exact arithmetic
    std::uint64_t wrong = 0;
    double making_s = 0, asking_s = 0, proving_s = 0;  ///< processor time

    void add(const FamilyTally& other);
};

struct CellTally {
    std::uint64_t answers = 0, refused = 0, in_band = 0, wrong = 0;
    double worst_error = 0;        ///< bound of the error over scale, beyond the band
    std::uint64_t worst_pair = 0;  ///< the first with that error

    void add(const CellTally& other);
};

struct Tally {
    std::map<std::string, FamilyTally> families;
    std::map<std::string, CellTally> cells;

    void add(const Tally& other);
    [[nodiscard]] FamilyTally all_families() const;
};

[[nodiscard]] nlohmann::json to_json(const Tally& tally);
/// Reads a tally. Throws nlohmann::json::exception if the JSON is not one.
[[nodiscard]] Tally tally_of(const nlohmann::json& json);

/// A wrong answer and where to find it again.
struct Failure {
    std::uint64_t pair = 0;
    std::string cell, family, what;
};

/// Bodies that some cells store with equal values, and the exact answers known for their pairs.
struct BlockStorage {
    std::span<const Polyhedron> bodies;
    truth::StoredPair pair;
    std::vector<truth::ProvenPair> known;
    bool counts = false;  ///< the first: its pairs are counted by verdict
};

/// A cell's two askers: one for cold pairs, one for warm ones.
struct ColdAndWarm {
    std::unique_ptr<Asker> cold, warm;
};

class BlockRun {
  public:
    /// Keeps the cells.
    explicit BlockRun(std::span<const Cell> cells);

    /// Adds the first `count` pairs of a block to the tally; reports every wrong answer.
    void run(const PairSource& source, std::uint64_t block, std::uint64_t count, Tally& tally,
             const std::function<void(const Failure&)>& on_failure);

  private:
    void load(const scene::Workload& cold, const scene::Workload& warm);
    [[nodiscard]] std::size_t storage_of(std::span<const Polyhedron> stored);
    void ask(std::size_t cell, bool warm, const Block& block, FamilyTally& family, CellTally& tally);

    std::span<const Cell> cells_;
    std::vector<ColdAndWarm> askers_;
    std::vector<std::string> refusals_;  ///< by cell: why it cannot hold the block's bodies
    std::vector<BlockStorage> storages_;
    std::vector<std::size_t> storage_;  ///< by cell
    std::vector<Failure> failures_;
    std::uint64_t block_ = 0;
};

// Runs a campaign of any number of pairs, block after block, from the place where its file says it stopped.
//
// How far a campaign is: its question, the next block, and the tally. A JSON file of some kilobytes for any
// number of pairs. It is written to a temporary file and renamed, so that it is whole at any moment.

/// Decides the pairs and the cells of a campaign. Parts of one campaign differ only in the shard.
struct Question {
    std::uint64_t seed = 1, pairs = 0;
    std::vector<std::string> families;  ///< in turn
    std::vector<std::string> cells;
    sweep::Shard shard;
    std::string of = {};  ///< the program's revision, and a print of the named bodies

    [[nodiscard]] std::uint64_t blocks() const { return (pairs + pairs_per_block - 1) / pairs_per_block; }
    /// Returns how many pairs of a block are asked; the last block may have fewer.
    [[nodiscard]] std::uint64_t pairs_of(std::uint64_t block) const {
        return std::min(pairs_per_block, pairs - block * pairs_per_block);
    }
    [[nodiscard]] bool operator==(const Question&) const = default;
};

struct CampaignProgress {
    Question question;
    std::uint64_t next_block = 0;
    double seconds = 0;  ///< of running so far
    Tally tally;

    [[nodiscard]] bool is_done() const { return next_block >= question.shard.last_of(question.blocks()); }
    /// Returns the number of pairs asked so far.
    [[nodiscard]] std::uint64_t pairs() const;
};

void write_progress(const CampaignProgress& progress, const std::string& path);

/// Returns nothing if there is no file; throws std::invalid_argument, one line, if it is no progress file.
[[nodiscard]] std::optional<CampaignProgress> read_progress(const std::string& path);

[[nodiscard]] nlohmann::json to_json(const CampaignProgress& progress);

struct CampaignHooks {
    std::function<void(const CampaignProgress&)> on_block = [](const CampaignProgress&) {};
    std::function<void(const Failure&)> on_failure = [](const Failure&) {};
};

/// Goes on until the shard is done or `stop` is set; returns false if `stop` came first.
bool run_campaign(const PairSource& source, std::span<const Cell> cells, CampaignProgress& progress,
                  const CampaignHooks& hooks, const std::atomic<bool>& stop);

/// Adds up parts of one campaign. Throws std::invalid_argument, one line, for parts of different campaigns
/// and for a shard that comes twice.
[[nodiscard]] CampaignProgress added_up(std::span<const CampaignProgress> parts);

// Writes a wrong answer as a line of a case file, which the corpus takes and `edgewise query` answers.

/// Returns the pair as its source made it.
[[nodiscard]] scene::Case case_of(const PairSource& source, std::uint64_t pair);

/// Returns why the cell's answer to the case is wrong; empty if it is right or there is none.
[[nodiscard]] std::string what_is_wrong(const scene::Case& of, const Cell& cell);

/// Minimises the failing pair; returns a line that says which answer to which pair was wrong, and how.
[[nodiscard]] std::string failing_line(const PairSource& source, const Failure& failure, const Cell& cell);

}  // namespace edgewise::studies::campaign
