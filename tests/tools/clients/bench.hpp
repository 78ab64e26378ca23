// One host with a daemon and the shipped ontologies, for tests of the command-line programs.
#ifndef GEMINGA_TESTS_TOOLS_CLIENTS_BENCH_HPP
#define GEMINGA_TESTS_TOOLS_CLIENTS_BENCH_HPP

#include <boost/json/value.hpp>
#include <memory>
#include <string>
#include <vector>

#include "support/lab.hpp"

namespace geminga::tools {

using system::Process;
using system::Talk;

/// The output and the end of a program.
struct Outcome {
  int status = -1;
  std::string out;     ///< standard output
  std::string errors;  ///< standard error
};

class Bench {
 public:
  /// Starts the daemon, with these flags beside its ontologies.
  explicit Bench(std::vector<std::string> flags = {});

  /// Runs a program of this build, or of a full path, to its end. GEMINGA_CONNECT names the daemon.
  [[nodiscard]] Outcome run(const std::string& program, const std::vector<std::string>& words) const;
  [[nodiscard]] Outcome query(const std::vector<std::string>& words) const { return run("geminga-query", words); }
  /// The JSON document that geminga-query prints; fails the test where it is none.
  [[nodiscard]] boost::json::value json(std::vector<std::string> words) const;
  /// Starts a program and lets it run.
  [[nodiscard]] std::unique_ptr<Process> start(const std::string& program, const std::vector<std::string>& words) const;
  [[nodiscard]] Talk talk() { return lab_.talk(0); }
  [[nodiscard]] system::Lab& lab() { return lab_; }
  /// Ends the daemon and, where it is wanted again, starts it at the same address.
  void stop_daemon();
  void start_daemon();

 private:
  [[nodiscard]] Process::Start start_of(const std::string& program, const std::vector<std::string>& words) const;

  system::Lab lab_;
  std::vector<std::string> flags_;
};

/// The document of a text; fails the test where it is no JSON.
[[nodiscard]] boost::json::value parsed(const std::string& text);

/// A port of this host without a listener.
[[nodiscard]] std::string nobody();

}  // namespace geminga::tools

#endif
