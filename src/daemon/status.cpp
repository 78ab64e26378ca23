#include "daemon/status.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <memory>

#include "base/text.hpp"
#include "daemon/memory/memory_reserve.hpp"

namespace geminga::daemon {
namespace {

std::string decimal(double number) {
  char digits[32];
  const auto [end, error] = std::to_chars(std::begin(digits), std::end(digits), number, std::chars_format::fixed, 3);
  return error == std::errc() ? std::string(std::begin(digits), end) : "0";
}

/// The memory and processor time of this process, as the kernel counts them.
struct Usage {
  std::uint64_t resident_bytes = 0;
  std::uint64_t peak_resident_bytes = 0;
  double processor_seconds = 0;
};

/// Reads /proc and getrusage(2); zero where they cannot be read.
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

std::string interface_words(const env::AsioEnv& env) {
  std::vector<std::string> words;
  for (const env::Interface& interface : env.interfaces()) {
    if (interface.ipv6_side_of) continue;
    words.push_back(interface.name + (interface.addresses.empty() ? "" : " " + interface.addresses.front()));
  }
  return words.empty() ? "none: nobody can be heard" : base::joined(words, ", ");
}

}  // namespace

std::string ready_line(const Configuration& configuration, const env::AsioEnv& env, const OntologyInForce& ontology) {
  std::vector<std::string> addresses;
  for (const GcnpAddress& address : configuration.gcnp) addresses.push_back(env::to_string(address.endpoint));
  if (!configuration.gcnp_socket.empty()) addresses.push_back(base::printable(configuration.gcnp_socket));
  return "ready: gcnp " + base::joined(addresses, ", ") + "; interfaces " + interface_words(env) + "; ontology " +
         (ontology.is_loading() ? "is being loaded" : digest_of(ontology.vocabulary()));
}

std::string interfaces_line(const env::AsioEnv& env) { return "interfaces: " + interface_words(env); }

std::string sealing_line(const sealing::Policy& sealing) {
  std::vector<std::string> ids;
  for (const sealing::Key& key : sealing.keys.keys()) ids.push_back(to_string(key.id()));
  if (ids.empty()) return "announcements are not sealed: there is no key";
  return "announcements: " + std::string(to_string(sealing.mode)) + ", keys " + base::joined(ids, ", ");
}

std::vector<gcnp::Parameter> status_fields(const ConfigurationInForce& configuration, const CageInForce& cage,
                                           const env::AsioEnv& env, const OntologyInForce& ontology, const Log& log,
                                           double started) {
  const Usage usage = read_usage();
  std::vector<gcnp::Parameter> fields{
      {"memory", std::to_string(usage.resident_bytes)},
      {"peak_memory", std::to_string(usage.peak_resident_bytes)},
      {"cpu", decimal(usage.processor_seconds)},
      {"ontology_load", decimal(std::chrono::duration<double>(ontology.load_time()).count())},
      {"log_dropped", std::to_string(log.dropped())},
      {"port", std::to_string(configuration.current().air.port)},
      {"multicast", base::joined(configuration.current().air.groups, ",")},
      {"started", decimal(started)},
      {"cage", cage.words()},
      {"memory_kept_back", std::to_string(MemoryReserve::size())}};
  const env::AirCounts& dropped = env.air_counts();
  const env::UnicastCounts unicast = env.unicast_counts();
  const std::pair<const char*, std::uint64_t> counts[] = {
      {"dropped_off_link", dropped.off_link},   {"dropped_no_peer", dropped.no_peer},
      {"dropped_wrong_way", dropped.wrong_way}, {"dropped_overrun", dropped.overrun},
      {"peers_named", unicast.named},           {"peers_silent", unicast.silent},
      {"peers_unnamed", unicast.guests},
  };
  for (const auto& [key, count] : counts) {
    if (count != 0) fields.push_back({key, std::to_string(count)});
  }
  if (const Adopted& adopted = configuration.current().adopted; !adopted.publishers.empty()) {
    fields.push_back({"adopt_from", base::joined(adopted.publishers, ",")});
    fields.push_back({"adopted_folder", std::filesystem::absolute(adopted.folder).string()});
  }
  if (!configuration.failure().empty()) fields.push_back({"configuration_failed", configuration.failure()});
  return fields;
}

}  // namespace geminga::daemon
