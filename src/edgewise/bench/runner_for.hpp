// SPDX-License-Identifier: MIT
//
// The runner of one algorithm on one table type. Included by the generated registry units only, so that each
// table type compiles apart and in parallel.
#pragma once

#include <cassert>
#include <exception>
#include <memory>
#include <type_traits>
#include <utility>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/bench/cold_starts.hpp"
#include "edgewise/bench/length_scale.hpp"
#include "edgewise/bench/memory/allocators.hpp"
#include "edgewise/bench/name_answer.hpp"
#include "edgewise/bench/runner.hpp"
#include "edgewise/bench/time_builds.hpp"
#include "edgewise/bench/trace/trace_queries.hpp"
#include "edgewise/geometry/vertex_order.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/table/stored_body.hpp"
#include "edgewise/table/table_memory.hpp"

namespace edgewise::bench {

/// TracedTable: the same layout with a loader that tells a TraceSink.
template <class Algorithm, class Table, class TracedTable>
class RunnerFor final : public Runner {
  public:
    using Pair = typename Algorithm::template Pair<Table, Table>;

    using Runner::load;

    void set_options(const QueryOptions& options) override {
        options_ = options;
        options_.verdict_only = needs_ == Needs::verdict;
    }
    void set_needs(Needs needs) override {
        needs_ = needs;
        options_.verdict_only = needs == Needs::verdict;
    }
    void place_tables(const TableOptions& options) override { placing_ = options; }

    [[nodiscard]] std::string load(std::span<const Polyhedron> bodies,
                                   std::span<const std::uint32_t> instances) override {
        bodies_.clear();
        in_tables_.clear();
        tables_.clear();
        length_scale_ = LengthScale(bodies);
        for (const Polyhedron& body : bodies) {
            auto stored = stored_body<Table>(length_scale_.into(body));
            if (stored) stored = reordered(*stored, placing_.order);
            if (!stored) return stored.error;
            bodies_.push_back(length_scale_.back(*stored));
            in_tables_.push_back(std::move(*stored));
        }
        table_each_ = !instances.empty();
        instances_.assign(instances.begin(), instances.end());
        try {
            build_tables();
        } catch (const std::exception& problem) {  // an allocator that is not there, or has no more
            return std::string("tables: ") + problem.what();
        }
        return {};
    }

    [[nodiscard]] std::span<const Polyhedron> stored_bodies() const override { return bodies_; }

    [[nodiscard]] std::vector<Distance> answer(const scene::Workload& given) const override {
        scene::Workload space;
        const scene::Workload& workload = in_length_scale(given, space);
        std::vector<Distance> answers(workload.queries.size());
        run(workload, 0, answers.size(), cold_pairs(workload), [&](std::size_t i, const Distance& d) {
            answers[i] = in_range(workload.queries[i]) ? length_scale_.back(d) : Distance{};
        });
        return answers;
    }

    [[nodiscard]] NamedAnswer answer(const scene::Query& given) const override {
        const scene::Query query = length_scale_.into(orthonormalised(given));
        if (!in_range(query)) return {};
        const Table& a = table_a(query);
        const Table& b = table_b(query);
        Pair pair(a, b);
        NamedAnswer result;
        tell_more(query, pair, ask_plain(query, pair), Needs::depth, result);
        return length_scale_.back(std::move(result));
    }

    [[nodiscard]] measure::Timing time(const scene::Workload& given, std::span<const std::uint8_t> in_contact,
                                       double clock_cost_ns) const override {
        scene::Workload space;
        const scene::Workload& workload = in_length_scale(given, space);
        assert(in_contact.size() == workload.queries.size());
        measure::Timing timing;
        std::vector<Pair> pairs = cold_pairs(workload);
        double sum = 0;  // of all distances: an answer nobody reads might not be computed
        const auto add = [&](std::size_t, const Distance& d) { sum += d.distance; };
        const std::vector<std::uint8_t> cold = cold_starts(workload);
        for (std::size_t first = 0; first < in_contact.size();) {
            if (cold[first]) {
                run(workload, first, first + 1, pairs, add);
                ++first;
                continue;
            }
            const std::size_t last = end_of_stretch(cold, in_contact, first);
            const measure::Stopwatch watch;
            run(workload, first, last, pairs, add);
            const double ns = std::max(0.0, watch.elapsed_ns() - clock_cost_ns);
            (in_contact[first] ? timing.overlapping_ns : timing.separated_ns) += ns;
            (in_contact[first] ? timing.overlapping_queries : timing.separated_queries) += last - first;
            first = last;
        }
        volatile double sink = sum;
        static_cast<void>(sink);
        return timing;
    }

