// SPDX-License-Identifier: MIT
#include "edgewise/measure/cache/scene_caches.hpp"

#include <algorithm>

namespace edgewise::measure {

namespace {

constexpr std::uint32_t line_unit = 64, page_unit = 4096;

/// The pieces of an access in units of so many bytes.
template <class Use>
void each_unit(const TracedAccess& access, std::uint32_t unit, Use use) {
    const std::uint64_t end = access.address + access.bytes;
    for (std::uint64_t at = access.address; at < end;) {
        const std::uint64_t number = at / unit, stop = std::min(end, (number + 1) * unit);
        use(number, at, static_cast<std::uint32_t>(stop - at));
        at = stop;
    }
}

}  // namespace

/// Reuse distances of one unit, and what queries and frames touch.
struct SceneCaches::Stack {
    /// How many distinct units each stretch of a trace touches, summed.
    class DistinctUnits {
      public:
        void touch(std::uint64_t unit) {
            if (unit >= last_.size()) last_.resize(std::max(unit + 1, 2 * last_.size()), 0);
            sum_ += last_[unit] != stretch_;
            last_[unit] = stretch_;
        }
        void end_stretch() { ++stretch_; }
        void forget_sum() { sum_ = 0; }

        [[nodiscard]] std::uint64_t sum() const { return sum_; }
        /// Units that were ever touched.
        [[nodiscard]] std::uint64_t ever() const {
            return last_.size() -
                   static_cast<std::uint64_t>(std::count(last_.begin(), last_.end(), std::uint32_t{0}));
        }

      private:
        std::vector<std::uint32_t> last_;  ///< stretch that touched it last; 0: none
        std::uint32_t stretch_ = 1;
        std::uint64_t sum_ = 0;
    };

    ReuseDistance reuse;
    DistinctUnits of_queries, with_scene, of_frames;

    std::uint64_t use(std::uint64_t number, TraceSide side, bool framed) {
        if (framed) of_frames.touch(number);
        with_scene.touch(number);
        if (side != TraceSide::scene) of_queries.touch(number);
        return reuse.use(number);
    }
    void start_steady() {
        reuse.forget_curve();
        of_queries.forget_sum();
        with_scene.forget_sum();
        of_frames.forget_sum();
    }
};

/// One hierarchy with what was missed and why.
class SceneCaches::Modelled {
  public:
    Modelled(const CacheGeometry& geometry, std::size_t fields, std::size_t steps) : model_(geometry) {
        std::uint64_t above = 0;
        for (const LevelGeometry& level : geometry.levels) {
            const std::uint64_t own = std::uint64_t{level.sets} * level.ways;
            above = level.inclusion == Inclusion::exclusive ? above + own : own;
            capacity_.push_back(above);
            LevelMisses& missed = levels_.emplace_back();
            missed.level = level.name;
            missed.by_field.resize(fields);
            missed.by_step.resize(steps);
        }
    }

    [[nodiscard]] std::uint32_t unit() const { return model_.geometry().line_bytes; }
    /// Within one line, last used `distance` others ago.
    void access(std::uint64_t address, std::uint32_t bytes, const TracedAccess& whole,
                std::uint64_t distance) {
        const std::size_t depth = model_.access(address, bytes, whole.kind);
        first_touches_ += distance == ReuseDistance::never;
        for (std::size_t level = 0; level < depth; ++level) {
            LevelMisses& missed = levels_[level];
            MissKinds& kinds = missed.misses;
            ++(distance == ReuseDistance::never ? kinds.compulsory
               : distance >= capacity_[level]   ? kinds.capacity
                                                : kinds.conflict);
            ++missed.by_field[whole.field];
            ++missed.by_step[whole.step];
        }
    }
    [[nodiscard]] std::vector<LevelMisses> counted() const {
        std::vector<LevelMisses> all = levels_;
        for (std::size_t i = 0; i < all.size(); ++i) {
            all[i].accesses = model_.counts(i).accesses;
            all[i].first_touches = first_touches_;
        }
        return all;
    }
    [[nodiscard]] const CacheModel& model() const { return model_; }
    void forget_counts() {
        model_.forget_counts();
        first_touches_ = 0;
        for (LevelMisses& level : levels_) {
            level.misses = {};
            std::fill(level.by_field.begin(), level.by_field.end(), 0);
            std::fill(level.by_step.begin(), level.by_step.end(), 0);
        }
    }

