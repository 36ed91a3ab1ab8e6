// SPDX-License-Identifier: MIT
//
// `edgewise campaign`: random and hard pairs through every class of answers, each proven right or wrong.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/cli/options.hpp"
#include "edgewise/cli/terminal/progress.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/reports/tables/text_grid.hpp"
#include "edgewise/scene/case_text.hpp"
#include "edgewise/scene/mesh/mesh_file.hpp"
#include "edgewise/studies/campaign/block_run.hpp"

namespace edgewise::cli {

namespace {

using namespace studies::campaign;

double per(double of, double by) { return by > 0 ? of / by : 0; }

double count(std::uint64_t n) { return static_cast<double>(n); }

/// "3.214 M"
std::string rate(double per_second) {
    if (per_second >= 1e6) return fmt::format("{:.3f} M", per_second * 1e-6);
    return fmt::format("{:.1f} k", per_second * 1e-3);
}

std::uint64_t proofs_of(const FamilyTally& family) {
    return family.double_proofs + family.wide_proofs + family.exact_proofs;
}

std::string vertices_of(const FamilyTally& family) {
    if (family.least_vertices == family.most_vertices) return fmt::format("{}", family.most_vertices);
    return fmt::format("{} to {}", family.least_vertices, family.most_vertices);
}

void add_family(reports::TextGrid& grid, const std::string& name, const FamilyTally& family) {
    const double pairs = count(family.pairs), seconds = family.making_s + family.asking_s + family.proving_s;
    const auto share = [&](std::uint64_t n) {
        return fmt::format("{:.3f}", 100 * per(count(n), count(proofs_of(family))));
    };
    const auto part = [&](std::uint64_t n) { return fmt::format("{:.2f}", 100 * per(count(n), pairs)); };
    grid.add(name, vertices_of(family), family.pairs, rate(per(pairs, seconds)),
             rate(per(count(family.answers), seconds)), share(family.double_proofs),
             share(family.wide_proofs), share(family.exact_proofs), part(family.separated),
             part(family.grazing), part(family.touching), part(family.overlapping), family.exact_answers,
             family.wrong);
}

void print_families(const CampaignProgress& progress) {
    reports::TextGrid grid{
        "", reports::columns_of("family|#vertices|#pairs|#pairs/s|#answers/s|#double %|#wide %|#exact %|"
                                "#sep. %|#gra. %|#tou. %|#ove. %|#exact ans.|#wrong")};
    for (const auto& [name, family] : progress.tally.families) add_family(grid, name, family);
    add_family(grid, "all", progress.tally.all_families());
    fmt::print("{}\n", grid_text(grid));
}

void print_cells(const CampaignProgress& progress, std::span<const Cell> cells) {
    reports::TextGrid grid{
        "", reports::columns_of("cell|#answers|#refused|#in band|#wrong|#worst error|#in pair|" +
                                std::string(cells.empty() ? " " : "cells with equal answers"))};
    for (const auto& [name, cell] : progress.tally.cells) {
        const auto found = std::ranges::find(cells, name, &Cell::name);
        const std::size_t alike = found == cells.end() ? 0 : found->as_well.size();
        grid.add(name, cell.answers, cell.refused, cell.in_band, cell.wrong,
                 fmt::format("{:.3g}", cell.worst_error), cell.worst_pair,
                 alike == 0 ? "" : fmt::format("+{}", alike));
    }
    fmt::print("{}", grid_text(grid));
}

/// Prints a row per family and a row per cell. Without `cells` it does not count cells with equal answers.
void print_campaign(const CampaignProgress& progress, std::span<const Cell> cells, const std::string& state) {
    print_families(progress);
    print_cells(progress, cells);
    const FamilyTally all = progress.tally.all_families();
    fmt::print(
        "\n{} of {} pairs of shard {}, {} answers in {:.1f} s: {}\nRates are of one thread, for making the pairs, "
        "asking every cell and proving the answers.\ndouble, wide, exact: share of distances proven in double "
        "precision, in wider arithmetic, and exactly.\nsep., gra., tou., ove.: share of pairs that are separated, "
        "grazing (nearer to contact than the error band, so the verdict is not checked), touching, "
        "overlapping.\nworst error: an upper bound, beyond the error band, divided by the scale.\nstate: {}{}\n",
        progress.pairs(), progress.question.pairs, progress.question.shard.text(), all.answers,
        progress.seconds, all.answers == 0 ? "nothing was compared" : fmt::format("{} wrong", all.wrong),
        state, progress.is_done() ? "" : "; not done: the same command goes on from it");
}

nlohmann::json campaign_json(const CampaignProgress& progress, std::span<const Cell> cells) {
    nlohmann::json line = to_json(progress);
    const FamilyTally all = progress.tally.all_families();
    line["done"] = progress.is_done();
    line["pairs"] = progress.pairs();
    line["answers"] = all.answers;
    line["wrong"] = all.wrong;
    line["share_by_filter"] = per(count(all.double_proofs + all.wide_proofs), count(proofs_of(all)));
    line["pairs_per_second"] = per(count(progress.pairs()), progress.seconds);
    line["answers_per_second"] = per(count(all.answers), progress.seconds);
    for (const Cell& cell : cells) line["classes"][cell.name] = cell.as_well;
    return line;
}

/// Between two writes of the progress file, and of failures that are minimised per cell: the first tell most.
constexpr double seconds_between_writes = 10;
constexpr int most_minimised = 3;

struct CampaignArguments {
    double pairs = 1e6;
    std::uint64_t seed = 1;
    std::string shard;
    std::vector<std::string> families, shapes;
    std::vector<std::string> layouts = {"all"}, algorithms = {"all"};
    bool every_type = false, as_stored = false;
    std::string state = "reports/out/campaign.json", failures = "reports/out/campaign_failures.jsonl";
    std::vector<std::string> add;
    std::optional<std::uint64_t> pair;
};

std::vector<Cell> chosen_cells(const CampaignArguments& options) {
    const auto types = bench::select_table_types(options.layouts);
    const auto algorithms = bench::select_algorithms(options.algorithms);
    std::vector<Cell> cells = cells_of(types, algorithms);
    if (cells.empty()) throw std::invalid_argument("none of these layouts serves any of these algorithms");
    return options.every_type ? cells : one_of_each_class(std::move(cells));
}

Question question_of(const CampaignArguments& options, const sweep::Shard& shard, const PairSource& source,
                     const std::vector<Cell>& cells) {
    Question question{options.seed, static_cast<std::uint64_t>(options.pairs), source.families(), {}, shard};
    for (const Cell& cell : cells) question.cells.push_back(cell.name);
    question.of = fmt::format("{} {}", bench::git_revision(), source.print());
    return question;
}

/// From the file, if it is about the same question; more pairs than before may be wanted of it.
CampaignProgress start_of(const Question& question, const std::string& path) {
    auto known = read_progress(path);
    if (!known) return {question, 0, 0, {}};
    const bool whole = question.shard.is_whole();
    const std::uint64_t wanted_before = known->question.pairs;
    if (whole && question.pairs >= wanted_before && wanted_before % pairs_per_block == 0)
        known->question.pairs = question.pairs;
    if (known->question != question)
        throw std::invalid_argument(fmt::format(
            "{}: progress of a campaign of another program, or with another seed, shard, number of pairs, bodies, "
            "families or cells; name another file with --state, or remove it",
            path));
    if (known->next_block == 0 && known->pairs() > 0)
        throw std::invalid_argument(path +
                                    ": a sum of parts that are not all there: finish and --add them all");
    return *known;
}

/// Prints, minimises and writes down what is wrong.
class FailureLog {
  public:
    FailureLog(const PairSource& source, std::span<const Cell> cells, std::string path, Progress& progress)
        : source_(source), cells_(cells), path_(std::move(path)), progress_(progress) {}

