// A team of whole daemons of which some are killed at random, round after round, until the time is over.
#ifndef GEMINGA_TESTS_SOAK_SOAK_HPP
#define GEMINGA_TESTS_SOAK_SOAK_HPP

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <vector>

#include "base/random.hpp"
#include "soak/told.hpp"
#include "support/lab_team.hpp"

namespace geminga::soak {

struct Plan {
  std::size_t hosts = 10;
  std::chrono::seconds time = std::chrono::hours(1);
  std::size_t rounds = 1'000'000;  ///< it ends earlier after so many
  double loss = 0.1;               ///< the loss of each receiver, independently, if the lab can lose
  std::uint64_t seed = 1;
};

/// The reason why it ends before its time.
struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// In each round some robots are killed or stopped, services come and go on others, and all are started again, at once
/// or after the others have given them up. Then each robot must know exactly the team, and each module must have been
/// told of exactly the present services. The first robot is never killed, so that its resources can be compared from
/// round to round.
class Soak {
 public:
  explicit Soak(const Plan& plan);

  /// Throws Failure.
  void run();

 private:
  /// The resources of the first robot.
  struct Figures {
    double memory_mb = 0;
    std::size_t descriptors = 0;
  };

  void round();
  void end_some();
  void change_services();
  void expect_right();
  void expect_told();
  void expect_no_growth();
  [[nodiscard]] Figures figures();
  void report();
  /// Lets a random time of at most `longest` pass, so that robots end at any moment. The soak is a load, not a test
  /// with an expected time.
  void rest(std::chrono::milliseconds longest);

  Plan plan_;
  base::Random random_;
  system::LabTeam team_;
  std::vector<Told> told_;               ///< by host, since its module was started
  std::optional<std::size_t> all_told_;  ///< the number of services that a module is told of when all is right
  std::optional<Figures> at_first_;      ///< after the first tenth of the time
  std::chrono::steady_clock::time_point began_;
  std::chrono::minutes reported_{0};
  std::chrono::milliseconds slowest_{0};  ///< from the last start to the moment when all is right
  std::size_t round_ = 0;
  std::size_t killed_ = 0;
  std::size_t stopped_ = 0;
};

}  // namespace geminga::soak

#endif
