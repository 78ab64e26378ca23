#include "daemon/memory_reserve.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <new>
#include <utility>

#include "base/text.hpp"

namespace geminga::daemon {
namespace {

struct Piece {
  Piece* next = nullptr;
};

// A new-handler is a function without an object, and may be called on any thread: so the reserve is the process's.
std::atomic<Piece*> pieces = nullptr;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables): see above
std::atomic<std::size_t> kept = 0;     // NOLINT(cppcoreguidelines-avoid-non-const-global-variables): see above
std::atomic<bool> was_short = false;   // NOLINT(cppcoreguidelines-avoid-non-const-global-variables): see above

/// Gives everything back; false: there was nothing.
bool release() {
  Piece* piece = pieces.exchange(nullptr);
  if (piece == nullptr) return false;
  kept = 0;
  while (piece != nullptr) {
    std::free(std::exchange(piece, piece->next));  // NOLINT(cppcoreguidelines-no-malloc): the allocator itself
  }
  return true;
}

void on_shortage() {
  was_short = true;
  if (!release()) throw std::bad_alloc();
}

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

std::string first_line(const std::string& path) {
  const File file(std::fopen(path.c_str(), "re"), &std::fclose);
  char line[512] = "";
  if (!file || std::fgets(line, sizeof line, file.get()) == nullptr) return "";
  std::string text(line);
  while (text.ends_with('\n')) text.pop_back();
  return text;
}

}  // namespace

MemoryReserve::MemoryReserve() {
  refill();
  std::set_new_handler(&on_shortage);
}

MemoryReserve::~MemoryReserve() {
  std::set_new_handler(nullptr);
  release();
}

bool MemoryReserve::take_shortage() { return was_short.exchange(false); }

bool MemoryReserve::refill() {
  Piece* taken = pieces.exchange(nullptr);  // another thread may give them back at any time
  std::size_t size = taken == nullptr ? 0 : kept.load();
  while (size < reserved_bytes) {
    void* room = std::malloc(reserve_piece_bytes);  // NOLINT(cppcoreguidelines-no-malloc): null is no error here
    if (room == nullptr) break;
    taken = new (room) Piece{taken};
    size += reserve_piece_bytes;
  }
  kept = size;
  pieces = taken;
  return size >= least_reserved_bytes;
}

std::size_t MemoryReserve::size() { return kept; }

std::optional<std::uint64_t> memory_of_group() {
  const std::string group = first_line("/proc/self/cgroup");
  constexpr std::string_view v2 = "0::";
  if (!group.starts_with(v2)) return std::nullopt;
  std::optional<std::uint64_t> least;
  for (std::string path = group.substr(v2.size());; path.resize(path.rfind('/'))) {
    const auto limit = base::parse_number<std::uint64_t>(first_line("/sys/fs/cgroup" + path + "/memory.max"));
    if (limit) least = std::min(least.value_or(*limit), *limit);
    if (path.empty() || path.rfind('/') == std::string::npos) return least;
  }
}

std::uint64_t memory_in_use() {
  const File file(std::fopen("/proc/self/statm", "re"), &std::fclose);
  unsigned long total = 0;
  unsigned long resident = 0;
  unsigned long shared = 0;
  if (!file || std::fscanf(file.get(), "%lu %lu %lu", &total, &resident, &shared) != 3) return 0;
  return (resident - std::min(resident, shared)) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

std::optional<std::string> check_descriptors() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0) return std::nullopt;
  if (limit.rlim_cur < limit.rlim_max) {
    const rlimit raised{.rlim_cur = std::min<rlim_t>(limit.rlim_max, 4096), .rlim_max = limit.rlim_max};
    if (raised.rlim_cur > limit.rlim_cur && ::setrlimit(RLIMIT_NOFILE, &raised) == 0) limit = raised;
  }
  if (limit.rlim_cur >= least_descriptors) return std::nullopt;
  return "this process may open " + std::to_string(limit.rlim_cur) + " files and sockets, and needs " +
         std::to_string(least_descriptors) + " at least: raise the limit (ulimit -n, LimitNOFILE= of systemd)";
}

}  // namespace geminga::daemon
