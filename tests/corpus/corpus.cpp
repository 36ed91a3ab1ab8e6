// SPDX-License-Identifier: MIT
#include "corpus.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <utility>

#include "corpus_paths.hpp"

namespace edgewise {
namespace {

std::vector<Case> read_all() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(corpus_folder)) {
        if (entry.path().extension() == ".jsonl") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    std::vector<Case> cases;
    for (const auto& file : files) {
        std::ifstream stream(file);
        CaseReader reader(stream, file.filename().string());
        while (auto line = reader.next()) {
            EXPECT_TRUE(*line) << line->error;
            if (*line) cases.push_back(**line);
        }
    }
    return cases;
}

void reverse(CaseBody& body) {
    std::reverse(body.vertices.begin(), body.vertices.end());
    if (!body.faces) return;
    for (std::vector<Index>& face : *body.faces) {
        for (Index& v : face) v = static_cast<Index>(body.vertices.size()) - 1 - v;
    }
}

void scale(CaseBody& body, Pose& pose, double factor) {
    for (Vec3d& v : body.vertices) v *= factor;
    pose.translation *= factor;
}

}  // namespace

const std::vector<Case>& corpus() {
    static const std::vector<Case> all = read_all();
    return all;
}

Case swapped(const Case& given) {
    Case result = given;
    std::swap(result.a, result.b);
    std::swap(result.pose_a, result.pose_b);
    return result;
}

Case reversed(const Case& given) {
    Case result = given;
    reverse(result.a);
    reverse(result.b);
    return result;
}

Case scaled_by_power(const Case& given, int exponent) {
    Case result = given;
    scale(result.a, result.pose_a, std::ldexp(1.0, exponent));
    scale(result.b, result.pose_b, std::ldexp(1.0, exponent));
    return result;
}

}  // namespace edgewise
