// SPDX-License-Identifier: MIT
//
// The walk is one circle in an order that no prefetcher knows (Sattolo, 1986).
#include "edgewise/studies/gate/kernel.hpp"

#include <numeric>
#include <utility>

#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/scene/rng.hpp"

namespace edgewise::studies {

namespace {

constexpr std::size_t node_count = 2048;  // 128 KiB
constexpr int walk_steps = 8192, products = 24'576;

/// Multiplies in a chain; each product waits for the last. The factors are inverses, so no value overflows.
double chain_of_products(double start) {
    double value = start;
    for (int i = 0; i < products / 2; ++i) value = value * 1.25 * 0.8;
    return value;
}

}  // namespace

GateKernel::GateKernel() : nodes_(node_count) {
    std::vector<std::size_t> order(node_count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    scene::Rng rng(1);
    for (std::size_t i = node_count - 1; i > 0; --i) std::swap(order[i], order[rng.below(i)]);
    for (std::size_t i = 0; i < node_count; ++i) nodes_[i].next = &nodes_[order[i]];
}

const GateKernel::Node* GateKernel::walk(const Node* from, int steps) const {
    for (int i = 0; i < steps; ++i) from = from->next;
    return from;
}

double GateKernel::time_ns() const {
    volatile double start = 1;
    volatile bool sink = walk(nodes_.data(), node_count) == nullptr;
    const measure::Stopwatch watch;
    const double product = chain_of_products(start);
    const Node* end = walk(nodes_.data(), walk_steps);
    sink = end == nullptr || product < 0;
    const double ns = watch.elapsed_ns();
    static_cast<void>(sink);
    return ns;
}

}  // namespace edgewise::studies
