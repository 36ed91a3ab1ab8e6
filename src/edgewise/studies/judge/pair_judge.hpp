// SPDX-License-Identifier: MIT
//
// One pair, and all answers to it: of every algorithm on every table type, of other libraries, and answers
// that users report; each is compared with exact arithmetic.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "edgewise/bench/registry.hpp"
#include "edgewise/scene/case_file.hpp"
#include "edgewise/scene/dumps/dump.hpp"
#include "edgewise/scene/minimise.hpp"
#include "edgewise/truth/accuracy_band.hpp"
#include "edgewise/truth/certificate.hpp"
#include "edgewise/truth/exact_distance.hpp"

namespace edgewise::studies {

/// Exact answers for the bodies as given.
struct PairTruth {
    truth::ExactDistance exact;
    std::optional<double> depth;  ///< in contact
    truth::AccuracyBand band;     ///< of double precision
    /// Proof by V-Clip in double; none if it has no answer.
    std::optional<truth::Certificate> certificate;
    std::string no_certificate;  ///< why
};

/// An algorithm on a table type, or another library with its own algorithm.
struct Respondent {
    const bench::TableType* type;
    std::string algorithm;

    [[nodiscard]] std::string name() const;  ///< "V-Clip on aos_f64", "bullet_epa2_f64"
};

enum class AnswerIs {
    right,
    in_band,        ///< another verdict than the exact one, inside the band where rounding decides
    wrong_verdict,  ///< outside the band
    wrong_distance,
    wrong_depth,
    no_answer,  ///< threw, or gave up
    refused,    ///< the bodies or the pose are outside what it takes, and it says so
};
[[nodiscard]] std::string_view to_string(AnswerIs answer);

struct JudgedResponse {
    std::string who;
    std::vector<std::string> same;  ///< others with an answer equal to the last bit
    std::string status;  ///< separated, touching, overlapping, failed; of a library contact is touching
    std::optional<double> distance, depth;
    double error = 0;     ///< of the distance (in contact: of the depth), from the bodies that it holds
    double beyond = 0;    ///< how far that is over what is allowed; 0: it is not
    double of_given = 0;  ///< error of the distance from the bodies as given: rounding of storage too
    AnswerIs is = AnswerIs::right;
    std::string why;  ///< where it is not right

    [[nodiscard]] bool wrong() const {
        return is == AnswerIs::wrong_verdict || is == AnswerIs::wrong_distance ||
               is == AnswerIs::wrong_depth || is == AnswerIs::no_answer;
    }
};

/// Computes the exact answers. Fails with one line for invalid bodies or if no exact answer can be computed.
[[nodiscard]] Result<PairTruth> truth_of(const scene::Case& pair);
/// Computes the exact answers without a certificate, for callers with many pairs.
[[nodiscard]] Result<PairTruth> exact_truth_of(const scene::Case& pair);

/// Builds the tables, asks the respondent and checks its answer.
[[nodiscard]] JudgedResponse ask(const Respondent& respondent, const scene::Case& pair,
                                 const PairTruth& truth);

/// Checks an answer that was printed elsewhere.
[[nodiscard]] JudgedResponse judge_reported(const scene::ReportedAnswer& reported, const scene::Case& pair,
                                            const PairTruth& truth);

/// Asks all respondents and groups equal answers: returns the first of each, in the respondents' order.
[[nodiscard]] std::vector<JudgedResponse> ask_all(std::span<const Respondent> respondents,
                                                  const scene::Case& pair, const PairTruth& truth);

/// Returns every algorithm on every type in `types`, then the peers.
[[nodiscard]] std::vector<Respondent> respondents_of(std::span<const bench::TableType* const> types,
                                                     std::span<const std::string> algorithms,
                                                     std::span<const bench::TableType* const> peers);

// Finds a smaller pair for which the same respondent is still wrong in the same way.

struct SmallerPair {
    scene::Minimised found;
    PairTruth truth;
    JudgedResponse answer;  ///< to the smaller pair
};

/// Returns the smaller pair. Solids stay solids. The error over the scale stays at least a tenth of the
/// original, so that the failure stays the same. Empty if the respondent is not wrong when it is asked.
[[nodiscard]] std::optional<SmallerPair> smaller_pair(const Respondent& respondent, const scene::Case& pair);

}  // namespace edgewise::studies
