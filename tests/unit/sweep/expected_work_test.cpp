// SPDX-License-Identifier: MIT
//
// Expected work of groups: what a store remembers as it is, the others by rules of thumb.
#include "edgewise/sweep/expected_work.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "edgewise/scene/rng.hpp"
#include "recorded_sweeps.hpp"

namespace edgewise::sweep {

namespace {

SweepWork two_scenes() {
    Plan plan = make_plan("quick");
    plan.scenes = {{"cold"}, {"tumble"}};
    plan.scenes[1].caches = {"sphere386"};
    plan.shapes = {"tetra4", "sphere386"};
    plan.meshes.clear();
    return prepare_sweep(plan, [](const std::string&) {});
}

TEST(ExpectedWork, GrowsWithVerticesAndRounds) {
    SweepWork work = two_scenes();
    const auto groups = expected_work(work, [](const std::string&) { return std::nullopt; });
    ASSERT_EQ(groups.size(), 4U);
    for (const GroupWork& group : groups)
        for (const Step step : {Step::verify, Step::rounds, Step::alone}) EXPECT_GT(group.of(step), 0);
    EXPECT_GT(groups[1].all(), 2 * groups[0].all()) << "386 vertices against 4";
    EXPECT_EQ(groups[1].of(Step::trace), 0);
    EXPECT_GT(groups[3].of(Step::trace), groups[3].of(Step::rounds)) << "caches of four machines";
    work.plan.rounds *= 2;
    const auto longer = expected_work(work, [](const std::string&) { return std::nullopt; });
    EXPECT_DOUBLE_EQ(longer[0].of(Step::rounds), 2 * groups[0].of(Step::rounds));
    EXPECT_EQ(longer[0].of(Step::alone), groups[0].of(Step::alone));
}

TEST(ExpectedWork, IsNoneOfABodyThatThereIsNot) {
    SweepWork work = two_scenes();
    const scene::NamedShape missing{"foot", "foot.stl", {}, "foot.stl: no such file"};
    work.scenes[0].shapes.push_back(&missing);
    const auto groups = expected_work(work, [](const std::string&) { return std::optional(3.0); });
    ASSERT_EQ(groups.size(), 5U);
    EXPECT_EQ(groups[2].all(), 0) << "whatever is remembered";
    EXPECT_NEAR(groups[1].all(), 3, 1e-9);
}

TEST(ExpectedWork, IsWhatTheLastRunTook) {
    const SweepWork work = two_scenes();
    std::vector<std::string> keys;
    const auto estimated = expected_work(work, [&](const std::string& key) -> std::optional<double> {
        keys.push_back(key);
        return std::nullopt;
    });
    ASSERT_EQ(keys.size(), 4U);
    const auto mixed = expected_work(work, [&](const std::string& key) -> std::optional<double> {
        if (key != keys[1]) return std::nullopt;
        return 100.0;
    });
    EXPECT_NEAR(mixed[1].all(), 100, 1e-9);
    EXPECT_EQ(mixed[1].kind(Step::rounds), TimeLeft::last_run);
    EXPECT_EQ(mixed[0].kind(Step::rounds), "rounds");
    EXPECT_EQ(mixed[0].all(), estimated[0].all());
}

/// Doubling the processors halves the time of traces, which run in parallel, and of no other step.
TEST(ExpectedWork, SharesTracesAmongProcessors) {
    const SweepWork work = two_scenes();
    const SceneWork& scene = work.scenes[1];
    const GroupWork two = estimated_work(work.plan, scene, *scene.shapes.back(), {31, 3}, 2),
                    four = estimated_work(work.plan, scene, *scene.shapes.back(), {31, 3}, 4);
    EXPECT_DOUBLE_EQ(two.of(Step::trace), 2 * four.of(Step::trace));
    EXPECT_EQ(two.of(Step::rounds), four.of(Step::rounds));
    EXPECT_EQ(two.of(Step::verify), four.of(Step::verify));
}

// The time that is said to be left against the truth, over recorded sweeps, and the rules of when it is said.

/// A step of a group, or a row of a later run.
struct Done {
    std::string kind;
    double work = 0, seconds = 0;
    bool ends_group = false;
};

void add_rows(std::istringstream& line, const std::string& name, std::vector<Done>& run) {
    std::string word;
    double rows = 0, expected = 0, took = 0;
    line >> word >> rows >> expected >> word >> took;
    for (int i = 0; i < rows; ++i) run.push_back({name, expected / rows, took / rows, true});
}

void add_group(const std::string& text, const Plan& plan, std::vector<Done>& run) {
    std::istringstream parts(text);
    std::string scene_text, shape_text, seconds_text, word, caches;
    std::getline(parts, scene_text, ';');
    std::getline(parts, shape_text, ';');
    std::getline(parts, seconds_text);
    std::istringstream scene_words(scene_text), shape_words(shape_text), seconds(seconds_text);
    SceneWork scene;
    scene_words >> scene.choice.name;
    while (scene_words >> word)
        scene.choice.parameters[word.substr(0, word.find('='))] = std::stod(word.substr(word.find('=') + 1));
    scene::NamedShape shape;
    CellCount cells;
    shape_words >> shape.name >> scene.queries >> cells.all >> cells.points >> caches;
    shape.body = scene::make_shape(shape.name).or_throw();
    if (!caches.empty()) scene.choice.caches = {"all"};
    const GroupWork work = estimated_work(plan, scene, shape, cells, 2);
    for (const Step step : steps) {
        double took = 0;
        seconds >> took;
        for (int part = 0; part < 10; ++part)
            run.push_back({work.kind(step), work.of(step) / 10, took / 10, false});
    }
    run.back().ends_group = true;
}

std::vector<Done> recorded(const char* text, const Plan& plan) {
    std::vector<Done> run;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string name;
        words >> name;
        if (line.find(" rows ") != std::string::npos)
            add_rows(words, name, run);
        else if (!line.empty())
            add_group(line, plan, run);
    }
    return run;
}

/// Part of the time for which a time left was said; each is checked from a tenth of the time on.
double replay(const char* name, const std::vector<Done>& run) {
    TimeLeft left;
    double all = 0, passed = 0, said = 0;
    for (const Done& done : run) {
        left.expect(done.kind, done.work);
        all += done.seconds;
    }
    for (const Done& done : run) {
        const auto seconds = left.seconds();
        if (seconds && passed > 0.1 * all && passed < 0.999 * all) {
            EXPECT_LT(std::abs(std::log(*seconds / (all - passed))), std::log(1.5))
                << name << ": " << *seconds << " s said, " << all - passed << " s left of " << all;
        }
        left.done(done.kind, done.work, done.seconds);
        if (done.ends_group) left.end_group();
        passed += done.seconds;
        said += seconds ? done.seconds : 0;
    }
    fmt::print("{}: a time left was said for {:.0f} % of {:.0f} s\n", name, 100 * said / all, all);
    return said / all;
}

Plan plan_of(int rounds, std::size_t checked, std::size_t traced = 1000, std::size_t machines = 4) {
    Plan plan;
    plan.rounds = rounds;
    plan.checked = checked;
    plan.traced = traced;
    plan.machines.resize(machines);
    return plan;
}

TEST(TimeLeft, IsNearTheTruthOrNotSaid) {
    EXPECT_GT(replay("quick", recorded(recorded_quick, plan_of(17, 200))), 0.3);
    EXPECT_GT(replay("quick, options", recorded(recorded_quick_with_options, plan_of(3, 200))), 0.05);
    EXPECT_GT(replay("peers, options", recorded(recorded_peers_with_options, plan_of(2, 1000))), 0.1);
    EXPECT_GT(replay("paper, options", recorded(recorded_paper_with_options, plan_of(3, 2000, 3000, 5))),
              0.4);
}

/// If a sweep runs again into the same store, the seconds of every group are known.
TEST(TimeLeft, IsSaidFromTheStartWhereTheLastRunIsKnown) {
    scene::Rng rng(5);
    std::vector<Done> run = recorded(recorded_quick, plan_of(17, 200));
    for (Done& done : run) {
        done.kind = TimeLeft::last_run;
        done.work = done.seconds;
        done.seconds *= rng.uniform(0.8, 1.3);
    }
    EXPECT_GT(replay("quick again", run), 0.99);
}

TEST(TimeLeft, IsNotSaidWhileMuchOfTheRestIsOfAnUnknownKind) {
    TimeLeft left;
    left.expect("rounds", 10);
    EXPECT_FALSE(left.seconds()) << "nothing ran";
    for (int group = 0; group < 8; ++group) {
        left.done("rounds", 1, 2);
        left.end_group();
    }
    EXPECT_NEAR(left.seconds().value(), 4, 1e-9);
    left.expect("trace", 100);
    EXPECT_FALSE(left.seconds());
    left.skip("trace", 99.9);
    EXPECT_NEAR(left.seconds().value(), 4.2, 1e-9) << "twice as slow as all others";
}

TEST(TimeLeft, IsNotSaidWhileGroupsDifferTooMuch) {
    TimeLeft even, uneven;
    for (TimeLeft* left : {&even, &uneven}) left->expect("rounds", 100);
    for (int group = 0; group < 20; ++group) {
        even.done("rounds", 1, 1);
        uneven.done("rounds", 1, group % 2 == 0 ? 1 : 20);
        even.end_group();
        uneven.end_group();
    }
    EXPECT_NEAR(even.seconds().value(), 80, 1e-9);
    EXPECT_FALSE(uneven.seconds());
}

}  // namespace

}  // namespace edgewise::sweep
