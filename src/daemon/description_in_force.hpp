// The description of this participant, where it is read from a file with facts.
#ifndef GEMINGA_DAEMON_DESCRIPTION_IN_FORCE_HPP
#define GEMINGA_DAEMON_DESCRIPTION_IN_FORCE_HPP

#include <expected>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/private_file.hpp"
#include "daemon/child/child.hpp"
#include "daemon/configuration/configuration.hpp"
#include "daemon/log/log.hpp"
#include "discovery/participant/participant.hpp"
#include "env/asio/asio_env.hpp"

namespace geminga::daemon {

/// Runs `geminga-ontology describe` as a child in a cage: the daemon itself reads no RDF.
class DescriptionInForce {
 public:
  /// Borrows all for its life. `after_event` is called on the event loop after the description has changed.
  DescriptionInForce(boost::asio::io_context& context, env::AsioEnv& env, Log& log, std::function<void()> after_event)
      : context_(context), env_(env), log_(log), after_event_(std::move(after_event)) {}

  /// Has the file of this configuration read, and describes the participant by it. What cannot be read leaves the
  /// description as it is. A reading that is under way is given up. `participant` is borrowed until stop().
  void load(const Configuration& configuration, participant::Participant& participant);
  /// Has it read without bringing it into force, and tries the expression with this vocabulary. `done` gets the faults
  /// for which it would not come into force, one a line.
  void check(const Configuration& configuration, participant::Participant::Vocabulary vocabulary,
             std::function<void(std::vector<std::string>)> done);
  /// Changes nothing from now on.
  void stop() { child_.reset(); }

 private:
  /// The expression and what the reader remarked on, or what is wrong.
  struct Described {
    std::string expression;
    std::vector<std::string> remarks;
  };
  using Done = std::function<void(const std::expected<Described, std::vector<std::string>>&)>;

  void read(const Configuration& configuration, Done done);
  [[nodiscard]] std::vector<std::string> faults_of(const std::string& expression,
                                                   const participant::Participant::Vocabulary& vocabulary) const;
  [[nodiscard]] std::expected<Described, std::vector<std::string>> described_at(const ChildEnd& end);

  boost::asio::io_context& context_;
  env::AsioEnv& env_;
  Log& log_;
  std::function<void()> after_event_;
  std::string file_;
  std::unique_ptr<base::PrivateFile> output_;  ///< of the child
  std::unique_ptr<Child> child_;               ///< null: nothing is being read
};

}  // namespace geminga::daemon

#endif