    void add(const Failure& failure) {
        progress_.clear();
        warn(fmt::format("pair {} ({}), {}: {}", failure.pair, failure.family, failure.cell, failure.what));
        if (++seen_[failure.cell] > most_minimised) return;
        const auto cell = std::ranges::find(cells_, failure.cell, &Cell::name);
        const std::string line = failing_line(source_, failure, *cell);
        fmt::print(stderr, "{}\n", line);
        std::ofstream file(path_, std::ios::app);
        if (!(file << line << std::endl))
            throw std::runtime_error(fmt::format("{}: cannot be written: {}", path_, std::strerror(errno)));
    }

  private:
    const PairSource& source_;
    std::span<const Cell> cells_;
    std::string path_;
    Progress& progress_;
    std::map<std::string, int> seen_;
};

int finish(const CampaignProgress& progress, const std::vector<Cell>& cells, const std::string& state,
           bool json) {
    if (json)
        print_json(campaign_json(progress, cells));
    else
        print_campaign(progress, cells, state);
    const FamilyTally all = progress.tally.all_families();
    const bool nothing = progress.pairs() > 0 && all.answers == 0;
    if (nothing) warn("nothing was compared: every answer was refused");
    return nothing || all.wrong > 0 || !progress.is_done() ? exit_check_failed : exit_done;
}

int add_up(const CampaignArguments& options, bool json) {
    std::vector<CampaignProgress> parts;
    for (const std::string& path : options.add) {
        auto part = read_progress(path);
        if (!part) throw std::invalid_argument(path + ": no such file; name the files that --state wrote");
        parts.push_back(std::move(*part));
    }
    const CampaignProgress whole = added_up(parts);
    if (const auto there = read_progress(options.state); there && there->question != whole.question)
        throw std::invalid_argument(options.state +
                                    ": progress of another campaign: name another file with --state");
    make_folder_of(options.state, "--state");
    write_progress(whole, options.state);
    return finish(whole, {}, options.state, json);
}

/// Refuses what would be ignored.
PairSource source_of(const CampaignArguments& options) {
    const auto& families = options.families;
    if (!options.shapes.empty() && !families.empty() &&
        std::ranges::find(families, random_family) == families.end())
        throw std::invalid_argument(
            fmt::format("--shape is of the family {}: add it, or leave --shape out", random_family));
    scene::refuse_as_stored_without_mesh(options.as_stored, options.shapes);
    if (options.pairs != std::floor(options.pairs))
        throw std::invalid_argument(
            fmt::format("--pairs {}: a whole number of pairs is wanted", options.pairs));
    const std::vector<std::string> usual = {"tetra4", "cube8", "sphere38", "sphere386"};
    return {options.seed,
            families,
            options.shapes.empty() ? usual : options.shapes,
            {.as_stored = options.as_stored}};
}

int run_campaign(const CampaignArguments& options, bool json) {
    if (!options.add.empty()) return add_up(options, json);
    const sweep::Shard shard = chosen_shard(options.shard);
    const PairSource source = source_of(options);
    if (!source.warning().empty()) warn(source.warning());
    if (options.pair) {
        fmt::print("{}\n", scene::case_line(case_of(source, *options.pair),
                                            fmt::format("campaign, seed {}", options.seed)));
        return exit_done;
    }
    const std::vector<Cell> cells = chosen_cells(options);
    make_folder_of(options.state, "--state");
    make_folder_of(options.failures, "--failures");
    CampaignProgress progress = start_of(question_of(options, shard, source, cells), options.state);
    const std::uint64_t blocks = progress.question.blocks(), first = shard.first_of(blocks);
    const std::uint64_t resumed = std::max(progress.next_block, first) - first;
    Progress bar("campaign", shard.last_of(blocks) - first, resumed);
    FailureLog log(source, cells, options.failures, bar);
    measure::Stopwatch since_write;
    CampaignHooks hooks;
    hooks.on_failure = [&](const Failure& failure) { log.add(failure); };
    hooks.on_block = [&](const CampaignProgress& now) {
        bar.advance(1,
                    fmt::format("{:.4g} pairs per second", static_cast<double>(now.pairs()) / now.seconds));
        if (since_write.elapsed_ns() < seconds_between_writes * 1e9) return;
        write_progress(now, options.state);
        since_write.restart();
    };
    studies::campaign::run_campaign(source, cells, progress, hooks, stop_on_signals());
    write_progress(progress, options.state);
    bar.clear();
    return finish(progress, cells, options.state, json);
}

}  // namespace

void add_campaign(CLI::App& app, Context& context) {
    auto [command, options] =
        add_command(app, context, "campaign", "Up to 10^9 pairs through every class of answers, each proven",
                    run_campaign);
    add_number(*command, "--pairs", options.pairs, {1, 1e15, "pairs"}, "pairs in all, as 1e9");
    add_seed_option(*command, options.seed);
    add_shard_option(*command, options.shard);
    add_families_option(*command, options.families);
    add_shapes_option(*command, options.shapes, options.as_stored);
    add_layouts_option(*command, options.layouts);
    add_algorithms_option(*command, options.algorithms);
    command->add_flag("--every-type", options.every_type,
                      "every table type, not one of each class of equal answers");
    add_output_file(*command, "--state", options.state,
                    "file to write: sums so far, from which the next run goes on")
        ->capture_default_str();
    add_output_file(*command, "--failures", options.failures,
                    "file to write: failing pairs are added to it, minimised, as cases")
        ->capture_default_str();
    CLI::Option* const add = command->add_option(
        "--add", options.add, "no run: the state files of all shards added up into --state");
    CLI::Option* const pair =
        add_count(*command, "--pair", options.pair, {}, "no run: this pair as a case for edgewise query");
    pair->excludes(add)->excludes(command->get_option("--state"));
    for (const char* of_a_run : {"--shard", "--layouts", "--algorithms", "--every-type", "--failures"}) {
        add->excludes(command->get_option(of_a_run));
        pair->excludes(command->get_option(of_a_run));
    }
    for (const char* of_pairs : {"--pairs", "--seed", "--families", "--shape", "--as-stored"})
        add->excludes(command->get_option(of_pairs));
}

}  // namespace edgewise::cli
