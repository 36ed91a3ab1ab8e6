// SPDX-License-Identifier: MIT
#include "edgewise/studies/paging/paging.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <type_traits>

#include "edgewise/measure/cache/reuse_distance.hpp"
#include "edgewise/measure/process/memory_limit.hpp"
#include "edgewise/measure/process/thread_usage.hpp"
#include "edgewise/measure/stopwatch.hpp"

namespace edgewise::studies {

namespace {

/// A pipe between this process and one it forks; whole values go through it, bit by bit.
class Pipe {
  public:
    Pipe() {
        if (pipe(ends_) != 0) throw std::runtime_error("no pipe: too many files are open");
    }
    ~Pipe() {
        close(ends_[0]);
        close_writing();
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    /// Closes the write end: the reader sees the end of the pipe after the last writer has closed it.
    void close_writing() const {
        if (ends_[1] >= 0) close(ends_[1]);
        ends_[1] = -1;
    }

    template <class Value>
    void send(const Value& value) const {
        static_assert(std::is_trivially_copyable_v<Value>);
        while (write(ends_[1], &value, sizeof value) < 0 && errno == EINTR) continue;
    }

    /// Returns nothing if the other side ended without writing.
    template <class Value>
    [[nodiscard]] std::optional<Value> receive() const {
        static_assert(std::is_trivially_copyable_v<Value>);
        Value value{};
        ssize_t count = -1;
        while ((count = read(ends_[0], &value, sizeof value)) < 0 && errno == EINTR) continue;
        if (count != static_cast<ssize_t>(sizeof value)) return std::nullopt;
        return value;
    }

  private:
    mutable int ends_[2] = {-1, -1};
};

/// Counts that the process under the limit sends.
struct Counted {
    std::uint64_t major = 0;
    double ns = 0;
};

/// How the kernel throws pages out varies from pass to pass, most of all where nearly all fits.
constexpr int counted_passes = 3;

/// In the child: fills memory once it is put under the limit, then counts passes, reports each, and waits
/// before the next, since what it holds is looked at from outside.
[[noreturn]] void run_child(const std::function<bench::PassSum()>& pass, const Pipe& to_child,
                            const Pipe& to_parent) {
    to_child.close_writing();
    if (!to_child.receive<char>()) _exit(1);
    pass();
    do {
        const measure::ThreadUsage before = measure::thread_usage();
        const measure::Stopwatch watch;
        pass();
        const Counted counted{(measure::thread_usage() - before).major_faults, watch.elapsed_ns()};
        to_parent.send(counted);
    } while (to_child.receive<char>());
    _exit(0);
}

/// Waits for the end of the child in every case.
class Child {
  public:
    Child(const std::function<bench::PassSum()>& pass, const Pipe& to_child, const Pipe& to_parent)
        : id_(fork()) {
        if (id_ == 0) run_child(pass, to_child, to_parent);
    }
    ~Child() {
        if (id_ > 0) waitpid(id_, nullptr, 0);
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    [[nodiscard]] pid_t id() const { return id_; }

  private:
    pid_t id_;
};

/// Counts one pass of the child and which table pages are held after it. False if the child is gone.
bool count_pass_of(const Pipe& to_child, const Pipe& to_parent, const bench::TableAllocator& tables,
                   const measure::PageReuse& reuse, PagingRow& row) {
    to_child.send('g');
    const std::optional<Counted> counted = to_parent.receive<Counted>();
    const std::optional<std::size_t> resident = tables.resident();
    if (!counted || !resident) return false;
    const std::uint64_t held = *resident / page_bytes();
    row.table_pages_held = row.table_pages_held.value_or(0) + held;
    row.predicted_at_held += reuse.fetches_per_query(held).all.value_or(0);
    row.faults_per_query += static_cast<double>(counted->major);
    row.ns_per_query += counted->ns;
    return true;
}

/// Fills in means over passes of `queries` queries.
void take_means(PagingRow& row, std::uint64_t queries) {
    row.table_pages_held = *row.table_pages_held / counted_passes;
    row.predicted_at_held /= counted_passes;
    row.faults_per_query /= counted_passes * static_cast<double>(queries);
    row.ns_per_query /= counted_passes * static_cast<double>(queries);
}

/// Returns "", or why there is no measurement.
std::string measure_under(const measure::MemoryLimit& group, const bench::Runner& runner,
                          const std::function<bench::PassSum()>& pass, const measure::PageReuse& reuse,
                          PagingRow& row) {
    const bench::TableAllocator& tables = runner.table_allocator();
    if (!tables.evict() || tables.resident() != std::size_t{0})
        return "the tables' pages could not be dropped from memory";
    if (std::string error = group.set_bytes(row.limit_bytes); !error.empty()) return error;
    const Pipe to_child, to_parent;
    const Child child(pass, to_child, to_parent);
    if (child.id() < 0) return "no process could be made";
    to_parent.close_writing();
    std::string error = group.take_in(child.id());
    for (int i = 0; i < counted_passes && error.empty(); ++i) {
        if (!count_pass_of(to_child, to_parent, tables, reuse, row))
            error = "the process under the limit ended early: the limit leaves it no room";
    }
    to_child.close_writing();
    return error;
}

/// Traces two passes, as the process under the limit runs them; the second counts.
void trace_pages(const bench::Runner& runner, measure::PageReuse& reuse) {
    const bench::TraceExtent all = bench::TraceExtent::everything();
    runner.trace(all, reuse);
    reuse.start_counting();
    runner.trace(all, reuse);
}

}  // namespace

std::uint64_t page_bytes() { return static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)); }

PagingResult measure_paging(const bench::TableType& type, const std::string& algorithm,
                            const scene::Workload& workload, const PagingLimits& limits,
                            const std::atomic<bool>& stop) {
    PagingResult result;
    result.table = type.name;
    result.algorithm = algorithm;
    result.queries = workload.queries.size();
    const auto runner = type.make_runner(algorithm);
    runner->configure(
        {.tables = {VertexOrder::given, bench::Sharing::per_instance, bench::AllocatorKind::file}});
    result.reason = runner->load(workload);
    if (!result.reason.empty()) return result;
    result.keeps_recency = runner->table_allocator().keeps_recency();
    result.table_bytes = runner->table_allocator().taken();
    measure::PageReuse reuse(page_bytes());
    trace_pages(*runner, reuse);
    result.pages_touched = reuse.pages();
    const auto group = measure::MemoryLimit::make();
    const std::function<bench::PassSum()> pass = runner->prepared_pass();
    for (const std::uint64_t limit : limits(reuse.pages() * page_bytes())) {
        if (stop) return result;
        PagingRow& row = result.rows.emplace_back();
        row.limit_bytes = limit;
        row.predicted_at_limit = reuse.fetches_per_query(limit > 0 ? limit / page_bytes() : reuse.pages());
        row.reason = group.value ? measure_under(**group.value, *runner, pass, reuse, row)
                                 : "no memory limit: " + group.reason;
        if (row.reason.empty()) take_means(row, result.queries);
    }
    return result;
}

}  // namespace edgewise::studies
