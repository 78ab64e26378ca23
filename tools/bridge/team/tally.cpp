#include "bridge/team/tally.hpp"

#include <algorithm>
#include <utility>

#include "bridge/team/limits.hpp"

namespace geminga::bridge {

Tally::Tally(client::Reactor& reactor, Tell tell)
    : reactor_(reactor), tell_(std::move(tell)), timer_(reactor, [this] { this->tell(); }) {}

void Tally::count(std::string_view reason) {
  const auto found = counts_.find(reason);
  if (found == counts_.end()) {
    counts_.emplace(reason, 1);
  } else {
    ++found->second;
  }
  if (timer_.at() == base::never) timer_.set(std::max(reactor_.now(), told_at_ + tally_pause));
}

std::uint64_t Tally::of(std::string_view reason) const {
  const auto found = counts_.find(reason);
  return found == counts_.end() ? 0 : found->second;
}

void Tally::tell() {
  told_at_ = reactor_.now();
  std::string line;
  for (const auto& [reason, count] : counts_) line += (line.empty() ? "" : ", ") + std::to_string(count) + ' ' + reason;
  tell_("left out since the start: " + line);
}

}  // namespace geminga::bridge
