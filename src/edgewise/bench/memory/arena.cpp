// SPDX-License-Identifier: MIT
//
// Addresses are reserved once, far more than any scene needs, so that all tables lie in one stretch and none
// has to move: mmap without a swap reservation, of a sparse file where there is one. Where there are not so
// many addresses, the stretch starts small at a place with free addresses behind it, and grows there.
// Read-ahead is off: a page that comes is a page that was asked for. For that the device's read-ahead is set
// to none while the file is opened, which the file then keeps, and set back at once; where that is not
// permitted the mapping is advised as random, which has Linux 6.3 and later forget which of its pages were
// used last (vma_has_recency).
#include "edgewise/bench/memory/arena.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/magic.h>
#include <malloc.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace edgewise::bench {

namespace {

constexpr std::size_t reserve_bytes = std::size_t{16} << 30;

/// Where stretches start that grow: from 16 TiB on, where Linux places nothing of its own.
constexpr std::uintptr_t first_place = std::uintptr_t{16} << 40;
constexpr std::uintptr_t between_places = 2 * reserve_bytes, places = 512;

std::string no_addresses(std::size_t bytes) {
    rlimit limit{};
    getrlimit(RLIMIT_AS, &limit);
    const std::string now =
        limit.rlim_cur == RLIM_INFINITY ? "none" : fmt::format("{} MiB", limit.rlim_cur >> 20);
    return fmt::format(
        "no address space for {} MiB of tables: raise its limit (ulimit -v, now {}), or ask for fewer or "
        "smaller bodies",
        (bytes + (1 << 20) - 1) >> 20, now);
}

bool is_in_memory(int file) {
    struct statfs system {};
    return fstatfs(file, &system) != 0 || system.f_type == TMPFS_MAGIC || system.f_type == RAMFS_MAGIC;
}

/// While it lives, files opened on the folder's device have no read-ahead, for as long as they are open, if
/// the system allows it: see off(). The setting is for the whole device, so a lock protects it, for as long
/// as opening a file takes.
class NoReadAhead {
  public:
    explicit NoReadAhead(const char* folder) {
        struct stat about {};
        if (stat(folder, &about) != 0) return;
        const auto setting =
            fmt::format("/sys/class/bdi/{}:{}/read_ahead_kb", major(about.st_dev), minor(about.st_dev));
        file_ = open(setting.c_str(), O_RDWR | O_CLOEXEC);
        if (file_ < 0 || flock(file_, LOCK_EX) != 0) return;
        char text[32] = {};
        const ssize_t length = pread(file_, text, sizeof text - 1, 0);
        before_.assign(text, length > 0 ? static_cast<std::size_t>(length) : 0);
        off_ = !before_.empty() && write("0");
    }
    ~NoReadAhead() {
        if (off_) static_cast<void>(write(before_));
        if (file_ >= 0) close(file_);
    }
    NoReadAhead(const NoReadAhead&) = delete;
    NoReadAhead& operator=(const NoReadAhead&) = delete;

    [[nodiscard]] bool off() const { return off_; }

  private:
    [[nodiscard]] bool write(const std::string& value) const {
        return pwrite(file_, value.data(), value.size(), 0) == static_cast<ssize_t>(value.size());
    }

