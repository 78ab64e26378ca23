// Ontologies that others offer and the owner of this host adopts: `geminga-ontology adopt` fetches them into folders,
// and the daemon finds them there.
#ifndef GEMINGA_DAEMON_ADOPTION_ADOPTION_HPP
#define GEMINGA_DAEMON_ADOPTION_ADOPTION_HPP

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace geminga::daemon {

/// The participants whose ontologies are adopted, and the place of these.
struct Adopted {
  std::string folder;                   ///< has a folder for each publisher, with one for each version in that
  std::vector<std::string> publishers;  ///< names or identifiers of participants; empty: nobody
  friend bool operator==(const Adopted&, const Adopted&) = default;
};

/// The folders of the versions that count: of each publisher the newest one at `level` 0, at 1 the one before, and so
/// on, where there is one. Names that are no whole numbers do not count, and neither do links. Without any from some
/// level on.
[[nodiscard]] std::vector<std::string> adopted_versions(const Adopted& adopted, std::size_t level);

/// Looks every two seconds whether there are other newest versions: in its cage the daemon cannot be notified of
/// changes in a folder.
class AdoptionWatch {
 public:
  /// `changed` is called on the event loop.
  AdoptionWatch(boost::asio::io_context& context, std::function<void()> changed);
  /// Takes the present versions as known, and watches for others. Does nothing where no participant is adopted.
  void watch(const Adopted& adopted);

 private:
  void look_later();

  boost::asio::steady_timer timer_;
  std::function<void()> changed_;
  Adopted adopted_;
  std::vector<std::string> seen_;
};

}  // namespace geminga::daemon

#endif
