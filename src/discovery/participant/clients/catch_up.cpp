#include "discovery/participant/clients/catch_up.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace geminga::participant {
namespace {

/// Services told together, so that a small subscription is told all of its services at once and best first.
constexpr std::size_t resync_piece = 32;
/// The reason of what went while the peer did not read: what happened in between is not known any more.
constexpr const char* lagged = "lagged";

/// An entry of the registry as an event has it, without a copy: for the length of one call.
template <typename Entry>
std::shared_ptr<const Entry> borrowed(const Entry* entry) {
  return {std::shared_ptr<const Entry>(), entry};
}

}  // namespace

ServiceKey CatchUp::key_of(const Session& session, std::uint32_t number) const {
  return ServiceKey{.participant = self_.id, .peer = session.peer(), .number = number};
}

void CatchUp::proceed(Session& session) {
  if (session.lag.is_any()) {
    session.lag.end();
    session.say(gcnp::Statement{.id = 0, .command = "msg", .subcommand = "lagged", .parameters = {}});
  }
  const auto due = session.resyncs.begin();
  const std::uint32_t number = due->first;
  Resync& resync = due->second;
  if (!resync.has_begun()) begin(session, number, resync);
  for (std::size_t count = 0; count < resync_piece; ++count) {
    const auto key = resync.next();
    if (!key) {
      session.resyncs.erase(due);
      return;
    }
    tell_as_it_stands(session, number, *key);
  }
}

void CatchUp::begin(Session& session, std::uint32_t number, Resync& resync) {
  const ServiceKey own = key_of(session, number);
  std::vector<ServiceKey> current;
  if (const auto offer = session.services.publications.find(number); offer != session.services.publications.end()) {
    keys_.tell(session, number, offer->second.service.attributes);
    current = matcher_.choices().consumers(own);
    std::ranges::sort(current);
  } else {
    current = matcher_.choices().chosen(own);
  }
  const std::set<ServiceKey> there(current.begin(), current.end());
  std::vector<ServiceKey> former;
  std::ranges::set_difference(session.told[number], there, std::back_inserter(former));
  resync.begin(std::move(current), std::move(former));
}

/// Tells how things stand between a request and one service or consumer, as a change.
void CatchUp::tell_as_it_stands(Session& session, std::uint32_t number, const ServiceKey& about) {
  const ServiceKey own = key_of(session, number);
  const bool is_offer = session.services.publications.contains(number);
  if (!is_offer) matcher_.catch_up(own);
  const auto match = is_offer ? matcher_.choices().given(about, own) : matcher_.choices().given(own, about);
  News news{.change = match ? Change::add : Change::del, .about = about, .match = {}, .reason = lagged};
  if (match) news.match = *match;
  if (match) news.reason.clear();
  if (!is_offer && match && match->cost != 0) news.chain = matcher_.choices().chain(own, about);
  if (is_offer) {
    telling_.tell(session, number, std::move(news), borrowed(matcher_.subscriptions().find_entry(about)));
  } else {
    telling_.tell(session, number, std::move(news), borrowed(matcher_.publications().find_entry(about)));
  }
}

}  // namespace geminga::participant
