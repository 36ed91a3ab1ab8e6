// SPDX-License-Identifier: MIT
//
// The part of a runner that depends on its tables but not on the algorithm: builds and measures them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "edgewise/bench/runner.hpp"
#include "edgewise/layout_parts/write_geometry.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/table/stored_body.hpp"
#include "edgewise/table/table_memory.hpp"

namespace edgewise::bench {

template <class Table>
class TableRunner : public Runner {
  public:
    /// parts: of every table.
    explicit TableRunner(Parts parts) : Runner(std::is_same_v<ComputeOf<Table>, float>), parts_(parts) {}

    [[nodiscard]] Ledger ledger() const override { return tables_[0].ledger(); }
    [[nodiscard]] std::size_t object_bytes() const override { return sizeof(Table); }

    [[nodiscard]] std::vector<TableMap> memory_maps() const override {
        std::vector<TableMap> maps;
        for (std::size_t i = 0; i < tables_.size(); ++i)
            maps.push_back({memory_map(tables_[i].pieces(), table_allocator().base()),
                            bodies_[i]->vertex_count(), bodies_[i]->edge_count(), bodies_[i]->face_count()});
        return maps;
    }
    [[nodiscard]] std::vector<FieldMap> field_maps() const override {
        std::vector<FieldMap> maps;
        if constexpr (requires { tables_[0].field_map(nullptr); })
            for (const Table& table : tables_) maps.push_back(table.field_map(table_allocator().base()));
        return maps;
    }

    /// Build times in memory that was not used before, where the allocator has such memory.
    [[nodiscard]] BuildTimes build_times(int repetitions) const override {
        const auto memory = make_allocator(options().tables.allocator);
        const TablesIn placed(*memory);
        const Polyhedron& body = prepared().bodies()[0];
        const Polyhedron larger = scene::scaled(body, 2);
        Table refitted(body, parts_);
        const double clock = measure::calibrate();
        BuildTimes times;
        for (int i = 0; i < repetitions; ++i) {
            const measure::Stopwatch build_watch;
            const Table fresh(body, parts_);
            times.build_ns.push_back(std::max(0.0, build_watch.elapsed_ns() - clock));
            if constexpr (Refittable<Table>) {
                const measure::Stopwatch refit_watch;
                refit(refitted, i % 2 == 0 ? larger : body);
                times.refit_ns.push_back(std::max(0.0, refit_watch.elapsed_ns() - clock));
            }
        }
        return times;
    }

  protected:
    [[nodiscard]] const std::vector<Table>& tables() const { return tables_; }

  private:
    [[nodiscard]] Result<Polyhedron> store(const Polyhedron& body) const override {
        return stored_body<Table>(body);
    }

    void build_tables(const std::vector<const Polyhedron*>& bodies) override {
        tables_.clear();
        bodies_ = bodies;
        for (const Polyhedron* body : bodies) tables_.emplace_back(*body, parts_);
    }

    [[nodiscard]] std::size_t table_count() const override { return tables_.size(); }
    /// 1 except for lazy tables.
    [[nodiscard]] double materialised() const override {
        double part = 1;
        if constexpr (requires { tables_[0].materialised(); }) {
            part = 0;
            for (const Table& table : tables_)
                part += table.materialised() / static_cast<double>(tables_.size());
        }
        return part;
    }

    Parts parts_;
    std::vector<Table> tables_;
    std::vector<const Polyhedron*> bodies_;  ///< of the tables
};

}  // namespace edgewise::bench
