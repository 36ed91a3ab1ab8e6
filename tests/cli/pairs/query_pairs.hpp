// SPDX-License-Identifier: MIT
//
// Pairs for `edgewise query`, and how its tests ask.
#pragma once

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "program.hpp"

namespace edgewise::cli_test {

using nlohmann::json;

inline const json tetrahedron = {{"vertices", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
inline const json triangle = {{"vertices", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}};
inline const json huge = {{"vertices", {{0, 0, 0}, {1e200, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};

inline json moved(double x, double y, double z) {
    return {{"R", {1, 0, 0, 0, 1, 0, 0, 0, 1}}, {"t", {x, y, z}}};
}

inline std::string pair_line(const std::string& id, const json& a, double x, double y = 0, double z = 0) {
    return json{{"id", id}, {"a", a}, {"b", tetrahedron}, {"pose_b", moved(x, y, z)}}.dump() + "\n";
}

inline std::vector<json> answers_of(const Outcome& outcome) {
    std::vector<json> answers;
    for (const std::string& line : lines_of(outcome.out)) answers.push_back(json::parse(line));
    return answers;
}

class Query : public testing::TestWithParam<const char*> {
  protected:
    Outcome ask(const std::string& cases, const Arguments& more = {}) {
        return run(with({"query", folder_.write("cases.jsonl", cases), "--algorithm", GetParam()}, more),
                   folder_);
    }

  private:
    Folder folder_;
};

}  // namespace edgewise::cli_test
