// SPDX-License-Identifier: MIT
//
// The report reads a store and nothing else, so it has a list of its own of what goes without saying in a
// scene's label: it is the list of scenes.
#include <gtest/gtest.h>

#include <algorithm>

#include "edgewise/reports/reader.hpp"
#include "edgewise/scene/scenes.hpp"

namespace edgewise {
namespace {

TEST(SceneStandards, AreTheScenesOwn) {
    std::size_t parameters = 0;
    for (const scene::SceneInfo& info : scene::list_scenes()) {
        for (const scene::ParameterInfo& parameter : info.parameters) {
            ++parameters;
            const auto standards = reports::scene_standards();
            const auto found = std::find_if(standards.begin(), standards.end(), [&](const auto& standard) {
                return standard.kind == info.name && standard.parameter == parameter.name;
            });
            ASSERT_NE(found, standards.end()) << info.name << ' ' << parameter.name;
            EXPECT_EQ(found->value, parameter.standard) << info.name << ' ' << parameter.name;
        }
    }
    EXPECT_EQ(parameters, reports::scene_standards().size());
}

}  // namespace
}  // namespace edgewise
