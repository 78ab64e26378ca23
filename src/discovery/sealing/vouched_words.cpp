#include "discovery/sealing/vouched_words.hpp"

namespace geminga::sealing {
namespace {

/// A word counts once, on whatever interface it comes.
constexpr env::InterfaceIndex any{};

}  // namespace

bool VouchedWords::take(Session session, std::uint32_t counter, base::Instant now) {
  Known* known = sessions_.find(session);
  if (known == nullptr) {
    sessions_.add(session, {ReplayWindow(any, counter, now, false), now});
    return true;
  }
  if (!known->window.is_open(any, counter, now)) return false;
  known->window.take(any, counter, now, false);
  known->heard = now;
  return true;
}

}  // namespace geminga::sealing
