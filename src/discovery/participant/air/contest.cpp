#include "discovery/participant/air/contest.hpp"

namespace geminga::participant {

bool Contest::hear(const std::string& from, base::Instant now) {
  const bool is_new = !since_;
  if (is_new) {
    since_ = now;
    heard_ = 0;
  }
  ++heard_;
  last_ = now;
  from_ = from;
  if (!is_new && now - told_ < contest_reminder) return false;
  told_ = now;
  return true;
}

bool Contest::has_ended(base::Instant now) {
  if (!since_ || now - last_ < contest_quiet) return false;
  since_.reset();
  return true;
}

}  // namespace geminga::participant