  private:
    CacheModel model_;
    std::vector<std::uint64_t> capacity_;
    std::vector<LevelMisses> levels_;
    std::uint64_t first_touches_ = 0;
};

/// A machine's two hierarchies.
struct SceneCaches::Machine {
    const CacheMachine* described;
    Modelled caches;
    std::optional<Modelled> tlbs;

    [[nodiscard]] MachineMisses counted() const {
        MachineMisses all;
        all.caches = caches.counted();
        if (tlbs) all.tlbs = tlbs->counted();
        all.fetched = caches.model().fetched();
        if (described->latencies_known()) all.memory_ns = described->memory_ns(caches.model().counts());
        all.proved = described->latencies_proved();
        return all;
    }
    void forget_counts() {
        caches.forget_counts();
        if (tlbs) tlbs->forget_counts();
    }
};

SceneCaches::SceneCaches(std::span<const CacheMachine> machines, std::size_t fields, std::size_t steps,
                         bool framed)
    : framed_(framed) {
    stacks_[line_unit];
    stacks_[page_unit];
    for (const CacheMachine& machine : machines) {
        stacks_[machine.caches.line_bytes];
        std::optional<Modelled> tlbs;
        if (!machine.tlbs.levels.empty()) {
            stacks_[machine.tlbs.line_bytes];
            tlbs.emplace(machine.tlbs, fields, steps);
        }
        machines_.push_back({&machine, Modelled(machine.caches, fields, steps), std::move(tlbs)});
    }
}

SceneCaches::~SceneCaches() = default;

void SceneCaches::on_access(const TracedAccess& access) {
    for (auto& [unit, stack] : stacks_) {
        each_unit(
            access, unit,
            [&, size = unit, &used = stack](std::uint64_t number, std::uint64_t at, std::uint32_t bytes) {
                const std::uint64_t distance = used.use(number, access.side, framed_);
                for (Machine& machine : machines_) {
                    if (machine.caches.unit() == size) machine.caches.access(at, bytes, access, distance);
                    if (machine.tlbs && machine.tlbs->unit() == size)
                        machine.tlbs->access(at, bytes, access, distance);
                }
            });
    }
}

void SceneCaches::on_query_end(bool /*counts*/) {
    ++queries_;
    for (auto& [unit, stack] : stacks_) {
        stack.of_queries.end_stretch();
        stack.with_scene.end_stretch();
    }
}

void SceneCaches::on_frame_end() {
    ++frames_;
    for (auto& [unit, stack] : stacks_) stack.of_frames.end_stretch();
}

void SceneCaches::start_steady() {
    first_ = counted();
    queries_ = frames_ = 0;
    for (Machine& machine : machines_) machine.forget_counts();
    for (auto& [unit, stack] : stacks_) stack.start_steady();
}

std::vector<MachineMisses> SceneCaches::counted() const {
    std::vector<MachineMisses> all;
    for (const Machine& machine : machines_) all.push_back(machine.counted());
    return all;
}

ReuseOf SceneCaches::reuse_of(std::uint32_t unit) const {
    const Stack& stack = stacks_.at(unit);
    return {unit,
            stack.reuse.lines(),
            stack.of_queries.ever(),
            stack.of_queries.sum(),
            stack.with_scene.sum(),
            stack.of_frames.sum(),
            stack.reuse.curve()};
}

ReuseOf SceneCaches::lines() const { return reuse_of(line_unit); }
ReuseOf SceneCaches::pages() const { return reuse_of(page_unit); }

}  // namespace edgewise::measure
