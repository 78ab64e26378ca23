// Answers of the last moments, so that many readers of the same cost the daemon one question.
#ifndef GEMINGA_WEB_ASKING_RECENT_ANSWERS_HPP
#define GEMINGA_WEB_ASKING_RECENT_ANSWERS_HPP

#include <cstddef>
#include <deque>

#include "base/time.hpp"
#include "web/asking/asker.hpp"
#include "web/asking/limits.hpp"

namespace geminga::web {

/// Holds at most max_recent_answers of max_recent_octets together.
class RecentAnswers {
 public:
  /// The answer to the same question if it came within answer_life; null if there is none.
  [[nodiscard]] Outcome find(const Query& query, base::Instant now);
  /// Keeps an answer of so many octets.
  void put(Query query, Outcome outcome, std::size_t octets, base::Instant now);
  void clear();
  [[nodiscard]] std::size_t size() const { return kept_.size(); }

 private:
  struct Kept {
    Query query;
    Outcome outcome;
    std::size_t octets = 0;
    base::Instant came;
  };

  void drop_eldest();
  void drop_old(base::Instant now);

  std::deque<Kept> kept_;  ///< the eldest first
  std::size_t octets_ = 0;
};

}  // namespace geminga::web

#endif
