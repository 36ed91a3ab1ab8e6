// SPDX-License-Identifier: MIT
//
// Prepares one cell outside any sweep, for commands that examine a single cell.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "edgewise/bench/registry.hpp"
#include "edgewise/store/rows.hpp"
#include "edgewise/sweep/prepared_cell.hpp"
#include "edgewise/truth/checked_answer.hpp"

namespace edgewise::studies {

/// A scene is a kind, or the path of a recording, which has its own bodies.
struct CellChoice {
    std::string table = "aos_f64", algorithm = "vclip", scene = "tumble", shape = "sphere386";
    scene::SceneParameters parameters = {};  ///< those that differ from the scene's defaults
    std::size_t queries = 1000;
    std::uint64_t seed = 1;
    Needs needs = Needs::witnesses;                                 ///< what is asked of every answer
    std::optional<double> margin = {};                              ///< else the usual one
    SubDistanceSolver sub_distance = SubDistanceSolver::cofactors;  ///< GJK's
    std::string peer = {};    ///< another library, as for select_peer_types, instead of table and algorithm
    std::size_t checked = 0;  ///< answers to be compared with exact ones
    bool as_stored = false;   ///< of a shape that is a mesh file (scene::MeshReading)
    std::optional<scene::NamedShape> body = {};         ///< taken instead of the named shape, in its own size
    std::function<void(const std::string&)> warn = {};  ///< called with what is odd about the mesh file
};

class SingleCell {
  public:
    /// Throws std::invalid_argument: what, where, what to do.
    explicit SingleCell(const CellChoice& choice, const bench::TableOptions& placing = {});

    [[nodiscard]] const bench::TableType& type() const { return cell_.type(); }
    [[nodiscard]] const scene::Workload& workload() const { return shared_->workload(); }
    [[nodiscard]] const std::string& algorithm() const { return algorithm_; }
    [[nodiscard]] const bench::Runner& runner() const { return cell_.runner(); }
    /// Returns the prepared cell, with its answers checked if the choice asks for it.
    [[nodiscard]] const sweep::PreparedCell& prepared() const { return cell_; }

  private:
    std::string algorithm_;
    std::unique_ptr<sweep::SharedQueries> shared_;
    sweep::PreparedCell cell_;
};

/// Returns the named row of this cell in this run; the run sets its status.
[[nodiscard]] store::CellRow row_of(const CellChoice& choice, const bench::TableType& type,
                                    const std::string& run);

/// Returns "V-Clip on lean_f32".
[[nodiscard]] std::string contender_name(const std::string& algorithm, const std::string& table);

[[nodiscard]] inline truth::AllowedErrors allowed_errors(const bench::TableType& type,
                                                         std::string_view algorithm) {
    return truth::allowed_errors(type.eps, type.rounded_planes && algorithm == "vclip");
}

}  // namespace edgewise::studies
