// A team of whole daemons in a lab. Each has one module that offers and wants what a robot does; the team knows what
// each ought to know.
#ifndef GEMINGA_TESTS_SUPPORT_LAB_TEAM_HPP
#define GEMINGA_TESTS_SUPPORT_LAB_TEAM_HPP

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "support/lab.hpp"

namespace geminga::system {

/// Each robot has nine publications and eight subscriptions (paper section 4): publications 10 to 18 of the texts
/// service0 to service8, subscriptions 30 to 36 of the first seven, and subscription 40 of the text `news`, which
/// nobody offers at first.
class LabTeam {
 public:
  static constexpr std::size_t publications_each = 9;
  static constexpr std::size_t subscriptions_each = 7;  ///< those that somebody serves

  /// The flags of the daemon on a host.
  using FlagsOf = std::function<std::vector<std::string>(std::size_t host)>;
  /// `others`: further hosts of the lab, which are no robots.
  explicit LabTeam(
      std::size_t hosts, std::size_t others = 0,
      FlagsOf flags_of = [](std::size_t) { return std::vector<std::string>(); })
      : lab_(hosts + others), flags_of_(std::move(flags_of)), robots_(hosts) {}

  [[nodiscard]] Lab& lab() { return lab_; }
  [[nodiscard]] std::size_t size() const { return robots_.size(); }

  /// Starts all at once. When it returns, each module has stated its services and requests.
  void start_together();
  /// Starts one. When it returns, its module has stated its services and requests.
  void start(std::size_t host);
  /// Ends one by this signal, e.g. SIGKILL, and waits for its end. False: it had ended by itself.
  bool end(std::size_t host, int signal);
  [[nodiscard]] bool is_running(std::size_t host) const { return robots_.at(host).module.has_value(); }

  /// The module of a running robot, whose lines only the caller reads.
  [[nodiscard]] Talk& module(std::size_t host) { return *robots_.at(host).module; }
  /// Lets a module offer one more service, or end it. The caller chooses the identifier.
  void publish(std::size_t host, std::uint32_t id, const std::string& text);
  void withdraw(std::size_t host, std::uint32_t id);

  /// Waits until every running robot knows exactly the running ones and their publications. False: patience ended.
  [[nodiscard]] bool wait_until_right();
  /// The knowledge of a robot that differs, in words.
  [[nodiscard]] std::string knowledge(std::size_t host);

  /// The traffic of all running daemons since each was started.
  struct Sent {
    double datagrams = 0;
    double octets = 0;  ///< without headers
  };
  [[nodiscard]] Sent sent();
  /// The number of services that the modules were told have expired, in the lines since the last read.
  [[nodiscard]] std::size_t departures();

 private:
  struct Robot {
    std::optional<Talk> module;
    std::optional<Talk> observer;  ///< asks, so that no event is skipped with an answer
    std::size_t publications = 0;
  };

  void connect(std::size_t host);

  Lab lab_;
  FlagsOf flags_of_;
  std::vector<Robot> robots_;
};

}  // namespace geminga::system

#endif
