#include "daemon/usage.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace geminga::daemon {

Usage read_usage() {
  Usage usage;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen("/proc/self/statm", "re"), &std::fclose);
  unsigned long total = 0;
  unsigned long resident = 0;
  if (file && std::fscanf(file.get(), "%lu %lu", &total, &resident) == 2) {
    usage.resident_bytes = resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  }
  rusage counted{};
  if (::getrusage(RUSAGE_SELF, &counted) == 0) {
    // The kernel samples the peak now and then, and may have missed the present size.
    usage.peak_resident_bytes = std::max(static_cast<std::uint64_t>(counted.ru_maxrss) * 1024, usage.resident_bytes);
    const auto seconds = [](const timeval& time) {
      return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) / 1e6;
    };
    usage.processor_seconds = seconds(counted.ru_utime) + seconds(counted.ru_stime);
  }
  return usage;
}

}  // namespace geminga::daemon
