// SPDX-License-Identifier: MIT
//
// A first look at every algorithm on every table type for one case: is it right, how exact, how large, and
// roughly how fast. Short and in this process, without an interval: it only drops cells that need no closer
// look.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "edgewise/bench/registry.hpp"
#include "edgewise/measure/cache/cache_machine.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/sweep/plan.hpp"
#include "edgewise/table/needs.hpp"

namespace edgewise::studies::advise {

// The case that advice is asked for: which body, in which scene, how tables are shared, and how exact answers
// have to be.

struct CaseAsked {
    scene::NamedShape shape;
    std::string mesh;          ///< the file that the shape is of; empty: built-in
    bool as_stored = false;    ///< of the mesh, or those of the recording (scene::MeshReading)
    sweep::SceneChoice scene;  ///< a kind of scene with its parameters
    std::string recording;     ///< the file that the scene replays; `shape` is then its first core
    bool own_tables = false;   ///< a table for each body; else one for all
    Needs needs = Needs::distance;
    double error_limit = 1e-6;  ///< of a distance, divided by the scale of the pair
    std::uint64_t seed = 1;
};

/// Returns a scene of plan `quick`, which asks frame after frame as an engine does: `tumble`, and of bodies
/// with tables of their own `pressure`. Each body turns by `rotation_step` rad per step.
[[nodiscard]] sweep::SceneChoice usual_scene(bool own_tables, std::size_t bodies, double rotation_step);

inline constexpr double usual_turn = 0.1;  ///< rad per step
[[nodiscard]] constexpr std::size_t usual_bodies(bool own_tables) { return own_tables ? 200 : 12; }

/// Returns true if the kind of scene can be run both with a shared table and with a table for each body.
[[nodiscard]] bool can_share(const CaseAsked& asked);

/// Returns the scene with the tables shared as asked.
[[nodiscard]] sweep::SceneChoice scene_of(const CaseAsked& asked);

/// Returns "tumble, bodies 300, 386 vertices (sphere386), a table each, distance, error <= 1e-06".
[[nodiscard]] std::string sentence_of(const CaseAsked& asked);

/// Why a cell is dropped; the first reason that applies.
enum class DroppedFor {
    nothing,
    failure,  ///< its tables cannot hold the body, or an answer is wrong
    error,    ///< right, and not as exact as was asked
    time,     ///< and slow is all that is wrong with it
};

struct ScreenedCell {
    const bench::TableType* type = nullptr;
    std::string algorithm;
    double bytes_per_edge = 0, table_bytes = 0;
    double error = 0;    ///< worst of the checked answers against the bodies as given, divided by the scale
    double ns = 0;       ///< per query, the shortest pass
    double seconds = 0;  ///< that the look took, without its passes: tables, answers, checks
    DroppedFor dropped_for = DroppedFor::nothing;
    std::string dropped;  ///< why, in words; empty: it is not

    [[nodiscard]] bool is_in() const { return dropped_for == DroppedFor::nothing; }
    [[nodiscard]] bool is_baseline() const;
    [[nodiscard]] std::string name() const;  ///< "V-Clip on lean_f32"
};

struct ScreenOptions {
    std::size_t queries = 1500, checked = 60;
    int passes = 3;
    double slowest = 1.3;  ///< times the fastest that is not dropped; slower cells are dropped
};

struct Screen {
    std::vector<ScreenedCell> cells;  ///< fastest first; dropped ones last
    std::size_t left_out = 0;         ///< cells that are missing, since `stop` said so

    /// Returns true if it is among the cells and was dropped for its error.
    [[nodiscard]] bool is_inexact(const std::string& name) const;
};

/// `stop` is asked before each cell; the baseline, which is never dropped for its time, is the first.
[[nodiscard]] Screen screen(const CaseAsked& asked, const ScreenOptions& options,
                            const std::function<bool()>& stop);

// What another question would change in an advice: the tables shared the other way, a larger error allowed, a
// smaller one asked for.

/// The recommended cell.
struct Taken {
    std::string name;  ///< "V-Clip on lean_f32"
    double bytes_per_edge = 0, error = 0;
};

/// Returns one sentence per change. `other_tables`: cells that pass with the tables shared the other way,
/// fastest first; null: the other sharing was not looked at.
[[nodiscard]] std::vector<std::string> what_would_change(const CaseAsked& asked, const Screen& screen,
                                                         const std::vector<ScreenedCell>& other_tables,
                                                         const Taken& taken);

// How many processes and rounds of a race fit into a time, given how long its parts took in the first look.
// More processes come before more rounds, because an interval is between processes.

/// Durations of the parts of a race, in seconds.
struct RaceCost {
    double process = 0;  ///< of each process, before its rounds: bodies and tables made, answers checked
    double round = 0;    ///< every cell timed once
    double traces = 0;   ///< lines and caches, of the processes that trace
};

struct RacePlan {
    int processes = 3, rounds = 25;
};

inline constexpr RacePlan whole_race{}, least_race{1, 5};

/// Returns the seconds that the race is expected to take. The first process does its part twice: for the
/// case, and for a few bodies that fit the cache.
[[nodiscard]] double race_seconds(const RaceCost& cost, const RacePlan& plan);

/// Returns the largest race that is expected to end within `seconds`; the smallest race if none is.
[[nodiscard]] RacePlan race_within(double seconds, const RaceCost& cost);

// A limit of time for work in pieces that cannot be left half-way: a piece is begun only where one as long as
// the longest so far would end in time.

class TimeLimit {
  public:
    /// `clock`: seconds since any moment; `end`: when it has to be over, by that clock.
    TimeLimit(std::function<double()> clock, double end) : clock_(std::move(clock)), end_(end) {}

    /// Call it before each piece, which lasts until the next call. Returns true if there is time for one.
    [[nodiscard]] bool begin_piece();

    /// Returns the seconds left; negative after the end.
    [[nodiscard]] double left() const { return end_ - clock_(); }

  private:
    std::function<double()> clock_;
    double end_, longest_ = 0;
    std::optional<double> begun_;  ///< the piece in hand
};

// Predicts the time of a query from its modelled misses, to be shown next to the measured time.

/// Name of this machine among the machines with modelled caches.
inline constexpr const char* this_machine = "host";

/// Cost of cache misses for one cell.
struct CacheCost {
    std::optional<double> in_cache_ns;  ///< per query, few bodies with one table; null: no time was left
    /// Modelled misses per query, by machine, level by level from the first on.
    std::map<std::string, std::vector<double>> misses;
    std::map<std::string, double> predicted_ns;  ///< per query, by machine
};

/// Predicts for each machine with modelled misses: the time in cache, plus for each miss the latency of the
/// level that answers it, without overlap. `latencies_ns`: of this machine, for each level beyond the first,
/// memory last; they also replace the unknown latencies of other machines.
void predict(CacheCost& cost, std::span<const double> latencies_ns);

}  // namespace edgewise::studies::advise