    int file_ = -1;
    std::string before_;
    bool off_ = false;
};

struct TemporaryFile {
    int descriptor = -1;
    bool read_ahead_off = false;
};

/// A file without a name. None when the folder takes none, or keeps it in memory.
TemporaryFile file_in(const char* folder) {
    const NoReadAhead meanwhile(folder);
    const int file = open(folder, O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    if (file < 0) return {};
    if (!is_in_memory(file) && ftruncate(file, reserve_bytes + Arena::alignment) == 0)
        return {file, meanwhile.off()};
    close(file);
    return {};
}

TemporaryFile temporary_file() {
    const char* const chosen = std::getenv("TMPDIR");
    for (const char* folder : std::array{chosen ? chosen : "/var/tmp", "/var/tmp", "/tmp", "."}) {
        if (const TemporaryFile file = file_in(folder); file.descriptor >= 0) return file;
    }
    throw std::runtime_error(
        "allocator file: no folder takes a temporary file on a disk (tried $TMPDIR, /var/tmp, /tmp and the "
        "current one); set TMPDIR to one on a file system that is not kept in memory");
}

int shared_memory() {
    const int file = memfd_create("edgewise tables", MFD_CLOEXEC);
    if (file >= 0 && ftruncate(file, reserve_bytes + Arena::alignment) == 0) return file;
    if (file >= 0) close(file);
    throw std::runtime_error("allocator memfd: the system gives no shared memory");
}

/// glibc: a chunk has a header of one word in front of what malloc_usable_size says. (Chunks that are mapped
/// separately, from 128 KiB on to begin with, have two: the second is not counted.)
class LibcAllocator final : public TableAllocator {
    static std::size_t chunk(void* memory) { return malloc_usable_size(memory) + sizeof(std::size_t); }

    void* do_allocate(std::size_t bytes, std::size_t alignment) override {
        const std::size_t whole = (bytes + alignment - 1) / alignment * alignment;
        void* const memory = alignment <= alignof(std::max_align_t) ? std::malloc(bytes)
                                                                    : std::aligned_alloc(alignment, whole);
        if (!memory) throw std::bad_alloc();
        requested_ += bytes;
        taken_ += chunk(memory);
        return memory;
    }
    void do_deallocate(void* memory, std::size_t bytes, std::size_t /*alignment*/) override {
        requested_ -= bytes;
        taken_ -= chunk(memory);
        std::free(memory);
    }
};

}  // namespace

Arena::Arena(Backing backing) : backing_(backing) {
    if (backing == Backing::file) {
        const TemporaryFile file = temporary_file();
        file_ = file.descriptor;
        keeps_recency_ = file.read_ahead_off;
    }
    if (backing == Backing::shared_memory) file_ = shared_memory();
    if (!reserve_all()) start_small();
    if (base_ != nullptr) return;
    if (file_ >= 0) close(file_);
    throw std::runtime_error(no_addresses(alignment));
}

Arena::~Arena() {
    munmap(reserved_, reserved_bytes_);
    if (file_ >= 0) close(file_);
}

void* Arena::do_allocate(std::size_t bytes, std::size_t align) {
    const std::size_t start = (taken_ + align - 1) / align * align;
    if (bytes > reserve_bytes || start > reserve_bytes - bytes) throw std::bad_alloc();
    if (start + bytes > room_) grow(start + bytes);
    taken_ = start + bytes;
    requested_ += bytes;
    return base_ + start;
}

/// At any place if `at` is null. Null if there are no addresses, or if that place is taken.
std::byte* Arena::map(std::byte* at, std::size_t bytes, std::size_t offset) const {
    const int sharing = backing_ == Backing::memory ? MAP_PRIVATE | MAP_ANONYMOUS : MAP_SHARED;
    const int fixed = at != nullptr ? MAP_FIXED_NOREPLACE : 0;
    void* const place = mmap(at, bytes, PROT_READ | PROT_WRITE, sharing | MAP_NORESERVE | fixed, file_,
                             static_cast<off_t>(offset));
    if (place == MAP_FAILED) return nullptr;
    if (at == nullptr || place == at) return static_cast<std::byte*>(place);
    munmap(place, bytes);  // Linux before 4.17 knows no MAP_FIXED_NOREPLACE
    return nullptr;
}

void Arena::advise(std::byte* from, std::size_t bytes) const {
    madvise(from, bytes, MADV_NOHUGEPAGE);
    if (backing_ == Backing::file && !keeps_recency_) madvise(from, bytes, MADV_RANDOM);
}

bool Arena::reserve_all() {
    reserved_ = map(nullptr, reserve_bytes + alignment, 0);
    if (reserved_ == nullptr) return false;
    reserved_bytes_ = reserve_bytes + alignment;
    base_ = reserved_ + (alignment - reinterpret_cast<std::uintptr_t>(reserved_) % alignment) % alignment;
    room_ = reserve_bytes;
    advise(base_, room_);
    return true;
}

void Arena::start_small() {
    static std::atomic<std::uintptr_t> next{0};
    for (std::uintptr_t i = 0; i < places && base_ == nullptr; ++i) {
        const std::uintptr_t place = first_place + next.fetch_add(1) % places * between_places;
        base_ = reserved_ = map(reinterpret_cast<std::byte*>(place), alignment, 0);
    }
    if (base_ == nullptr) return;
    reserved_bytes_ = room_ = alignment;
    advise(base_, room_);
}

void Arena::grow(std::size_t bytes) {
    const std::size_t more = (bytes - room_ + alignment - 1) / alignment * alignment;
    if (map(base_ + room_, more, room_) == nullptr) throw std::runtime_error(no_addresses(bytes));
    advise(base_ + room_, more);
    reserved_bytes_ = room_ += more;
}

std::optional<std::size_t> Arena::resident() const {
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    const std::size_t pages = (taken_ + page - 1) / page;
    std::vector<unsigned char> in_memory(pages);
    if (pages > 0 && mincore(base_, pages * page, in_memory.data()) != 0) return std::nullopt;
    std::size_t count = 0;
    for (const unsigned char there : in_memory) count += there & 1U;
    return count * page;
}

bool Arena::evict() const {
    if (backing_ != Backing::file) return false;
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    const std::size_t length = (taken_ + page - 1) / page * page;
    const auto start = static_cast<off_t>(base_ - reserved_);
    return msync(base_, length, MS_SYNC) == 0 && madvise(base_, length, MADV_DONTNEED) == 0 &&
           fdatasync(file_) == 0 &&
           posix_fadvise(file_, start, static_cast<off_t>(length), POSIX_FADV_DONTNEED) == 0;
}

std::span<const AllocatorInfo> allocators_known() {
    static constexpr AllocatorInfo known[] = {
        {"arena", "tables one behind the other from a multiple of 2 MiB"},
        {"jemalloc", "jemalloc's size classes, in a jemalloc arena of its own"},
        {"libc", "the C library's malloc"},
        {"file", "as arena, in a temporary file on a disk: pages can leave memory and come back"},
        {"memfd", "as arena, in shared memory: a pager of this program can take pages away"},
    };
    return known;
}

std::string_view to_string(AllocatorKind kind) {
    return allocators_known()[static_cast<std::size_t>(kind)].name;
}

std::optional<AllocatorKind> allocator_from(std::string_view name) {
    for (std::size_t i = 0; i < allocators_known().size(); ++i) {
        if (allocators_known()[i].name == name) return static_cast<AllocatorKind>(i);
    }
    return std::nullopt;
}

std::unique_ptr<TableAllocator> make_allocator(AllocatorKind kind) {
    if (kind == AllocatorKind::arena) return std::make_unique<Arena>(Backing::memory);
    if (kind == AllocatorKind::file) return std::make_unique<Arena>(Backing::file);
    if (kind == AllocatorKind::memfd) return std::make_unique<Arena>(Backing::shared_memory);
    if (kind == AllocatorKind::libc) return std::make_unique<LibcAllocator>();
    auto jemalloc = make_jemalloc();
    if (!jemalloc)
        throw std::runtime_error(
            "allocator jemalloc: this program was built without it; install libjemalloc-dev and build again "
            "(it is left out under sanitizers)");
    return jemalloc;
}

}  // namespace edgewise::bench
