// SPDX-License-Identifier: MIT
//
// How often a cell's scene reads each vertex, edge and face of its body, as the sweep keeps it in the store;
// and the body seen from one side with its features coloured by that. The script of the page draws the same
// paths again when the body is turned.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

struct HeatBody {
    std::vector<std::array<double, 3>> vertices;
    std::vector<std::array<std::uint32_t, 2>> edges;  ///< tail and head
    std::vector<std::vector<std::uint32_t>> faces;    ///< counter-clockwise from outside
};

/// Reads of each feature of a kind per query; null if the layout stores no data for these features.
using FeatureReads = std::optional<std::vector<double>>;

struct BodyHeat {
    const ReportCell* cell = nullptr;
    FeatureReads vertices, edges, faces;

    /// Returns "V-Clip on aos_f64, tumble (rotation_step 1), sphere386".
    [[nodiscard]] std::string title() const;
    /// Says for each kind of feature how many were read at all, and how often the hottest.
    [[nodiscard]] std::string sentence() const;
};

// One query's walk, step by step, as the sweep keeps it in the store: on both bodies the features that V-Clip
// visits, or the corners of GJK's simplex; next to them the cache lines that each step reads, for every table
// type that took these steps. The script of the page shows one step of these drawings at a time.

/// One path for what stays, and one for each step, with a caption.
struct WalkDrawing {
    std::string name;  ///< "Body A", or a table type
    std::string box;   ///< its view box
    std::string ground;
    std::vector<std::string> steps = {}, said = {};
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(WalkDrawing, name, box, ground, steps, said)

struct BodyWalk {
    std::string title;                ///< "V-Clip, tumble (rotation_step 1), sphere386, query 7"
    std::vector<std::string> said;    ///< what each step is
    std::vector<WalkDrawing> bodies;  ///< A, then B
    std::vector<WalkDrawing> tables;  ///< the baseline's first, the one with the fewest lines last
    std::size_t lines_of_last = 0;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BodyWalk, title, said, bodies, tables)

/// Adds the walk of a cell, `json` as the store has it: to the walk with the same steps, or as a new one.
/// Leaves out what does not fit the body.
void add_walk(const nlohmann::json& json, const ReportCell& cell, const HeatBody& body,
              std::vector<BodyWalk>& walks);

/// Returns the last step as a figure with its caption; `style`: "trail" for a body, "lines" for a table.
[[nodiscard]] std::string walk_figure(const WalkDrawing& drawing, const char* style);

struct HeatOnBodies {
    std::map<std::string, HeatBody> bodies;  ///< by shape
    std::vector<BodyHeat> heats;  ///< of bodies that are there; the reference shape's baseline first
    std::vector<BodyWalk> walks;  ///< of these heats' cells, in the same order
};

/// The largest number of heats in a page.
inline constexpr std::size_t most_heats = 24;

/// Reads all heats of a store; leaves out malformed bodies and unfitting heats. The data must outlive it.
[[nodiscard]] HeatOnBodies heat_on_bodies(const ReportData& data);

/// Number of levels, from 0, never read, to 5; logarithmic up to the hottest feature of its kind.
inline constexpr std::size_t heat_levels = 6;
[[nodiscard]] std::size_t heat_level(double reads, double most);

/// Angles of the first view, in radians: about the vertical axis, then about the horizontal one.
inline constexpr double body_yaw = 0.6, body_pitch = 0.4;

/// A point of a picture that is body_size wide and high; y downwards.
struct BodyPoint {
    double x = 0, y = 0;
};
inline constexpr double body_size = 420;

/// Returns the mean of the vertices.
[[nodiscard]] std::array<double, 3> middle_of(const HeatBody& body);
/// Returns the vertices seen along the negative z axis after both turns, in radians as above.
[[nodiscard]] std::vector<BodyPoint> seen_points(const HeatBody& body, double yaw, double pitch);
/// Returns a closed path through these vertices; empty if there are none.
[[nodiscard]] std::string ring_path(const std::vector<std::uint32_t>& ring,
                                    const std::vector<BodyPoint>& points);
/// Returns a path for each face; empty for those that face away.
[[nodiscard]] std::vector<std::string> face_paths(const HeatBody& body, const std::vector<BodyPoint>& points);

[[nodiscard]] std::string body_svg(const HeatBody& body, const BodyHeat& heat);

/// Returns the bodies and their heats as JSON for the script: {"bodies": {shape: {"vertices", "edges",
/// "faces"}}, "heats": [{"title", "said", "shape", "scene", "algorithm", "precision", "vertices", "edges",
/// "faces"}], "walks": a list of BodyWalk}.
[[nodiscard]] std::string bodies_data(const HeatOnBodies& heat);

}  // namespace edgewise::reports
