// SPDX-License-Identifier: MIT
//
// The vocabulary of figures against what a sweep stores, and against its page in docs/.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "cli_paths.hpp"
#include "program.hpp"
#include "sweep_store.hpp"

namespace edgewise::cli_test {
namespace {

using nlohmann::json;

json figures(const Folder& folder) {
    const Outcome outcome = run({"list", "figures", "--json"}, folder);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(outcome.out).at("figures");
}

/// "heap.{structure}.slack_bytes" as what its stored names look like.
std::regex pattern_of(const std::string& name) {
    std::string pattern = std::regex_replace(name, std::regex(R"([.^$*+?()\[\]\\|])"), R"(\$&)");
    return std::regex(std::regex_replace(pattern, std::regex(R"(\{[a-z]+\})"), ".+"));
}

/// docs/generate rewrites the page.
TEST(Figures, AreDocumented) {
    const Folder folder;
    std::string rows;
    for (const json& figure : figures(folder)) {
        const auto text = [&](const char* key) { return figure.at(key).get<std::string>(); };
        rows += "| `" + text("name") + "` | " + text("unit") + " | " + text("population") + " | " +
                (figure.at("deterministic").get<bool>() ? "yes" : "no") + " | " + text("meaning") + " |\n";
    }
    EXPECT_THAT(text_of(figures_page), testing::EndsWith("|---|---|---|---|---|\n" + rows))
        << "run docs/generate";
}

TEST(Figures, OfASweepAreAllInTheVocabulary) {
    const Folder folder;
    const Outcome sweep = run({"sweep",
                               "--scenes",
                               "tumble,static,cold",
                               "--shapes",
                               "cube8,sphere38",
                               "--layouts",
                               "aos_f64",
                               "--queries",
                               "200",
                               "--checked",
                               "20",
                               "--rounds",
                               "1",
                               "--caches",
                               "sphere38",
                               "--stability",
                               "5",
                               "--axes",
                               "allocator=arena",
                               "--store",
                               "s.db"},
                              folder);
    ASSERT_EQ(sweep.exit_code, 0) << sweep.err;
    std::vector<std::pair<std::regex, std::string>> known;
    for (const json& figure : figures(folder))
        known.emplace_back(pattern_of(figure.at("name")), figure.at("unit"));
    const auto stored = rows_of(folder / "s.db", "select distinct probe || '.' || name, unit from figure");
    EXPECT_GT(stored.size(), 250U);
    for (const std::string& row : stored) {
        const std::string name = row.substr(0, row.find('|')), unit = row.substr(row.find('|') + 1);
        const auto is_it = [&](const auto& entry) {
            return std::regex_match(name, entry.first) && unit.starts_with(entry.second);
        };
        EXPECT_TRUE(std::any_of(known.begin(), known.end(), is_it)) << row;
    }
}

}  // namespace
}  // namespace edgewise::cli_test