    [[nodiscard]] Ledger ledger() const override { return tables_[0].ledger(); }

    [[nodiscard]] measure::MemoryUse memory() const override {
        measure::MemoryUse use;
        use.tables = tables_.size();
        use.requested = static_cast<double>(memory_->requested());
        use.taken = static_cast<double>(memory_->taken());
        if (const auto resident = memory_->resident()) use.resident = static_cast<double>(*resident);
        if constexpr (requires { tables_[0].materialised(); }) {
            use.materialised = 0;
            for (const Table& table : tables_)
                use.materialised += table.materialised() / static_cast<double>(tables_.size());
        }
        return use;
    }

    [[nodiscard]] measure::BuildTimes build_times(int repetitions) const override {
        const auto memory = make_allocator(placing_.allocator);
        const TablesIn placed(*memory);
        return time_builds<Table>(in_tables_[0], Algorithm::parts, repetitions);
    }

    PassSum trace(const scene::Workload& given, std::size_t limit,
                  measure::TraceListener& listener) const override {
        scene::Workload space;
        const scene::Workload& workload = in_length_scale(given, space);
        const TracePlaces places(memory_->base(), memory_->taken(), sizeof(Pair), workload.pair_count,
                                 workload.instances.size());
        return length_scale_.back(trace_queries<Algorithm, TracedTable>(
            workload, limit, length_scale_.into(options_), places,
            [this](const scene::Query& query) { return std::pair(&table_a(query), &table_b(query)); },
            listener));
    }

    [[nodiscard]] std::function<PassSum()> prepared_pass(const scene::Workload& given) const override {
        return [this, count = given.queries.size(), pass = prepared_range(given)] {
            return length_scale_.back(PassSum{count, pass(0, count)});
        };
    }

    [[nodiscard]] RangePass prepared_range(const scene::Workload& given) const override {
        auto space = std::make_shared<scene::Workload>();
        const scene::Workload* workload = &in_length_scale(given, *space);
        const std::vector<Pair> cold = cold_pairs(*workload);
        return [this, space, workload, cold, pairs = cold](std::size_t first, std::size_t last) mutable {
            if (first == 0) std::copy(cold.begin(), cold.end(), pairs.begin());
            double sum = 0;
            run(*workload, first, last, pairs, [&](std::size_t, const Distance& d) { sum += d.distance; });
            return sum;
        };
    }

    [[nodiscard]] std::size_t pair_bytes() const override { return sizeof(Pair); }

    [[nodiscard]] const TableAllocator& table_allocator() const override { return *memory_; }

    [[nodiscard]] std::vector<TableMap> memory_maps() const override {
        std::vector<TableMap> maps;
        for (std::size_t i = 0; i < tables_.size(); ++i) {
            const Polyhedron& body = in_tables_[table_each_ ? instances_[i] : i];
            maps.push_back({memory_map(tables_[i].pieces(), memory_->base()), body.vertex_count(),
                            body.edge_count(), body.face_count()});
        }
        return maps;
    }

  private:
    /// Where the options say: one a body, or one an instance.
    void build_tables() {
        memory_ = make_allocator(placing_.allocator);
        const TablesIn placed(*memory_);
        for (const std::uint32_t body : instances_) tables_.emplace_back(in_tables_[body], Algorithm::parts);
        if (table_each_) return;
        for (const Polyhedron& body : in_tables_) tables_.emplace_back(body, Algorithm::parts);
    }

    [[nodiscard]] const Table& table_a(const scene::Query& query) const {
        return tables_[table_each_ ? query.instance_a : query.body_a];
    }
    [[nodiscard]] const Table& table_b(const scene::Query& query) const {
        return tables_[table_each_ ? query.instance_b : query.body_b];
    }

    [[nodiscard]] scene::Query orthonormalised(scene::Query query) const {
        query.pose_a = edgewise::orthonormalised(query.pose_a, bodies_[query.body_a].vertices[0]);
        query.pose_b = edgewise::orthonormalised(query.pose_b, bodies_[query.body_b].vertices[0]);
        return query;
    }

