// SPDX-License-Identifier: MIT
//
// The queries of golden_answers once more, in a program without the tool and without Qhull, which can be
// cross-compiled: reads bodies and poses that `golden_answers --questions` wrote, and prints the same hashes
// of each algorithm's answers and of the tables' bytes, to be compared with answers.txt. Batches in lanes
// must be the bits of single queries.
#pragma once

#include <bit>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/query_batch.hpp"
#include "edgewise/algorithms/vclip.hpp"

namespace edgewise::golden {

/// Numbers as golden_answers writes them: the bits of doubles as whole numbers.
class Numbers {
  public:
    explicit Numbers(const char* file) : file_(file) {}

    /// Reads a text in quotes. Returns false at the end of the file.
    [[nodiscard]] bool text(std::string& to) { return static_cast<bool>(file_ >> std::quoted(to)); }
    [[nodiscard]] std::uint64_t whole() {
        std::uint64_t number = 0;
        if (!(file_ >> number)) std::abort();
        return number;
    }
    [[nodiscard]] Vec3d vector() {
        Vec3d v;
        for (int i = 0; i < 3; ++i) v[i] = std::bit_cast<double>(whole());
        return v;
    }
    template <class Number>
    void list(std::vector<Number>& to) {
        to.resize(whole());
        for (Number& number : to) number = static_cast<Number>(whole());
    }

  private:
    std::ifstream file_;
};

struct Question {
    std::size_t body_a, body_b, pair;
    Pose pose_a, pose_b;
};

struct Questions {
    std::string set;  ///< begins the rows of answers
    bool warm;
    std::size_t pairs;
    std::vector<Polyhedron> bodies;
    std::vector<Question> queries;
};

[[nodiscard]] inline Polyhedron read_body(Numbers& from) {
    Polyhedron body;
    body.vertices.resize(from.whole());
    for (Vec3d& vertex : body.vertices) vertex = from.vector();
    body.edges.resize(from.whole());
    for (PolyhedronEdge& edge : body.edges)
        for (Index* end : {&edge.tail, &edge.head, &edge.left, &edge.right})
            *end = static_cast<Index>(from.whole());
    body.face_planes.resize(from.whole());
    for (Plane<double>& plane : body.face_planes) {
        plane.normal = from.vector();
        plane.offset = std::bit_cast<double>(from.whole());
    }
    from.list(body.input_index);
    from.list(body.face_offset);
    from.list(body.face_ring);
    from.list(body.vertex_offset);
    from.list(body.vertex_ring);
    return body;
}

[[nodiscard]] inline Pose read_pose(Numbers& from) {
    Pose pose;
    for (int row = 0; row < 3; ++row) pose.rotation.row(row) = from.vector();
    pose.translation = from.vector();
    return pose;
}

[[nodiscard]] inline std::vector<Questions> read_questions(const char* file) {
    Numbers from(file);
    std::vector<Questions> all;
    for (std::string set; from.text(set);) {
        Questions& one = all.emplace_back();
        one.set = set;
        one.warm = from.whole() != 0;
        one.pairs = from.whole();
        one.bodies.resize(from.whole());
        for (Polyhedron& body : one.bodies) body = read_body(from);
        one.queries.resize(from.whole());
        for (Question& query : one.queries) {
            for (std::size_t* number : {&query.body_a, &query.body_b, &query.pair}) *number = from.whole();
            query.pose_a = read_pose(from);
            query.pose_b = read_pose(from);
        }
    }
    return all;
}

/// FNV-1a, as bench::Fingerprint.
class Hash {
  public:
    void add(std::uint64_t number) {
        for (int byte = 0; byte < 8; ++byte) state_ = (state_ ^ (number >> 8 * byte & 0xff)) * 0x100000001b3;
    }
    void add(const Vec3d& v) {
        for (int i = 0; i < 3; ++i) add(std::bit_cast<std::uint64_t>(v[i]));
    }
    void add(const Distance& answer) {
        add(static_cast<std::uint64_t>(answer.status));
        add(std::bit_cast<std::uint64_t>(answer.distance));
        add(answer.point_a);
        add(answer.point_b);
        for (const int count : {answer.steps, answer.cycles, answer.fallbacks, answer.refinements})
            add(static_cast<std::uint64_t>(count));
    }
    [[nodiscard]] std::uint64_t value() const { return state_; }

