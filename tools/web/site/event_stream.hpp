// The changes of a listing as server-sent events (HTML Living Standard, 9.2).
#ifndef GEMINGA_WEB_SITE_EVENT_STREAM_HPP
#define GEMINGA_WEB_SITE_EVENT_STREAM_HPP

#include <functional>
#include <memory>
#include <string>

#include "answers/differences.hpp"
#include "web/asking/asker.hpp"

namespace geminga::web {

/// The events for one reader. Each message is one object of `geminga-query --watch --json`; first everything that is
/// there comes as `add`. An event of the name `daemon` says `{"up":false,"reason":"..."}` when the daemon goes, and
/// `{"up":true}` when it answers again, after which the differences to what was told before follow.
///
/// Nothing waits for a slow reader: next() tells the differences between what the reader was told last and what is so
/// at the call, so that it skips what has come and gone between two calls. It holds one answer (max_answer_octets).
class EventStream : public std::enable_shared_from_this<EventStream> {
 public:
  using Then = std::function<void(std::string)>;

  /// Borrows the asker. Requires that key_of() of the question's kind is not empty.
  EventStream(Asker& asker, Query question);

  /// Asks the daemon, and gives the events since the last call; empty: none. One call at a time.
  void next(Then then);

 private:
  void take(const Outcome& outcome, const Then& then);
  /// Asks why records have gone, and tells the differences.
  void explain(answers::Known now, Then then);
  std::string tell(answers::Known now, const answers::Reasons& reasons);
  std::string tell_daemon(const std::string& absence);

  Asker& asker_;
  Query question_;
  std::string key_;
  answers::Known known_;
  bool was_up_ = true;
};

}  // namespace geminga::web

#endif
