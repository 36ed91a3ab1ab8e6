// SPDX-License-Identifier: MIT
#include "edgewise/cli/terminal/campaign_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "edgewise/reports/tables/text_grid.hpp"

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

double seconds_of(const FamilyTally& family) { return family.making_s + family.asking_s + family.proving_s; }

std::uint64_t proofs_of(const FamilyTally& family) {
    return family.double_proofs + family.wide_proofs + family.exact_proofs;
}

/// Of the pairs' distances in each storage.
double share_by_filter(const FamilyTally& family) {
    return per(count(family.double_proofs + family.wide_proofs), count(proofs_of(family)));
}

std::string vertices_of(const FamilyTally& family) {
    if (family.least_vertices == family.most_vertices) return fmt::format("{}", family.most_vertices);
    return fmt::format("{} to {}", family.least_vertices, family.most_vertices);
}

void add_family(reports::TextGrid& grid, const std::string& name, const FamilyTally& family) {
    const double pairs = count(family.pairs), seconds = seconds_of(family);
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
        "", reports::columns_of("cell|#answers|#refused|#in band|#wrong|#worst error|#of pair|" +
                                std::string(cells.empty() ? " " : "and as many as answer alike"))};
    for (const auto& [name, cell] : progress.tally.cells) {
        const auto found = std::ranges::find(cells, name, &Cell::name);
        const std::size_t alike = found == cells.end() ? 0 : found->as_well.size();
        grid.add(name, cell.answers, cell.refused, cell.in_band, cell.wrong,
                 fmt::format("{:.3g}", cell.worst_error), cell.worst_pair,
                 alike == 0 ? "" : fmt::format("+{}", alike));
    }
    fmt::print("{}", grid_text(grid));
}

}  // namespace

void print_campaign(const CampaignProgress& progress, std::span<const Cell> cells, const std::string& state) {
    print_families(progress);
    print_cells(progress, cells);
    const FamilyTally all = progress.tally.all_families();
    fmt::print(
        "\n{} of {} pairs of shard {}, {} answers in {:.1f} s: {}\nRates are of one thread and take in "
        "making the pairs, asking every cell and proving. double, wide, exact: how the distance became known, in "
        "percent of pairs and storages. Of the pairs: separated, grazing (distance or depth within the band, verdict not asked), touching, overlapping. Errors are bounds, divided by the scale, beyond the band.\nstate: {}{}\n",
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
    line["share_by_filter"] = share_by_filter(all);
    line["pairs_per_second"] = per(count(progress.pairs()), progress.seconds);
    line["answers_per_second"] = per(count(all.answers), progress.seconds);
    for (const Cell& cell : cells) line["classes"][cell.name] = cell.as_well;
    return line;
}

}  // namespace edgewise::cli
