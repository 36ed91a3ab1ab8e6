// SPDX-License-Identifier: MIT
//
// The part of a runner that depends on its tables but not on the algorithm: builds and measures them.
#pragma once

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

/// Build times for a body that the table can store, as Runner::build_times defines them.
template <class Table>
[[nodiscard]] BuildTimes time_builds(const Polyhedron& body, Parts parts, int repetitions) {
    const Polyhedron larger = scene::scaled(body, 2);
    Table refitted(body, parts);
    BuildTimes times;
    for (int i = 0; i < repetitions; ++i) {
        const measure::Stopwatch build_watch;
        const Table fresh(body, parts);
        times.build_ns.push_back(build_watch.elapsed_ns());
        if constexpr (Refittable<Table>) {
            const measure::Stopwatch refit_watch;
            refit(refitted, i % 2 == 0 ? larger : body);
            times.refit_ns.push_back(refit_watch.elapsed_ns());
        }
    }
    return times;
}

/// Mean part of the tables' bytes that was ever made: 1 except for lazy tables.
template <class Table>
[[nodiscard]] double mean_materialised(const std::vector<Table>& tables) {
    double part = 1;
    if constexpr (requires { tables[0].materialised(); }) {
        part = 0;
        for (const Table& table : tables) part += table.materialised() / static_cast<double>(tables.size());
    }
    return part;
}

/// Maps of one table for each body; offsets from `base`.
template <class Table>
[[nodiscard]] std::vector<TableMap> maps_of(const std::vector<Table>& tables,
                                            const std::vector<const Polyhedron*>& bodies,
                                            const std::byte* base) {
    std::vector<TableMap> maps;
    for (std::size_t i = 0; i < tables.size(); ++i) {
        const Polyhedron& body = *bodies[i];
        maps.push_back({memory_map(tables[i].pieces(), base), body.vertex_count(), body.edge_count(),
                        body.face_count()});
    }
    return maps;
}

/// Maps of the fields of tables that declare them; offsets from `base`.
template <class Table>
[[nodiscard]] std::vector<FieldMap> field_maps_of(const std::vector<Table>& tables, const std::byte* base) {
    std::vector<FieldMap> maps;
    if constexpr (requires { tables[0].field_map(base); })
        for (const Table& table : tables) maps.push_back(table.field_map(base));
    return maps;
}

template <class Table>
class TableRunner : public Runner {
  public:
    /// parts: of every table.
    explicit TableRunner(Parts parts) : Runner(std::is_same_v<ComputeOf<Table>, float>), parts_(parts) {}

    [[nodiscard]] Ledger ledger() const override { return tables_[0].ledger(); }
    [[nodiscard]] std::size_t object_bytes() const override { return sizeof(Table); }

    [[nodiscard]] std::vector<TableMap> memory_maps() const override {
        return maps_of(tables_, bodies_, table_allocator().base());
    }
    [[nodiscard]] std::vector<FieldMap> field_maps() const override {
        return field_maps_of(tables_, table_allocator().base());
    }

    /// Build times in memory that was not used before, where the allocator has such memory.
    [[nodiscard]] BuildTimes build_times(int repetitions) const override {
        const auto memory = make_allocator(options().tables.allocator);
        const TablesIn placed(*memory);
        return time_builds<Table>(prepared().bodies()[0], parts_, repetitions);
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
    [[nodiscard]] double materialised() const override { return mean_materialised(tables_); }

    Parts parts_;
    std::vector<Table> tables_;
    std::vector<const Polyhedron*> bodies_;  ///< of the tables
};

}  // namespace edgewise::bench
