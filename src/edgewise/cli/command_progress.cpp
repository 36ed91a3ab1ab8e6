// SPDX-License-Identifier: MIT
//
// `edgewise progress`: how near a sweep's progress came to the truth. Its store holds what each piece was
// expected to take, and took.
#include <fmt/format.h>

#include "edgewise/cli/command.hpp"
#include "edgewise/reports/tables/text_grid.hpp"
#include "edgewise/store/merge_source.hpp"
#include "edgewise/sweep/progress_pieces.hpp"

namespace edgewise::cli {

namespace {

struct ProgressArguments {
    std::string store = default_store;
};

constexpr double from_a_tenth_on = 0.1;

void print_pieces(const std::vector<sweep::ProgressPiece>& pieces) {
    double expected = 0, took = 0, shown = 0, truth = 0;
    for (const sweep::ProgressPiece& piece : pieces) {
        expected += piece.expected;
        took += piece.took;
    }
    reports::TextGrid table{"", reports::columns_of("#shown|#true|#expected s|#took s|piece")};
    for (const sweep::ProgressPiece& piece : pieces) {
        shown += piece.expected / expected;
        truth += piece.took / took;
        table.add(fmt::format("{:.1f} %", shown * 100), fmt::format("{:.1f} %", truth * 100),
                  fmt::format("{:.2f}", piece.expected), fmt::format("{:.2f}", piece.took), piece.what);
    }
    fmt::print("{}", grid_text(table));
}

int run_progress(const ProgressArguments& options, bool json) {
    const auto& meta = store::MergeSource(options.store).meta;
    const std::vector<sweep::ProgressPiece> pieces =
        sweep::progress_pieces(std::vector<std::pair<std::string, std::string>>(meta.begin(), meta.end()));
    if (pieces.empty())
        throw std::invalid_argument(options.store +
                                    ": no sweep ran into this store that kept what it expected; sweep anew");
    const sweep::ProgressDeviation worst = sweep::worst_deviation(pieces, from_a_tenth_on);
    if (json) {
        nlohmann::json rows = nlohmann::json::array();
        for (const sweep::ProgressPiece& piece : pieces)
            rows.push_back({{"piece", piece.what}, {"expected", piece.expected}, {"took", piece.took}});
        print_json(nlohmann::json{{"pieces", rows},
                                  {"from", from_a_tenth_on},
                                  {"worst_deviation", worst.relative},
                                  {"at", worst.at}});
        return exit_done;
    }
    print_pieces(pieces);
    fmt::print(
        "from a tenth of the time on, progress was off by {:+.0f} % at most, at {:.0f} % of the time\n",
        worst.relative * 100, worst.at * 100);
    return exit_done;
}

}  // namespace

void add_progress(CLI::App& app, Context& context) {
    auto [command, options] =
        add_command(app, context, "progress",
                    "How near a sweep's progress came to the truth, from what its store keeps", run_progress);
    command->add_option("store", options.store, "store of a sweep that ran to its end")
        ->capture_default_str();
}

}  // namespace edgewise::cli
