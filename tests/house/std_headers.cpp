// SPDX-License-Identifier: MIT
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "house.hpp"

namespace edgewise::house {

namespace {

/// Standard names that exported headers use, by header.
const std::vector<std::pair<std::string, std::string>> names_of_headers = {
    {"algorithm",
     "all_of any_of clamp copy count fill fill_n find find_if lower_bound max max_element min min_element minmax none_of pop_heap push_heap reverse sort stable_sort transform unique upper_bound"},
    {"array", "array"},
    {"atomic", "atomic memory_order_relaxed"},
    {"bit", "bit_cast bit_width countl_zero countr_one countr_zero endian has_single_bit popcount"},
    {"cassert", "assert"},
    {"charconv", "chars_format from_chars to_chars"},
    {"cmath", "abs ceil copysign fabs floor fma frexp hypot ilogb isfinite isinf isnan ldexp nextafter sqrt"},
    {"concepts", "convertible_to floating_point integral regular same_as unsigned_integral"},
    {"cstddef", "byte max_align_t nullptr_t ptrdiff_t size_t to_integer"},
    {"cstdint", "int16_t int32_t int64_t int8_t uint16_t uint32_t uint64_t uint8_t uintptr_t"},
    {"cstring", "memcmp memcpy memset"},
    {"filesystem", "filesystem"},
    {"functional", "function ref"},
    {"initializer_list", "initializer_list"},
    {"iosfwd", "istream ostream"},
    {"iterator", "default_sentinel_t"},
    {"limits", "numeric_limits"},
    {"map", "map"},
    {"memory", "make_shared make_unique shared_ptr uninitialized_default_construct_n unique_ptr"},
    {"memory_resource", "pmr"},
    {"new", "align_val_t bad_alloc"},
    {"numeric", "accumulate iota"},
    {"optional", "nullopt optional"},
    {"ranges", "ranges"},
    {"span", "span"},
    {"stdexcept", "invalid_argument"},
    {"string", "string to_string"},
    {"string_view", "string_view"},
    {"tuple", "get tuple"},
    {"type_traits",
     "conditional_t decay_t enable_if_t integral_constant is_base_of_v is_const_v is_floating_point_v is_integral_v is_same_v is_trivially_copyable_v is_trivially_destructible_v remove_cvref_t remove_reference_t type_identity_t"},
    {"unordered_map", "unordered_map"},
    {"unordered_set", "unordered_set"},
    {"utility",
     "as_const declval exchange forward index_sequence integer_sequence make_index_sequence make_integer_sequence move pair swap"},
    {"variant", "variant"},
    {"vector", "vector"},
};

std::map<std::string, std::string> header_of_name() {
    std::map<std::string, std::string> result;
    for (const auto& [header, names] : names_of_headers) {
        std::istringstream words(names);
        for (std::string name; words >> name;) result[name] = header;
    }
    return result;
}

bool is_exported(const SourceFile& file) {
    static const std::regex exported(
        "(src/edgewise/(geometry|table|layout_parts|algorithms|measure/(cache|lock|record|touch|traces))|layouts)"
        "/.*[.]hpp|src/edgewise/measure/expected[.]hpp");
    return std::regex_match(file.path, exported);
}

/// Standard names in the code of a line, `assert` among them.
std::vector<std::string> names_in(const std::string& line) {
    static const std::regex text(R"("(\\.|[^"\\])*"|//.*)"), name(R"(\bstd::(\w+)|\b(assert)\()");
    const std::string code = std::regex_replace(line, text, "");
    std::vector<std::string> found;
    for (std::sregex_iterator at(code.begin(), code.end(), name), end; at != end; ++at)
        found.push_back((*at)[1].matched ? (*at)[1].str() : (*at)[2].str());
    return found;
}

}  // namespace

Violations missing_std_headers(const Files& files) {
    static const std::regex directive(R"(^#include <([^>]+)>.*)");
    static const std::map<std::string, std::string> header_of = header_of_name();
    Violations found;
    for (const SourceFile& file : files) {
        if (!is_exported(file)) continue;
        std::set<std::string> there;
        std::smatch match;
        for (const std::string& line : file.lines)
            if (std::regex_match(line, match, directive)) there.insert(match[1]);
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            for (const std::string& name : names_in(file.lines[i])) {
                const auto header = header_of.find(name);
                if (header == header_of.end())
                    found.push_back(
                        {file.path, i + 1, "std::" + name + " is not in the table of std_headers.cpp"});
                else if (there.insert(header->second).second)
                    found.push_back({file.path, i + 1, name + " needs #include <" + header->second + ">"});
            }
        }
    }
    return found;
}

}  // namespace edgewise::house
