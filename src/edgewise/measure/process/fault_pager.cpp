// SPDX-License-Identifier: MIT
#include "edgewise/measure/process/fault_pager.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/userfaultfd.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <optional>

#include "edgewise/measure/stopwatch.hpp"

namespace edgewise::measure {

namespace {

/// What the signal handler works on.
struct Pager {
    int file = -1;
    std::byte* base = nullptr;
    std::size_t bytes = 0, page = 0;
    std::optional<SegmentedLru> memory;
    FaultCounts counts;
    double wait_ns = 0;
    struct sigaction before {};
};
Pager* living = nullptr;

/// Spins: what a sleep takes beyond what is asked is more than a cheap fault.
void wait(double ns) {
    for (const Stopwatch watch; watch.elapsed_ns() < ns;) {
    }
}

[[noreturn]] void give_up(const char* line) {
    static_cast<void>(!write(STDERR_FILENO, line, std::strlen(line)));
    _exit(70);
}

/// Calls nothing that a handler may not: system calls, and arithmetic on memory taken before.
void on_fault(int /*signal*/, siginfo_t* info, void* /*context*/) {
    const auto address = reinterpret_cast<std::uintptr_t>(info->si_addr);
    const auto base = reinterpret_cast<std::uintptr_t>(living->base);
    if (address < base || address >= base + living->bytes) give_up("edgewise: bus error\n");
    const int kept = errno;
    const std::size_t page = (address - base) / living->page;
    const SegmentedLru::Use use = living->memory->use(static_cast<std::uint32_t>(page));
    if (use.unmapped) madvise(living->base + *use.unmapped * living->page, living->page, MADV_DONTNEED);
    if (use.how == PageUse::hard) {
        ++living->counts.hard;
        if (living->wait_ns > 0) wait(living->wait_ns);
    } else {
        ++living->counts.soft;
    }
    uffdio_continue order{};
    order.range.start = base + page * living->page;
    order.range.len = living->page;
    if (ioctl(living->file, UFFDIO_CONTINUE, &order) != 0 && errno != EEXIST)
        give_up("edgewise: a page could not be mapped again\n");
    errno = kept;
}

Refusal refused(const char* what) {
    return {fmt::format("userfaultfd: {}: {}", what, std::strerror(errno)),
            "Linux 5.13 or later, where a sandbox allows userfaultfd"};
}

/// Empty, or what the kernel refused.
std::optional<Refusal> open_for(Pager& pager) {
    pager.file = static_cast<int>(syscall(SYS_userfaultfd, O_CLOEXEC | O_NONBLOCK | UFFD_USER_MODE_ONLY));
    if (pager.file < 0) return refused("the system call");
    uffdio_api api{};
    api.api = UFFD_API;
    api.features = UFFD_FEATURE_SIGBUS | UFFD_FEATURE_MINOR_SHMEM;
    if (ioctl(pager.file, UFFDIO_API, &api) != 0) return refused("minor faults of shared memory as signals");
    uffdio_register order{};
    order.range.start = reinterpret_cast<std::uintptr_t>(pager.base);
    order.range.len = pager.bytes;
    order.mode = UFFDIO_REGISTER_MODE_MINOR;
    if (ioctl(pager.file, UFFDIO_REGISTER, &order) != 0) return refused("registering the tables' memory");
    if (madvise(pager.base, pager.bytes, MADV_DONTNEED) != 0) return refused("taking pages away");
    struct sigaction action {};
    action.sa_sigaction = on_fault;
    action.sa_flags = SA_SIGINFO;
    if (sigaction(SIGBUS, &action, &pager.before) != 0) return refused("the signal's handler");
    return std::nullopt;
}

}  // namespace

Expected<std::unique_ptr<FaultPager>> FaultPager::make(std::byte* base, std::size_t bytes,
                                                       SegmentedLru memory) {
    if (living) return Refusal{"another pager is at work in this process"};
    auto pager = std::make_unique<Pager>();
    pager->base = base;
    pager->page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    pager->bytes = memory.pages() * pager->page;
    pager->memory = std::move(memory);
    if (pager->bytes < bytes) return Refusal{"the memory's pages are fewer than the stretch has"};
    if (const std::optional<Refusal> refusal = open_for(*pager)) {
        if (pager->file >= 0) close(pager->file);
        return *refusal;
    }
    living = pager.release();
    return {std::unique_ptr<FaultPager>(new FaultPager())};
}

FaultPager::~FaultPager() {
    sigaction(SIGBUS, &living->before, nullptr);
    uffdio_range all{reinterpret_cast<std::uintptr_t>(living->base), living->bytes};
    ioctl(living->file, UFFDIO_UNREGISTER, &all);
    close(living->file);
    delete living;
    living = nullptr;
}

void FaultPager::set_wait_ns(double ns) { living->wait_ns = ns; }

FaultCounts FaultPager::take_counts() { return std::exchange(living->counts, {}); }

}  // namespace edgewise::measure