    /// The workload in the runner's unit and with rotations that are some; a copy in `space` unless it is in
    /// it already.
    [[nodiscard]] const scene::Workload& in_length_scale(const scene::Workload& given,
                                                         scene::Workload& space) const {
        const auto is_ready = [](const scene::Query& query) {
            return is_orthonormalised(query.pose_a) && is_orthonormalised(query.pose_b);
        };
        if (length_scale_.is_one() && std::all_of(given.queries.begin(), given.queries.end(), is_ready))
            return given;
        space.pair_count = given.pair_count;
        space.warm = given.warm;
        space.instances = given.instances;
        space.frames = given.frames;
        for (const scene::Query& query : given.queries)
            space.queries.push_back(length_scale_.into(orthonormalised(query)));
        return space;
    }

    /// Whether the offset between the bodies can be computed with: not too long, nor, between points at their
    /// origins, too short.
    [[nodiscard]] bool in_range(const scene::Query& query) const {
        constexpr bool single = std::is_same_v<ComputeOf<Table>, float>;
        const double offset = max_abs(relative_pose(query.pose_a, query.pose_b).translation);
        const double size = std::max(offset, length_scale_.reach());
        return offset <= (single ? largest_coordinate_single : largest_coordinate) &&
               (size == 0 || size >= (single ? smallest_extent_single : smallest_extent));
    }

    [[nodiscard]] Distance ask_plain(const scene::Query& query, Pair& pair) const {
        return Algorithm::query(table_a(query), table_b(query), relative_pose(query.pose_a, query.pose_b),
                                pair, length_scale_.into(options_));
    }

    [[nodiscard]] Distance ask(const scene::Query& query, Pair& pair) const {
        const Distance answer = ask_plain(query, pair);
        if (needs_ > Needs::witnesses) pay_for_more(query, pair, answer);
        return answer;
    }

    /// What is asked beyond distance and witnesses, worked out and thrown away.
    [[gnu::noinline]] void pay_for_more(const scene::Query& query, const Pair& pair,
                                        const Distance& answer) const {
        NamedAnswer more;
        tell_more(query, pair, answer, needs_, more);
        volatile double sink = more.depth;
        if (needs_ == Needs::certificate) sink = certified_width(more, query, in_tables_);
        static_cast<void>(sink);
    }

    void tell_more(const scene::Query& query, const Pair& pair, const Distance& distance, Needs needs,
                   NamedAnswer& result) const {
        name_answer(AskedPair<Table>{table_a(query), table_b(query), bodies_[query.body_a],
                                     bodies_[query.body_b], query},
                    pair, distance, needs, result);
    }

    /// One cache for each pair of a warm scene, each on its own bodies' tables.
    [[nodiscard]] std::vector<Pair> cold_pairs(const scene::Workload& workload) const {
        if (!workload.warm) return {};
        std::vector<Pair> pairs(workload.pair_count, Pair(tables_[0], tables_[0]));
        for (const scene::Query& query : workload.queries) {
            pairs[query.pair] = Pair(table_a(query), table_b(query));
        }
        return pairs;
    }

    template <class Pairs, class Use>
    void run(const scene::Workload& workload, std::size_t first, std::size_t last, Pairs&& pairs,
             Use use) const {
        for (std::size_t i = first; i < last; ++i) {
            const scene::Query& query = workload.queries[i];
            if (workload.warm) {
                use(i, ask(query, pairs[query.pair]));
            } else {
                Pair pair(table_a(query), table_b(query));
                use(i, ask(query, pair));
            }
        }
    }

    LengthScale length_scale_;
    QueryOptions options_;
    Needs needs_ = Needs::witnesses;
    TableOptions placing_;
    std::unique_ptr<TableAllocator> memory_;  ///< what the tables stand in
    std::vector<Polyhedron> bodies_;          ///< as stored, in the given unit
    std::vector<Polyhedron> in_tables_;       ///< the same in the unit: what the tables were built from
    bool table_each_ = false;                 ///< one for each instance, not for each body
    std::vector<std::uint32_t> instances_;    ///< then, the body of each
    std::vector<Table> tables_;
};

}  // namespace edgewise::bench