  private:
    std::uint64_t state_ = 0xcbf29ce484222325;
};

template <class Algorithm, class Table>
[[nodiscard]] std::vector<Distance> answer(const Questions& questions, const std::vector<Table>& tables) {
    using Pair = typename Algorithm::template Pair<Table, Table>;
    std::vector<std::optional<Pair>> pairs(questions.pairs);
    std::vector<Distance> answers;
    for (const Question& query : questions.queries) {
        const Table &a = tables[query.body_a], &b = tables[query.body_b];
        std::optional<Pair>& pair = pairs[query.pair];
        if (!questions.warm || !pair) pair.emplace(a, b);
        answers.push_back(Algorithm::query(a, b, relative_pose(query.pose_a, query.pose_b), *pair));
    }
    return answers;
}

/// Returns the answers of the cold queries in lanes of 128 bits.
template <class Table>
[[nodiscard]] std::vector<Distance> answer_in_lanes(const Questions& questions,
                                                    const std::vector<Table>& tables) {
    std::vector<SimplexPair<Table, Table>> pairs;
    for (const Question& query : questions.queries)
        pairs.emplace_back(tables[query.body_a], tables[query.body_b]);
    std::vector<PairQuery<Table, Table>> queries;
    for (const Question& query : questions.queries)
        queries.push_back({&tables[query.body_a], &tables[query.body_b],
                           relative_pose(query.pose_a, query.pose_b), &pairs[queries.size()]});
    std::vector<Distance> answers(queries.size());
    query_batch<Table, Table>(queries, answers);
    return answers;
}

[[nodiscard]] inline std::uint64_t hash_of(const std::vector<Distance>& answers) {
    Hash hash;
    for (const Distance& answer : answers) hash.add(answer);
    return hash.value();
}

/// Prints the rows of an algorithm on a table type as answers.txt has them. Returns false if a batch differs
/// from single queries.
template <class Algorithm, class Table>
[[nodiscard]] bool print_rows_of(const char* name, const std::vector<Questions>& all) {
    std::map<std::string, Hash> hashes;
    bool lanes_agree = true;
    for (const Questions& questions : all) {
        std::vector<Table> tables;
        for (const Polyhedron& body : questions.bodies) tables.emplace_back(body, Algorithm::parts);
        Hash& bytes = hashes["bytes "];
        for (const std::uint64_t number : tables[0].ledger().bytes) bytes.add(number);
        bytes.add(sizeof(Table));
        bytes.add(sizeof(typename Algorithm::template Pair<Table, Table>));
        const std::vector<Distance> answers = answer<Algorithm>(questions, tables);
        for (const Distance& answer : answers) hashes[questions.set].add(answer);
        if constexpr (std::is_same_v<Algorithm, Gjk>)
            lanes_agree = lanes_agree &&
                          (questions.warm || hash_of(answers) == hash_of(answer_in_lanes(questions, tables)));
    }
    for (const auto& [set, hash] : hashes)
        std::printf("%s%s %s %016" PRIx64 "\n", set.c_str(), name, Algorithm::name.data(), hash.value());
    if (!lanes_agree) std::printf("%s: lanes differ from single queries\n", name);
    return lanes_agree;
}

/// Prints the rows of a table type.
template <class Table>
[[nodiscard]] bool print_rows(const char* name, const char* file) {
    const std::vector<Questions> all = read_questions(file);
    bool agrees = print_rows_of<Gjk, Table>(name, all);
    if constexpr (FeatureTable<Table>) agrees = print_rows_of<VClip, Table>(name, all) && agrees;
    return agrees;
}

}  // namespace edgewise::golden
