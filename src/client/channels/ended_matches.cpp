#include "client/channels/ended_matches.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "client/protocol/limits.hpp"

namespace geminga::client {

EndedMatches::EndedMatches(Reactor& reactor, GiveBack give_back)
    : reactor_(reactor), give_back_(std::move(give_back)), timer_(reactor, [this] { give_due_back(); }) {}

void EndedMatches::keep(const ServiceEvent& event) {
  const base::Instant until = reactor_.now() + again_patience;
  ended_.insert_or_assign(event.service, Ended{event, until});
  // The timer stands at the end of an earlier one otherwise.
  if (timer_.at() == base::never) timer_.set(until);
}

void EndedMatches::modify(const ServiceEvent& event) {
  if (const auto found = ended_.find(event.service); found != ended_.end()) found->second.event = event;
}

void EndedMatches::give_due_back() {
  std::vector<ServiceEvent> due;
  base::Instant next = base::never;
  for (const auto& [key, ended] : ended_) {
    if (ended.until <= reactor_.now()) {
      due.push_back(ended.event);
      due.back().change = Change::add;
    } else {
      next = std::min(next, ended.until);
    }
  }
  timer_.set(next);
  for (const ServiceEvent& event : due) {
    ended_.erase(event.service);
    give_back_(event);
  }
}

}  // namespace geminga::client
