#include "web/asking/recent_answers.hpp"

#include <algorithm>
#include <utility>

namespace geminga::web {

Outcome RecentAnswers::find(const Query& query, base::Instant now) {
  drop_old(now);
  const auto found = std::ranges::find(kept_, query, &Kept::query);
  return found == kept_.end() ? nullptr : found->outcome;
}

void RecentAnswers::put(Query query, Outcome outcome, std::size_t octets, base::Instant now) {
  drop_old(now);
  if (octets > max_recent_octets) return;
  kept_.push_back({std::move(query), std::move(outcome), octets, now});
  octets_ += octets;
  while (kept_.size() > max_recent_answers || octets_ > max_recent_octets) drop_eldest();
}

void RecentAnswers::clear() {
  kept_.clear();
  octets_ = 0;
}

void RecentAnswers::drop_eldest() {
  octets_ -= kept_.front().octets;
  kept_.pop_front();
}

void RecentAnswers::drop_old(base::Instant now) {
  while (!kept_.empty() && now - kept_.front().came >= answer_life) drop_eldest();
}

}  // namespace geminga::web
