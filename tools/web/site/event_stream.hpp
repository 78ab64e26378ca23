// The changes of listings as server-sent events (HTML Living Standard, 9.2).
#ifndef GEMINGA_WEB_SITE_EVENT_STREAM_HPP
#define GEMINGA_WEB_SITE_EVENT_STREAM_HPP

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "answers/differences.hpp"
#include "web/asking/asker.hpp"

namespace geminga::web {

/// The events for one reader. Each message is one object of `geminga-query --watch --json`; first everything that is
/// there comes as `add`. An event of the name `daemon` says `{"up":false,"reason":"..."}` when the daemon goes, and
/// `{"up":true}` when it answers again, after which the differences to what was told before follow. With several
/// listings each message has the name of its kind, and an event `whole` follows when all that was there has been told.
///
/// Nothing waits for a slow reader: next() tells the differences between what the reader was told last and what is so
/// at the call, so that it skips what has come and gone between two calls. It holds an answer of each listing
/// (max_answer_octets).
class EventStream : public std::enable_shared_from_this<EventStream> {
 public:
  using Then = std::function<void(std::string)>;

  /// Borrows the asker. Requires that key_of() of each question's kind is not empty.
  EventStream(Asker& asker, std::vector<Query> questions);

  /// Asks the daemon, and gives the events since the last call; empty: none. One call at a time.
  void next(Then then);

 private:
  struct Listing {
    Query question;
    std::string key;
    answers::Known known{};
  };

  /// Asks about the listing at this place and those behind it. `told` are the events of those before.
  void proceed(std::size_t at, std::string told, Then then);
  void take(std::size_t at, const Outcome& outcome, std::string told, Then then);
  /// Asks why records have gone, and tells the differences.
  void explain(std::size_t at, answers::Known now, std::string told, Then then);
  std::string tell(Listing& listing, answers::Known now, const answers::Reasons& reasons);
  std::string tell_daemon(const std::string& absence);

  Asker& asker_;
  std::vector<Listing> listings_;
  bool was_up_ = true;
  bool is_whole_ = false;
};

}  // namespace geminga::web

#endif
