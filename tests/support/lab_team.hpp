// A team of whole daemons in a lab, each with one module that offers and wants what a robot does, and what each of them
// ought to know.
#ifndef GEMINGA_TESTS_SUPPORT_LAB_TEAM_HPP
#define GEMINGA_TESTS_SUPPORT_LAB_TEAM_HPP

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "support/lab.hpp"

namespace geminga::system {

/// Each robot has nine publications and eight subscriptions (paper section 4): publications 10 to 18 of the texts
/// service0 to service8, subscriptions 30 to 36 of the first seven, and subscription 40 of the text `news`, which
/// nobody offers at first.
class LabTeam {
 public:
  static constexpr std::size_t publications_each = 9;
  static constexpr std::size_t subscriptions_each = 7;  ///< that somebody serves

  explicit LabTeam(std::size_t hosts) : lab_(hosts), robots_(hosts) {}

  [[nodiscard]] Lab& lab() { return lab_; }
  [[nodiscard]] std::size_t size() const { return robots_.size(); }

  /// Starts all at once. When it returns, each module has said what it offers and wants.
  void start_together();
  /// Starts one. When it returns, its module has said what it offers and wants.
  void start(std::size_t host);
  /// Ends one by this signal, e.g. SIGKILL, and waits for its end. False where it had ended by itself.
  bool end(std::size_t host, int signal);
  [[nodiscard]] bool is_running(std::size_t host) const { return robots_.at(host).module.has_value(); }

  /// The module of a robot that runs, whose lines nobody reads but the caller.
  [[nodiscard]] Talk& module(std::size_t host) { return *robots_.at(host).module; }
  /// Lets a module offer one thing more, or end it. The identifier is the caller's.
  void publish(std::size_t host, std::uint32_t id, const std::string& text);
  void withdraw(std::size_t host, std::uint32_t id);

  /// Waits until every robot that runs knows all of them and their publications, and no more. False when patience
  /// ended.
  [[nodiscard]] bool wait_until_right();
  /// What a robot knows instead, in words.
  [[nodiscard]] std::string knowledge(std::size_t host);

  /// What all daemons that run have sent since each was started.
  struct Sent {
    double datagrams = 0;
    double octets = 0;  ///< without headers
  };
  [[nodiscard]] Sent sent();
  /// How many services the modules were told have expired, in what they were told since they were last read.
  [[nodiscard]] std::size_t departures();

 private:
  struct Robot {
    std::optional<Talk> module;
    std::optional<Talk> observer;  ///< asks, so that no event is skipped with an answer
    std::size_t publications = 0;
  };

  void connect(std::size_t host);

  Lab lab_;
  std::vector<Robot> robots_;
};

}  // namespace geminga::system

#endif
