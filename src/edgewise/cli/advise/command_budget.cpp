// SPDX-License-Identifier: MIT
//
// `edgewise advise budget`: how few vertices a body can have. Hulls of some of its vertices, each with the
// exact worst error of any distance to it, and what it takes in time, bytes and lines.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <stdexcept>

#include "edgewise/cli/options.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/input/output_file.hpp"
#include "edgewise/reports/tables/text_grid.hpp"
#include "edgewise/studies/advise/vertex_budget.hpp"

namespace edgewise::cli {

namespace {

using studies::advise::BodyCost, studies::advise::SmallerBody;

struct BudgetArguments {
    BodyChoice body;
    std::string table = "lean_f32", algorithm = "vclip", out;
    std::optional<double> tolerance;
    std::optional<std::size_t> vertices;  ///< at most
};

constexpr input::CountRange budget_range{4, 100'000, "vertices"};

constexpr std::size_t usual_counts[] = {4,  6,   8,   12,  16,  24,  32,  48,  64,
                                        96, 128, 192, 256, 384, 512, 768, 1024};

struct Row {
    SmallerBody body;
    BodyCost cost;
    bool is_answer = false;
};

/// The body that --tolerance and --vertices ask for; of both, --vertices holds where one does not.
std::optional<SmallerBody> answer_of(const BudgetArguments& options, const Polyhedron& body) {
    if (!options.tolerance && !options.vertices) return std::nullopt;
    const std::size_t most = options.vertices.value_or(body.vertex_count());
    if (options.tolerance) {
        SmallerBody fitting = studies::advise::within_tolerance(body, *options.tolerance);
        if (fitting.vertices.size() <= most) return fitting;
    }
    return studies::advise::within_count(body, most);
}

bool is_within(const BudgetArguments& options, const SmallerBody& answer) {
    return !options.tolerance || answer.worst_error <= *options.tolerance;
}

/// By vertices; the whole body last, with no error.
std::vector<Row> rows_of(const BudgetArguments& options, const Polyhedron& body,
                         const std::optional<SmallerBody>& answer, const bench::TableType& type) {
    std::vector<Row> rows;
    for (SmallerBody& smaller :
         studies::advise::smaller_bodies(body, {std::begin(usual_counts), std::end(usual_counts)}))
        rows.push_back({std::move(smaller), {}});
    if (answer && answer->vertices.size() < body.vertex_count()) {
        const auto place = std::ranges::find_if(
            rows, [&](const Row& row) { return row.body.vertices.size() >= answer->vertices.size(); });
        if (place != rows.end() && place->body.vertices == answer->vertices) {
            place->is_answer = true;
        } else {
            rows.insert(place, {*answer, {}, true});
        }
    }
    rows.push_back({{body.vertices, 0}, {}});
    std::vector<Polyhedron> bodies;
    for (const Row& row : rows) bodies.push_back(convex_hull(row.body.vertices).or_throw());
    const std::vector<BodyCost> costs = studies::advise::costs_of(bodies, type, options.algorithm);
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].cost = costs[i];
    return rows;
}

/// OBJ with the shortest digits that read back the same.
void write_obj(const std::string& file, const SmallerBody& smaller) {
    const Polyhedron body = convex_hull(smaller.vertices).or_throw();
    std::string text;
    for (const Vec3d& v : body.vertices) text += fmt::format("v {} {} {}\n", v.x(), v.y(), v.z());
    for (Index f = 0; f < body.face_count(); ++f) {
        text += 'f';
        for (const HalfEdge h : body.ring_of_face(f)) text += fmt::format(" {}", body.tail(h) + 1);
        text += '\n';
    }
    input::write_output(file, text);
}

/// How exact "exact" is: of the body as it was read.
std::string exactness_of(const scene::MeshBody& body) {
    if (body.step == 0) return "exact";
    return fmt::format("exact for the body as it was read, in single precision (steps of {:.2g} here)",
                       body.step);
}

void print_rows(const std::vector<Row>& rows, const scene::MeshBody& body) {
    const double size = extent(body.body.vertices);
    reports::TextGrid table{"", reports::columns_of("#vertices|#worst error|#of size|#ns|#bytes|#lines| ")};
    for (const Row& row : rows)
        table.add(row.body.vertices.size(), fmt::format("{:.6g}", row.body.worst_error),
                  fmt::format("{:.2g}", row.body.worst_error / size), fmt::format("{:.0f}", row.cost.ns),
                  fmt::format("{:.0f}", row.cost.table_bytes), fmt::format("{:.1f}", row.cost.lines),
                  row.is_answer ? "<- asked" : "");
    fmt::print("{}", grid_text(table));
    fmt::print("{}\n",
               reports::wrapped(fmt::format(
                   "worst error: {}, of any distance to the smaller body, in the body's unit. It is a "
                   "hull of some of the vertices and does not contain the full body: distances are never "
                   "too short, and too long by no more than that. ns: per query of cold pairs of two such "
                   "bodies, the shortest of some rounds in one process; lines: of 64 bytes, per warm query "
                   "at 0.1 rad per step.",
                   exactness_of(body))));
}

void print_answer(const BudgetArguments& options, const SmallerBody& answer, std::size_t all) {
    std::vector<std::string> asked;
    if (options.tolerance) asked.push_back(fmt::format("{}", *options.tolerance));
    if (options.vertices) asked.push_back(fmt::format("most {} vertices", *options.vertices));
    const std::string at = fmt::format("at {}", fmt::join(asked, " and at "));
    if (answer.vertices.size() == all) {
        fmt::print("{}: all {} vertices\n", at, all);
    } else {
        fmt::print("{}: {} vertices {}, with a worst error of {:.6g} ({}{} may exist)\n", at,
                   answer.vertices.size(),
                   is_within(options, answer) ? "do" : "are not enough as they are chosen here",
                   answer.worst_error, options.out.empty() ? "--out FILE.obj writes them; " : "",
                   is_within(options, answer) ? "fewer" : "a better choice");
    }
    if (!options.out.empty()) fmt::print("written: {}\n", options.out);
}

nlohmann::json json_of(const BudgetArguments& options, const scene::MeshBody& body,
                       const std::optional<SmallerBody>& answer, const std::vector<Row>& rows) {
    nlohmann::json json = {{"body", body.name},
                           {"vertices", body.body.vertex_count()},
                           {"size", extent(body.body.vertices)},
                           {"table", options.table},
                           {"algorithm", options.algorithm},
                           {"contains", false},
                           {"tolerance", or_null(options.tolerance)},
                           {"most_vertices", or_null(options.vertices)},
                           {"read_in", body.step > 0 ? "single" : "double"},
                           {"rows", nlohmann::json::array()},
                           {"answer", nullptr}};
    for (const Row& row : rows) {
        json["rows"].push_back({{"vertices", row.body.vertices.size()},
                                {"worst_error", row.body.worst_error},
                                {"ns", row.cost.ns},
                                {"bytes", row.cost.table_bytes},
                                {"lines_per_query", row.cost.lines},
                                {"asked", row.is_answer},
                                {"of_tolerance", row.is_answer && options.tolerance.has_value()}});
    }
    if (!answer) return json;
    nlohmann::json points = nlohmann::json::array();
    for (const Vec3d& v : answer->vertices) points.push_back({v.x(), v.y(), v.z()});
    json["answer"] = {{"vertices", answer->vertices.size()},
                      {"worst_error", answer->worst_error},
                      {"within", is_within(options, *answer)},
                      {"points", points}};
    return json;
}

int run_budget(const BudgetArguments& options, bool json) {
    const scene::MeshBody body = chosen_body(options.body);
    const std::string names[] = {options.table};
    const auto types = bench::select_table_types(names);
    if (types.size() != 1 || !types.front()->serves(options.algorithm))
        throw std::invalid_argument(
            fmt::format("--table {}: wants one table type that {} runs on, such as {}", options.table,
                        options.algorithm, types.front()->name));
    const std::optional<SmallerBody> answer = answer_of(options, body.body);
    if (!options.out.empty()) {
        if (!answer)
            throw std::invalid_argument("--out writes a smaller body: add --vertices or --tolerance");
        write_obj(options.out, *answer);
    }
    const std::vector<Row> rows = rows_of(options, body.body, answer, *types.front());
    const int code = !answer || is_within(options, *answer) ? exit_done : exit_check_failed;
    if (json) {
        print_json(json_of(options, body, answer, rows));
        return code;
    }
    fmt::print("{}: {} vertices, {:.6g} in size, {} on {}\n", body.name, body.body.vertex_count(),
               extent(body.body.vertices), options.algorithm, options.table);
    print_rows(rows, body);
    if (answer) print_answer(options, *answer, body.body.vertex_count());
    return code;
}

}  // namespace

void add_budget(CLI::App& advise, Context& context) {
    auto [command, options] = add_command(
        advise, context, "budget",
        "How few vertices a body can have, and the exact worst error of distances then", run_budget);
    add_shape_option(*command, options.body.shape, options.body.as_stored);
    add_number(*command, "--tolerance", options.tolerance, input::above_0,
               "largest error of any distance, in the body's unit");
    add_count(*command, "--vertices", options.vertices, budget_range, "how many vertices at most");
    add_output_file(*command, "--out", options.out, "file to write: the smaller body as OBJ");
    add_table_option(*command, options.table);
    add_algorithm_option(*command, options.algorithm);
}

}  // namespace edgewise::cli
