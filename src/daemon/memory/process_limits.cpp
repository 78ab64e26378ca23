#include "daemon/memory/process_limits.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string_view>

#include "base/text.hpp"

namespace geminga::daemon {
namespace {

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
