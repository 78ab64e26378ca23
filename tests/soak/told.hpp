// The services that one module was told of, event by event.
#ifndef GEMINGA_TESTS_SOAK_TOLD_HPP
#define GEMINGA_TESTS_SOAK_TOLD_HPP

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace geminga::soak {

/// The services that a module may use by what it was told: `ID pub add service=KEY` and `ID pub del service=KEY`.
class Told {
 public:
  /// Takes a line. Lines other than events are ignored. A contradiction is kept as a fault.
  void hear(const std::string& line);

  /// Pairs of a subscription and a service.
  [[nodiscard]] std::size_t size() const { return services_.size(); }
  /// Services that came twice or went without having come, in words.
  [[nodiscard]] const std::vector<std::string>& faults() const { return faults_; }

 private:
  std::set<std::pair<std::string, std::string>> services_;
  std::vector<std::string> faults_;
};

}  // namespace geminga::soak

#endif
