// SPDX-License-Identifier: MIT
//
// Traces of addresses in files, as other programs write and read them; line by line, nothing is kept.
//   din     Dinero's (Edler and Hill, "Dinero IV", 1998), in both of its forms. Traditional: a label (0 is
//           a read, 1 a write, 2 an instruction fetch) and an address in hexadecimal; it has no sizes, so
//           that an access is the word of 4 bytes at the address, as in Dinero. Extended: r, w, i or m (as a
//           read), address and size, both in hexadecimal. The rest of a line is a comment; a size there,
//           which the traditional form does not have, is refused. So are labels that are no accesses (3, 4;
//           c, v): the model has no commands.
//   lackey  what `valgrind --tool=lackey --trace-mem=yes --log-file=FILE` writes: a letter of I (fetch), S
//           (write), L (read) or M (both, of the same bytes), an address in hexadecimal, a comma, and a size
//           in decimal, with any blanks around the letter. Valgrind's own lines ("==pid== ...") say nothing.
// Blank lines and lines that begin with # are left out.
// A user's own traces are written in the extended form of din (write_din).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "edgewise/measure/cache/cache_machine.hpp"
#include "edgewise/measure/cache/reuse_distance.hpp"
#include "edgewise/measure/cache/trace.hpp"

namespace edgewise::measure {

enum class TraceForm : std::uint8_t { din, lackey };

/// Bytes at an address as the program had it.
struct FileAccess {
    std::uint64_t address;
    std::uint32_t bytes;
    AccessKind kind;
};

/// What a file had.
struct TraceCounts {
    std::uint64_t reads = 0, writes = 0, fetches = 0;
    bool has_letters = false;  ///< a digit above 9 in any address; else they may be decimal
};

struct TraceReading {
    TraceForm form = TraceForm::din;
    bool fetches = false;  ///< instruction fetches are reads like others, else they are left out
};

/// By the file's first line that may be an access: lackey has a comma after the address. Throws
/// std::runtime_error as read_trace does.
[[nodiscard]] TraceForm form_of(std::istream& stream, const std::string& file);

/// Calls use(access) for each, in order; fetches are counted in any case. Throws std::runtime_error with one
/// line: file, number of the line, what is wanted there.
TraceCounts read_trace(std::istream& stream, const std::string& file, const TraceReading& reading,
                       const std::function<void(const FileAccess&)>& use);

/// Writes the accesses that it receives as extended din; fields, queries and sides are not in that form.
class DinWriter final : public TraceListener {
  public:
    /// The stream must outlive this.
    explicit DinWriter(std::ostream& stream) : stream_(&stream) {}
    void on_access(const TracedAccess& access) override;

  private:
    std::ostream* stream_;
};

/// Costs of data in the format of Callgrind, for KCachegrind and callgrind_annotate, which show code: here a
/// file is a component of a structure, a function is a step, and a line is a field, from 1 on. Events: reads,
/// writes, distinct lines of 64 bytes that each query reads of tables, and misses by level of each machine.
/// Each object has caches of its own.
class DataProfile final : public TraceListener {
  public:
    using ComponentOf = std::function<std::string_view(const TracedAccess&)>;

    explicit DataProfile(std::span<const CacheMachine> machines);

    /// Starts an object, such as a cell; later accesses are its own. component_of: the name of the component.
    void start_object(const std::string& name, ComponentOf component_of);
    /// Forgets the costs of the object, not the contents of its caches: a second pass is the steady state.
    void start_steady();

    void on_access(const TracedAccess& access) override;
    void on_query_end(bool /*counts*/) override { ++query_; }

    /// Returns the file. `steps`: their names, by number.
    [[nodiscard]] std::string text(std::span<const std::string_view> steps) const;
    [[nodiscard]] bool is_empty() const { return costs_.empty(); }

  private:
    using Place = std::tuple<std::string, std::string, std::uint8_t, std::uint8_t>;

    std::span<const CacheMachine> machines_;
    std::vector<std::string> events_ = {"Reads", "Writes", "Lines"};
    std::map<Place, std::vector<std::uint64_t>> costs_;  ///< by object, component, step and field
    std::string object_;
    ComponentOf component_of_;
    std::vector<CacheModel> models_;
    std::unordered_map<std::uint64_t, std::uint64_t> last_query_;  ///< by side and line
    std::uint64_t query_ = 1;
};

/// A trace from elsewhere through the caches of several machines at once, and through reuse distances. Sets
/// are found by the addresses as the file has them; caches are empty at its beginning. It knows no queries,
/// so the trace as a whole is what the knee is of.
class TraceCaches final : public TraceListener {
  public:
    /// One level, of caches or TLBs.
    struct Level {
        std::string name;
        LevelCounts counts;
    };

    explicit TraceCaches(std::span<const CacheMachine> machines);

    void access(const FileAccess& access);
    void on_access(const TracedAccess& at) override { access({at.address, at.bytes, at.kind}); }

    [[nodiscard]] std::uint64_t reads() const { return reads_; }
    [[nodiscard]] std::uint64_t writes() const { return writes_; }

    /// Levels of machine number `machine`: caches from the first level on, then TLBs.
    [[nodiscard]] std::vector<Level> levels(std::size_t machine) const;

    /// Number of distinct lines of 64 bytes.
    [[nodiscard]] std::uint64_t distinct_lines() const { return reuse_.lines(); }
    /// Returns the size in bytes of the smallest fully associative cache in which repeated fetches of lines
    /// are at most a tenth of the trace's distinct lines; 0 if no line is needed again.
    [[nodiscard]] std::uint64_t knee_bytes() const;
    /// Returns the number of lines that a fully associative cache of this size fetches.
    [[nodiscard]] std::uint64_t misses(std::uint64_t bytes) const;

  private:
    std::vector<std::vector<CacheModel>> machines_;  ///< caches of each machine, then its known TLBs
    std::unordered_map<std::uint64_t, std::uint64_t> numbers_;  ///< of lines, in order of first use
    std::uint64_t last_line_ = 0, last_number_ = 0;             ///< of the last access
    std::uint64_t reads_ = 0, writes_ = 0;
    ReuseDistance reuse_;
};

}  // namespace edgewise::measure
