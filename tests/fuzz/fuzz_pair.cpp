// SPDX-License-Identifier: MIT
//
// The fuzz target of ALGORITHM, which is Gjk or VClip. One fuzzed pair goes through the algorithm in double
// and in single, and exact arithmetic checks the answers. A wrong answer is printed as a line for the corpus,
// and ends the run.
#include <fmt/format.h>

#include <cstdlib>

#include "edgewise/bench/runner_for.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/layouts/aos.hpp"
#include "edgewise/scene/case_text.hpp"
#include "judged_case.hpp"
#include "pair_bytes.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace edgewise {
namespace {

template <class P>
void fuzz_table(const scene::Case& given) {
    bench::RunnerFor<ALGORITHM, aos<P>, aos<P, Traced<measure::TraceSink>>> runner;
    const JudgedCase judged =
        judge_case(runner, {Tolerance<typename P::Compute>::eps, std::is_same_v<P, f32>}, given);
    if (judged.complaints.empty()) return;
    fmt::print(stderr, "{}\n{}: {}\n", scene::case_line(given, "fuzz"), P::name,
               fmt::join(judged.complaints, "; "));
    std::abort();
}

}  // namespace
}  // namespace edgewise

/// Returns -1 if the input is not worth keeping.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace edgewise;
    const auto given = pair_from_bytes({data, size});
    if (!given) return -1;
    fuzz_table<f64>(*given);
    fuzz_table<f32>(*given);
    return 0;
}
