// SPDX-License-Identifier: MIT
#include "edgewise/measure/cache/scene_caches.hpp"

#include <algorithm>
#include <utility>

#include "edgewise/measure/cache/prefetcher.hpp"

namespace edgewise::measure {
namespace {

constexpr std::uint32_t line_unit = 64, page_unit = 4096;

}  // namespace

/// Reuse distances of one unit, and what queries and frames touch.
struct SceneCaches::Stack {
    /// How many distinct units each stretch of a trace touches, summed.
    struct DistinctUnits {
        std::vector<std::uint32_t> last;  ///< stretch that touched it last; 0: none
        std::uint32_t stretch = 1;
        ByStart<std::uint64_t> sum;

        void touch(std::uint64_t unit, std::optional<QueryStart> start) {
            if (unit >= last.size()) last.resize(std::max(unit + 1, 2 * last.size()), 0);
            if (last[unit] != stretch) sum.add(start, 1);
            last[unit] = stretch;
        }
        /// Units that were ever touched.
        [[nodiscard]] std::uint64_t ever() const {
            return last.size() - static_cast<std::uint64_t>(std::ranges::count(last, std::uint32_t{0}));
        }
    };

    ReuseDistance reuse;            ///< its curve is of all accesses
    ByStart<MissCurve> own_curves;  ///< of queries by their start
    DistinctUnits of_queries, with_scene, of_frames;
    std::uint64_t in_frames = 0;  ///< the sum of of_frames when the last frame ended

    std::uint64_t use(std::uint64_t number, TraceSide side, std::optional<QueryStart> start, bool framed) {
        if (framed) of_frames.touch(number, {});
        with_scene.touch(number, start);
        if (side != TraceSide::scene) of_queries.touch(number, start);
        const std::uint64_t distance = reuse.use(number);
        if (!start) return distance;
        MissCurve& own = own_curves.of(*start);
        distance == ReuseDistance::never ? own.add_first() : own.add(distance);
        return distance;
    }
    void start_steady() {
        reuse.forget_curve();
        own_curves = {};
        of_queries.sum = with_scene.sum = of_frames.sum = {};
        ++of_frames.stretch;  // the last frame may have been cut
        in_frames = 0;
    }
};

/// One hierarchy with what was missed and why.
class SceneCaches::Modelled {
  public:
    /// `machine`: its name, which says whether it has a prefetcher.
    Modelled(const CacheGeometry& geometry, std::size_t fields, std::size_t steps, const std::string& machine)
        : model_(geometry), prefetcher_(machine, geometry.line_bytes) {
        std::uint64_t above = 0;
        for (const LevelGeometry& level : geometry.levels) {
            const std::uint64_t own = std::uint64_t{level.sets} * level.ways;
            above = level.inclusion == Inclusion::exclusive ? above + own : own;
            capacity_.push_back(above);
            const std::vector<std::uint64_t> no_field(fields), no_step(steps);
            none_.push_back({level.name, 0, 0, {}, no_field, no_step});
        }
        levels_ = {none_, none_, none_};
    }

    [[nodiscard]] std::uint32_t unit() const { return model_.geometry().line_bytes; }
    /// Within one line, last used `distance` others ago.
    void access(std::uint64_t address, std::uint32_t bytes, const TracedAccess& whole,
                std::optional<QueryStart> start, std::uint64_t distance) {
        const std::size_t depth = model_.access(address, bytes, whole.kind);
        levels_.each(start, [&](std::vector<LevelMisses>& levels) {
            ++levels[0].accesses;
            levels[0].first_touches += distance == ReuseDistance::never;
            for (std::size_t level = 0; level < depth; ++level)
                book(levels[level], whole, distance, capacity_[level]);
        });
        // Prefetched lines are counted by the model, and booked nowhere.
        if (depth > 0)
            prefetcher_.on_miss(address / unit(), [&](std::uint64_t line) {
                model_.access(line * unit(), 1, AccessKind::read);
            });
    }
    [[nodiscard]] ByStart<std::vector<LevelMisses>> counted() const {
        ByStart<std::vector<LevelMisses>> found = levels_;
        for (auto* levels : {&found.all, &found.cold, &found.warm}) {
            for (std::size_t i = 1; i < levels->size(); ++i) {
                (*levels)[i].accesses = (*levels)[i - 1].misses.all();
                (*levels)[i].first_touches = levels->front().first_touches;
            }
        }
        return found;
    }
    [[nodiscard]] const CacheModel& model() const { return model_; }
    void forget_counts() {
        model_.forget_counts();
        levels_ = {none_, none_, none_};
    }

  private:
    static void book(LevelMisses& missed, const TracedAccess& whole, std::uint64_t distance,
                     std::uint64_t capacity) {
        MissKinds& kinds = missed.misses;
        ++(distance == ReuseDistance::never ? kinds.compulsory
           : distance >= capacity           ? kinds.capacity
                                            : kinds.conflict);
        ++missed.by_field[whole.field];
        ++missed.by_step[whole.step];
    }

    CacheModel model_;
    Prefetcher prefetcher_;
    std::vector<std::uint64_t> capacity_;
    std::vector<LevelMisses> none_;             ///< counts before the first access
    ByStart<std::vector<LevelMisses>> levels_;  ///< accesses and first touches: of the first alone
};

/// A machine's two hierarchies.
struct SceneCaches::Machine {
    const CacheMachine* described;
    Modelled caches;
    std::optional<Modelled> tlbs;

