// SPDX-License-Identifier: MIT
#include "edgewise/sweep/paging.hpp"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <limits>
#include <memory>

#include "edgewise/measure/memory_limit.hpp"
#include "edgewise/measure/page_faults.hpp"
#include "edgewise/measure/page_reuse.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/sweep/pipe.hpp"

namespace edgewise {

namespace {

std::uint64_t page_bytes() { return static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)); }

/// What the process under the limit tells.
struct Counted {
    std::uint64_t major = 0;
    double ns = 0;
};

/// In the child: waits to be put under the limit, fills memory, counts a pass, tells, and waits to be let go,
/// since what it holds is looked at from outside.
[[noreturn]] void run_child(const std::function<PassSum()>& pass, const Pipe& to_child,
                            const Pipe& to_parent) {
    to_child.close_writing();
    if (!to_child.receive<char>()) _exit(1);
    pass();
    const PageFaults before = page_faults();
    const Stopwatch watch;
    pass();
    const Counted counted{page_faults().since(before).major, watch.elapsed_ns()};
    to_parent.send(counted);
    static_cast<void>(to_child.receive<char>());
    _exit(0);
}

/// The last child's end is waited for whatever happens.
class Child {
  public:
    Child(const std::function<PassSum()>& pass, const Pipe& to_child, const Pipe& to_parent) : id_(fork()) {
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

/// Empty, or why there is no measurement.
std::string measure_under(const MemoryLimit& group, const Runner& runner,
                          const std::function<PassSum()>& pass, PagingRow& row, std::uint64_t queries) {
    const TableAllocator& tables = runner.table_allocator();
    if (!tables.evict() || tables.resident() != std::size_t{0})
        return "the tables' pages could not be dropped from memory";
    if (std::string error = group.set_bytes(row.limit_bytes); !error.empty()) return error;
    const Pipe to_child, to_parent;
    std::optional<Counted> counted;
    {
        const Child child(pass, to_child, to_parent);
        if (child.id() < 0) return "no process could be made";
        to_parent.close_writing();
        const std::string error = group.take_in(child.id());
        if (error.empty()) {
            to_child.send('g');
            counted = to_parent.receive<Counted>();
        }
        if (const auto resident = tables.resident()) row.table_pages_held = *resident / page_bytes();
        to_child.close_writing();
        if (!error.empty()) return error;
    }
    if (!counted) return "the process under the limit ended early: the limit leaves it no room";
    row.faults_per_query = static_cast<double>(counted->major) / static_cast<double>(queries);
    row.ns_per_query = counted->ns / static_cast<double>(queries);
    return {};
}

/// Two passes, as the process under the limit runs them; the second counts.
void trace_pages(const Runner& runner, const Workload& workload, PageReuse& reuse) {
    constexpr std::size_t all = std::numeric_limits<std::size_t>::max();
    runner.trace(workload, all, reuse);
    reuse.start_counting();
    runner.trace(workload, all, reuse);
}

}  // namespace

PagingResult measure_paging(const TableType& type, const std::string& algorithm, const Workload& workload,
                            std::span<const std::uint64_t> limits) {
    PagingResult result;
    result.table = type.name;
    result.algorithm = algorithm;
    result.queries = workload.queries.size();
    const auto runner = type.make_runner(algorithm);
    runner->place_tables({VertexOrder::given, Sharing::per_instance, AllocatorKind::file});
    result.reason = runner->load(workload.bodies, workload.instances);
    if (!result.reason.empty()) return result;
    result.keeps_recency = runner->table_allocator().keeps_recency();
    result.table_bytes = runner->table_allocator().taken();
    PageReuse reuse(page_bytes());
    trace_pages(*runner, workload, reuse);
    result.pages_touched = reuse.pages();
    const auto group = MemoryLimit::make();
    const std::function<PassSum()> pass = runner->prepared_pass(workload);
    for (const std::uint64_t limit : limits) {
        PagingRow& row = result.rows.emplace_back();
        row.limit_bytes = limit;
        row.predicted_at_limit = reuse.fetches_per_query(limit > 0 ? limit / page_bytes() : reuse.pages());
        row.reason = group.value ? measure_under(**group.value, *runner, pass, row, result.queries)
                                 : "no memory limit: " + group.reason;
        if (row.reason.empty() && !row.table_pages_held)
            row.reason = "the system does not tell which pages are in memory";
        if (row.table_pages_held) row.predicted_at_held = reuse.fetches_per_query(*row.table_pages_held);
    }
    return result;
}

}  // namespace edgewise
