// SPDX-License-Identifier: MIT
#include "edgewise/studies/advise/finalist.hpp"

#include <algorithm>
#include <numeric>

#include "edgewise/studies/parts/contender_name.hpp"

namespace edgewise::studies::advise {

namespace {

/// Place of the median; of an even number the upper one.
std::size_t middle_of(const std::vector<double>& values) {
    std::vector<std::size_t> places(values.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    std::ranges::sort(places, {}, [&](std::size_t place) { return values[place]; });
    return places[places.size() / 2];
}

}  // namespace

double Finalist::low() const { return *std::ranges::min_element(ratios); }
double Finalist::mid() const { return ratios[middle_of(ratios)]; }
double Finalist::high() const { return *std::ranges::max_element(ratios); }
double Finalist::mid_ns() const { return ns[middle_of(ratios)]; }

bool Finalist::is(const std::string& other_algorithm, const std::string& other_table) const {
    return algorithm == other_algorithm && table == other_table;
}

std::string Finalist::name() const { return contender_name(algorithm, table); }

}  // namespace edgewise::studies::advise