    [[nodiscard]] ByStart<MachineMisses> counted() const {
        const ByStart<std::vector<LevelMisses>> of_caches = caches.counted();
        ByStart<std::vector<LevelMisses>> of_tlbs;
        if (tlbs) of_tlbs = tlbs->counted();
        ByStart<MachineMisses> found{of(of_caches.all, of_tlbs.all), of(of_caches.cold, of_tlbs.cold),
                                     of(of_caches.warm, of_tlbs.warm)};
        found.all.fetched = caches.model().fetched();
        return found;
    }
    void forget_counts() {
        caches.forget_counts();
        if (tlbs) tlbs->forget_counts();
    }

  private:
    [[nodiscard]] MachineMisses of(const std::vector<LevelMisses>& levels,
                                   const std::vector<LevelMisses>& pages) const {
        MachineMisses found;
        found.caches = levels;
        found.tlbs = pages;
        std::vector<LevelCounts> counts;
        for (const LevelMisses& level : levels) counts.push_back({level.accesses, level.misses.all(), 0});
        if (described->latencies_known()) found.memory_ns = described->memory_ns(counts);
        found.proved = described->latencies_proved();
        return found;
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
            tlbs.emplace(machine.tlbs, fields, steps, "");
        }
        machines_.push_back(
            {&machine, Modelled(machine.caches, fields, steps, machine.name), std::move(tlbs)});
    }
}

SceneCaches::~SceneCaches() = default;

void SceneCaches::on_access(const TracedAccess& access) {
    for (auto& [unit, stack] : stacks_) {
        access.for_each_unit(unit, [&, size = unit, &used = stack](std::uint64_t number) {
            const std::uint64_t distance = used.use(number, access.side, start_, framed_);
            const std::uint64_t at = std::max(access.address, number * size);
            const auto bytes =
                static_cast<std::uint32_t>(std::min(access.address + access.bytes, (number + 1) * size) - at);
            for (Machine& machine : machines_) {
                if (machine.caches.unit() == size) machine.caches.access(at, bytes, access, start_, distance);
                if (machine.tlbs && machine.tlbs->unit() == size)
                    machine.tlbs->access(at, bytes, access, start_, distance);
            }
        });
    }
}

void SceneCaches::on_query_end(bool /*counts*/) {
    queries_.add(start_, 1);
    start_.reset();
    for (auto& [unit, stack] : stacks_) {
        ++stack.of_queries.stretch;
        ++stack.with_scene.stretch;
    }
}

void SceneCaches::on_frame_end() {
    ++frames_;
    for (auto& [unit, stack] : stacks_) {
        ++stack.of_frames.stretch;
        stack.in_frames = stack.of_frames.sum.all;
    }
}

void SceneCaches::start_steady() {
    for (const ByStart<MachineMisses>& machine : steady()) first_.push_back(machine.all);
    queries_ = {};
    frames_ = 0;
    for (Machine& machine : machines_) machine.forget_counts();
    for (auto& [unit, stack] : stacks_) stack.start_steady();
}

std::vector<ByStart<MachineMisses>> SceneCaches::steady() const {
    std::vector<ByStart<MachineMisses>> all;
    for (const Machine& machine : machines_) all.push_back(machine.counted());
    return all;
}

ReuseOf SceneCaches::reuse_of(std::uint32_t unit) const {
    const Stack& stack = stacks_.at(unit);
    return {unit,
            stack.reuse.lines(),
            stack.of_queries.ever(),
            stack.of_queries.sum,
            stack.with_scene.sum,
            stack.in_frames,
            {stack.reuse.curve(), stack.own_curves.cold, stack.own_curves.warm}};
}

ReuseOf SceneCaches::lines() const { return reuse_of(line_unit); }
ReuseOf SceneCaches::pages() const { return reuse_of(page_unit); }

ColdCaches::ColdCaches(std::span<const CacheMachine> machines) {
    for (const CacheMachine& machine : machines) {
        const std::vector<std::uint64_t> none(machine.caches.levels.size());
        machines_.push_back({CacheModel(machine.caches), {none, none, none}, none, {}});
    }
}

void ColdCaches::on_access(const TracedAccess& access) {
    if (access.side == TraceSide::scene) return;
    for (Cold& cold : machines_) {
        if (cold.model.access(access.address, access.bytes, access.kind) == 0) continue;
        access.for_each_unit(cold.model.geometry().line_bytes,
                             [&](std::uint64_t line) { cold.lines.push_back(line); });
    }
}

void ColdCaches::on_query_end(bool /*counts*/) {
    for (Cold& cold : machines_) {
        for (std::size_t i = 0; i < cold.booked.size(); ++i) {
            const std::uint64_t before = std::exchange(cold.booked[i], cold.model.counts(i).misses);
            cold.misses.each(start_, [&](auto& misses) { misses[i] += cold.booked[i] - before; });
        }
        for (const std::uint64_t line : cold.lines) cold.model.drop(line);
        cold.lines.clear();
    }
    start_ = std::nullopt;
}

}  // namespace edgewise::measure
