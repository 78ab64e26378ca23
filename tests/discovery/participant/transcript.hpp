// Plays a transcript: a readable GCNP session, line by line, against participants in the simulated world.
#ifndef GEMINGA_TESTS_DISCOVERY_PARTICIPANT_TRANSCRIPT_HPP
#define GEMINGA_TESTS_DISCOVERY_PARTICIPANT_TRANSCRIPT_HPP

#include <map>
#include <string>
#include <string_view>

#include "sim/client.hpp"
#include "sim/host.hpp"
#include "sim/world.hpp"
#include "support/transcript_words.hpp"

namespace geminga::participant {

/// The language is told in transcripts/README.md. Every failure names the line.
class Transcript {
 public:
  explicit Transcript(std::string path) : path_(std::move(path)) {}
  /// Plays the whole file; stops at the first line that fails.
  void play();

 private:
  void line(std::string_view line);
  void direct(std::string_view words);
  void say(const std::string& client, const std::string& text, bool is_raw);
  void expect(const std::string& client, std::string_view pattern);
  void expect_nothing_more();
  void run(base::Duration duration);
  [[nodiscard]] std::string substituted(std::string_view text) const;
  [[nodiscard]] sim::Host* host(const std::string& name);
  /// Somebody else announces a state under this identifier.
  void clash(sim::Host& host, const std::string& id);
  /// Looks for a line of the log since the last one that was found.
  void expect_logged(sim::Host& host, std::string_view pattern, bool is_expected);
  void seal(sim::Host& host, const std::string& mode, std::string_view keys);
  void set_limit(sim::Host& host, const std::string& name, std::size_t value);

  std::string path_;
  std::string at_;  ///< "file:line", for failures
  sim::World world_{1};
  std::map<std::string, sim::Host*> hosts_;
  std::map<std::string, sim::Client*> clients_;
  test::BoundWords words_;
};

}  // namespace geminga::participant

#endif
