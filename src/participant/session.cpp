#include "participant/session.hpp"

#include <utility>

#include "base/assert.hpp"

namespace geminga::participant {

Session::Session(env::StreamId stream, PeerId peer, const Limits& limits)
    : name("peer-" + std::to_string(static_cast<std::uint32_t>(peer))),
      gate(limits.statements_per_second, limits.flood_per_second),
      stream_(stream),
      peer_(peer) {}

bool Session::hold(std::string_view line, const Limits& limits) {
  if (held_.size() >= limits.held_statements || held_bytes_ + line.size() > limits.held_bytes) return false;
  held_.emplace_back(line);
  held_bytes_ += line.size();
  return true;
}

std::string Session::take_held() {
  GEMINGA_ASSERT(!held_.empty());
  std::string line = std::move(held_.front());
  held_.pop_front();
  held_bytes_ -= line.size();
  return line;
}

std::string Session::take_outbox() { return std::exchange(outbox_, {}); }

}  // namespace geminga::participant
