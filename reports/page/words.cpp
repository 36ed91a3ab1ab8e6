// SPDX-License-Identifier: MIT
//
// The sentences that the HTML and the Markdown report share; declared in page.hpp.
#include <fmt/core.h>

#include <algorithm>

#include "edgewise/reports/page/page.hpp"
#include "edgewise/reports/tables/cache_tables.hpp"
#include "edgewise/reports/tables/text.hpp"

namespace edgewise::reports {

namespace {

std::string stability_line(const ReportData& data) {
    if (data.stability.empty()) return {};
    const auto failed = std::count_if(data.stability.begin(), data.stability.end(),
                                      [](const ReportCell& row) { return row.status == "failed"; });
    return fmt::format(" Of {}, {} failed.", plural(data.stability.size(), "stability row"), failed);
}

}  // namespace

std::string verdict_line(const ReportData& data) {
    const std::size_t failed = data.count("failed"), unavailable = data.count("unavailable");
    const std::size_t verified = data.count("verified");
    std::string cells = failed == 0 && unavailable == 0
                            ? fmt::format("All {} verified.", plural(verified, "cell"))
                            : fmt::format("{} verified, {} failed, {} unavailable.", plural(verified, "cell"),
                                          failed, unavailable);
    if (data.cell_count() == 0) cells = "No cells.";
    return cells + stability_line(data);
}

std::string report_purpose() {
    return "Edgewise runs convex collision detection (V-Clip, Enhanced GJK) over interchangeable data "
           "layouts and "
           "measures what each layout costs in memory, time and accuracy. Every cell (scene, shape, "
           "algorithm, "
           "layout, precision) was checked against exact arithmetic before it was timed; a cell that fails "
           "the "
           "check is listed and not timed.";
}

std::string bytes_explanation() {
    return "Every byte of the built table over the edges of its shape. The paper states 168 bytes per edge "
           "in double "
           "precision and 84 in single for the Voronoi planes, the edge geometry and the vertex coordinates; "
           "the column "
           "\"paper's subtotal (slope)\" is that sum for each additional edge, measured over built tables of "
           "growing "
           "size, and \"total (slope)\" is the same for all bytes. Face planes, topology and padding, which "
           "the paper "
           "does not count, have their own columns.";
}

std::string layout_explanation() {
    return "What a layout costs beside its own bytes. A cache pays for lines of 64 bytes, not for bytes: "
           "\"lines a query\" are the distinct lines that a query reads of both tables, traced; \"bytes "
           "read\" "
           "is what it asked for of them. Build is a table from the canonical body with its face planes; "
           "refit "
           "writes the numbers of a deformed body of the same topology into a table that stands. "
           "\"Materialised\" is the part of a table that ever stood: below 1 where planes are made when they "
           "are first asked for. Where a scene gives every body a table of its own, the second table shows "
           "what "
           "they take together, and what that does to the time of a query.";
}

std::string cache_explanation(const ReportData& data) {
    if (modelled_cells(data).empty()) {
        return "No cell of this store had its caches modelled: `edgewise sweep --caches all` does it.";
    }
    return "Every access of a cell's first queries (as many as the plan traces) to tables, pair caches and, "
           "where the scene has one, the broad phase goes through models of these machines' caches and TLBs, "
           "at addresses that are the same in every run and on every machine. Cold misses come from empty "
           "caches before each query, tables alone; the warm pass starts empty and fills them as the scene "
           "goes; the steady pass comes after it. A miss is compulsory (first touch), capacity (a fully "
           "associative LRU cache of that size would miss it too) or conflict. Models have LRU and neither "
           "prefetching nor waits that overlap; stack, queries' poses and instructions are not in them. "
           "Memory time is that model's, with every miss waited for and hits in the first level free. The "
           "knee is the smallest cache in which a query brings in again at most a tenth of the lines it "
           "touches: below it the scene thrashes. \"Scene\" means what the traced queries touch.";
}

std::string counter_explanation(const ReportData& data) {
    std::string why;
    for (const ReportCell& cell : data.cells) {
        const measure::Figure figure = cell.figure("counters.instructions");
        if (!cell.verified() || figure.value) continue;
        why = " Not counted here: " + figure.reason + ".";
        break;
    }
    return "What the processor counts of a pass over all queries (narrow phase) in the steady state, in "
           "small "
           "groups, a pass each, and what the kernel counts: page faults, context switches, migrations. The "
           "heap columns are one table in jemalloc, in an arena of its own; slack is what its size classes "
           "add." +
           why;
}

std::string time_explanation() {
    return "Median nanoseconds a query over interleaved rounds with its bootstrap 95 % interval, and the "
           "median over "
           "rounds of the ratio to the baseline cell (V-Clip on aos_f64, same scene and shape) timed in the "
           "same "
           "round: below 1 is faster than the baseline. The ratio's interval comes from the order statistics "
           "of the "
           "rounds; with fewer than six rounds it is the whole range, marked (range). Compare ratios first: "
           "times move "
           "with the machine's clock, ratios hardly.";
}

std::string error_explanation() {
    return "Errors are |d - d*| over the scale of the pair (the larger of body extent and offset): against "
           "the bodies as "
           "given, and against the bodies as stored, which is the algorithm's own error. A verdict is wrong "
           "when it "
           "contradicts the exact one outside the rounding band; verdicts inside the band are counted apart. "
           "Fallbacks, "
           "refinements, escapes, cycles and steps are over all queries of a cell; an escape is a local "
           "minimum under a face that V-Clip left for a better face.";
}

std::string stability_explanation(const ReportData& data) {
    if (data.stability.empty()) {
        return "This store holds no stability run: `edgewise stability` runs the hard families into it.";
    }
    return "Pairs that broke collision libraries, generated family by family and judged by exact arithmetic. "
           "A "
           "wrong verdict outside the rounding band, or an error beyond what the precision allows, fails the "
           "row; verdicts that differ inside the band are counted apart, for there the precision cannot "
           "tell. "
           "Errors and certificate widths are over the scale of the pair, beyond what the rotation matrices' "
           "own "
           "distance from orthogonal explains. Refused cases are bodies or numbers that Edgewise does not "
           "take, "
           "each with a reason. Cap hits are depths at which EPA ran into its limit of faces, the only cap "
           "there is, "
           "and which are upper bounds therefore. The control is the paper's robustness metric: how many "
           "verdicts disagree "
           "with the test "
           "of Moore and Wilhelms, which takes touching bodies and exact copies for apart; outside the band "
           "and off "
           "exact touch only a defect may disagree, and \"control wrong\" says whose it is. Escapes are "
           "local "
           "minima under a face that V-Clip left for a better face, cycles are "
           "V-Clip runs that came back to a state, fallbacks the answers that "
           "GJK gave instead, refinements close answers that it worked out again in wider arithmetic.";
}

}  // namespace edgewise::reports
