// SPDX-License-Identifier: MIT
//
// `recorded`: motion of an engine, replayed step after step. Pairs are the engine's own, if the recording has
// them, or those of sweep and prune over the cores' boxes, enlarged by a margin and by the body's radius,
// without the pairs that the recording's links, groups and sleep forbid.
//
// One slot of the pair cache is one uninterrupted stay of a pair in the list, as in `tumble`: a pair that was
// there in the step before starts warm; a new pair, and every pair after a jump, starts cold.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "edgewise/geometry/message.hpp"
#include "edgewise/scene/kinds/scene_setup.hpp"
#include "edgewise/scene/recording.hpp"

namespace edgewise::scene {
namespace {

/// A step to replay, with its pairs.
struct Replayed {
    const RecordedStep* step;
    bool jump;
    std::vector<Pose> poses = {};  ///< of the bodies
    std::vector<Aabb> boxes = {};  ///< none where the pairs are the engine's
    std::vector<BodyPair> pairs = {};
};

class Replay {
  public:
    Replay(const Recording& recording, const SceneParameters& parameters)
        : recording_(recording),
          parameters_(parameters),
          own_pairs_(!recording.has_pairs || parameters.at("own_pairs") == 1),
          broad_phase_(recording.bodies.size()) {}

    /// The steps at the rate asked for, with their pairs. A jump that lies between two of them is the later
    /// one's.
    std::vector<Replayed> steps() {
        const double rate = parameters_.at("rate"), seconds = parameters_.at("seconds");
        std::vector<Replayed> steps;
        bool jump = true;
        double ticks = 0, start = recording_.steps.front().time, last = start;
        for (const RecordedStep& step : recording_.steps) {
            // A reset sets the clock back: time goes on from there.
            if (step.time < last) start += step.time - last;
            last = step.time;
            if (seconds > 0 && step.time - start > seconds) break;
            jump = jump || step.jump;
            const double tick = std::floor((step.time - start) * rate * (1 + 1e-9));
            if (rate > 0 && !steps.empty() && tick <= ticks) continue;
            ticks = tick;
            steps.push_back(replayed(step, jump));
            jump = false;
        }
        return steps;
    }

  private:
    Replayed replayed(const RecordedStep& step, bool jump) {
        Replayed result{&step, jump};
        for (const RecordedBody& body : recording_.bodies) {
            const Pose &link = step.links[body.link], &in_link = body.in_link;
            result.poses.push_back(
                {multiply(link.rotation, in_link.rotation), link.apply(in_link.translation)});
        }
        if (!own_pairs_) {
            std::ranges::copy_if(step.pairs, std::back_inserter(result.pairs),
                                 [this](const BodyPair& pair) { return is_of_link(pair); });
            return result;
        }
        for (std::size_t i = 0; i < recording_.bodies.size(); ++i) {
            const RecordedBody& body = recording_.bodies[i];
            const Polyhedron& core = recording_.cores[body.core];
            const double margin = parameters_.at("margin") * extent(core.vertices) + body.radius;
            result.boxes.push_back(world_box(core, result.poses[i]).enlarged(margin));
        }
        for (const BodyPair& pair : broad_phase_.update(result.boxes))
            if (is_asked(pair, step) && is_of_link(pair)) result.pairs.push_back(pair);
        return result;
    }

    [[nodiscard]] bool is_of_link(const BodyPair& pair) const {
        const double link = parameters_.at("link");
        return link < 0 || recording_.bodies[pair.first].link == link ||
               recording_.bodies[pair.second].link == link;
    }

    [[nodiscard]] bool is_asked(const BodyPair& pair, const RecordedStep& step) const {
        const RecordedBody &a = recording_.bodies[pair.first], &b = recording_.bodies[pair.second];
        const auto rests = [&](const RecordedBody& body) {
            return body.fixed || (!step.asleep.empty() && step.asleep[body.link]);
        };
        if (a.link == b.link || a.parent == b.link || b.parent == a.link || (rests(a) && rests(b)))
            return false;
        const BodyPair links{std::min(a.link, b.link), std::max(a.link, b.link)};
        return ((a.group & b.mask) | (b.group & a.mask)) != 0 &&
               !std::ranges::binary_search(recording_.excluded, links);
    }

    const Recording& recording_;
    const SceneParameters& parameters_;
    bool own_pairs_;
    SweepAndPrune broad_phase_;
};

/// Removes whole segments of steps until there are about `query_count` queries. Returns what was kept, in
/// words; empty if all was.
std::string keep_segments(std::size_t length, std::size_t query_count, std::vector<Replayed>& steps) {
    std::size_t queries = 0;
    for (const Replayed& step : steps) queries += step.pairs.size();
    if (queries <= query_count || steps.size() <= length) return {};
    const std::size_t count = std::max<std::size_t>(1, query_count * steps.size() / (queries * length));
    std::vector<Replayed> kept;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t room = steps.size() - length,
                          first = count == 1 ? room / 2 : room * k / (count - 1);
        for (std::size_t i = first; i < first + length; ++i) {
            kept.push_back(steps[i]);
            kept.back().jump |= i == first;
        }
    }
    std::string text = fmt::format("{} of {} steps are asked, {} times {} in a row, for {} queries",
                                   kept.size(), steps.size(), count, length, query_count);
    steps = std::move(kept);
    return text;
}

}  // namespace

Result<Workload> recorded_workload(const Recording& recording, const SceneParameters& parameters,
                                   std::size_t query_count) {
    std::vector<Replayed> steps = Replay(recording, parameters).steps();
    std::string note = recording.note;
    const std::string kept =
        keep_segments(static_cast<std::size_t>(parameters.at("segment")), query_count, steps);
    Workload workload;
    workload.warm = true;
    workload.table_each = parameters.at("own_tables") == 1;
    workload.bodies = recording.cores;
    for (const RecordedBody& body : recording.bodies) {
        workload.instances.push_back(body.core);
        workload.radii.push_back(body.radius);
    }
    if (std::ranges::all_of(workload.radii, [](double radius) { return radius == 0; }))
        workload.radii.clear();
    PairSlots slots;
    for (Replayed& step : steps) {
        if (step.jump) slots.clear();
        workload.frames.push_back({workload.queries.size(), step.jump, std::move(step.boxes)});
        ask_pairs(step.pairs, step.poses, slots, workload);
    }
    if (workload.queries.empty())
        return Result<Workload>::failure(fmt::format(
            "recording {}: no pair is near in {} steps; raise margin", recording.name, steps.size()));
    add_warning(note, kept);
    if (!note.empty()) note = fmt::format("recording {}: {}", recording.name, note);
    return Result<Workload>::success(std::move(workload), note);
}

Result<Workload> make_recorded(const SceneSetup&) {
    return Result<Workload>::failure(
        R"(scene 'recorded' is of a file: name the recording with --scenes, or a scene file with "recording")");
}

}  // namespace edgewise::scene
