#include "discovery/participant/clients/telling.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "discovery/gcnp/event.hpp"
#include "discovery/participant/knowledge/naming.hpp"
#include "geminga/event.hpp"

namespace geminga::participant {

/// One event about one pair. `match` is meaningful unless it is a del.
struct Telling::News {
  Change change = Change::add;
  ServiceKey about;
  matching::Match match;
  std::string reason;  ///< for del
  /// The chain that converts what is there; null: it need not be converted.
  std::shared_ptr<const vocabulary::Chain> chain{};
};

/// The last line about a service and about a consumer. Many requests are told the same line but for the number in
/// front.
struct Telling::Said {
  template <typename Entry>
  struct Line {
    News news;
    std::shared_ptr<const Entry> entry;
    std::string behind_number;

    [[nodiscard]] bool fits(const News& other, const std::shared_ptr<const Entry>& about) const {
      if (entry == nullptr || about == nullptr || news.change != other.change || news.match != other.match ||
          news.reason != other.reason) {
        return false;
      }
      return entry == about || entry->same_as(*about);
    }
  };
  Line<registry::PublicationEntry> publication;
  Line<registry::SubscriptionEntry> subscription;

  Line<registry::PublicationEntry>& line(const registry::PublicationEntry*) { return publication; }
  Line<registry::SubscriptionEntry>& line(const registry::SubscriptionEntry*) { return subscription; }
};

namespace {

/// Services told together, so that a small subscription is told all of its services at once and best first.
constexpr std::size_t resync_piece = 32;
/// The reason of what went while the peer did not read: what happened in between is not known any more.
constexpr const char* lagged = "lagged";

void fill(const matching::Matcher& matcher, const ServiceKey& own, const registry::PublicationEntry& entry,
          const vocabulary::Chain* chain, ServiceEvent& told) {
  told.publication = named(matcher.editions().vocabulary(), entry.publication);
  if (chain == nullptr) return;
  told.convert = matcher.choices().chain_words(own, *chain);
  told.cost = chain->cost;
  told.via = chain->via;
}

void fill(const matching::Matcher& matcher, const ServiceKey&, const registry::SubscriptionEntry& entry,
          const vocabulary::Chain*, ConsumerEvent& told) {
  told.subscribed = named(matcher.editions().vocabulary(), entry.subscription);
}

ServiceEvent event_about(const registry::PublicationEntry*, const ServiceKey& key) {
  ServiceEvent told;
  told.service = key;
  return told;
}

ConsumerEvent event_about(const registry::SubscriptionEntry*, const ServiceKey& key) {
  ConsumerEvent told;
  told.subscription = key;
  return told;
}

/// An entry of the registry as an event has it, without a copy: for the length of one call.
template <typename Entry>
std::shared_ptr<const Entry> borrowed(const Entry* entry) {
  return {std::shared_ptr<const Entry>(), entry};
}

}  // namespace

ServiceKey Telling::key_of(const Session& session, std::uint32_t number) const {
  return ServiceKey{.participant = self_.id, .peer = session.peer(), .number = number};
}

/// `entry` may be null for del.
template <typename Entry>
void Telling::say(Session& session, std::uint32_t number, const News& news, const std::shared_ptr<const Entry>& entry,
                  Said& said) {
  auto& last = said.line(entry.get());
  if (last.fits(news, entry)) {
    session.say(std::to_string(number) + last.behind_number);
    return;
  }
  auto told = event_about(entry.get(), news.about);
  told.change = news.change;
  told.reason = news.reason;
  if (news.change != Change::del) {
    told.peer_name = entry->peer_name;
    told.participant_name = entry->participant_name;
    told.degree = news.match.degree;
    told.distance = news.match.distance;
    fill(matcher_, key_of(session, number), *entry, news.chain.get(), told);
    gcnp::Way way = way_of_(news.about.participant);
    told.hops = static_cast<std::uint32_t>(way.hops);
    told.path = std::move(way.path);
    told.reachable = entry->is_reachable;
  }
  std::string line = gcnp::to_line(gcnp::to_statement(number, told));
  session.say(line);
  if (entry != nullptr) last = {news, entry, line.substr(line.find(' '))};
}

/// Chooses the word that fits what the peer knows: `modify` instead of `add` for what it knows already, and no `del`
/// for what it does not know.
template <typename Entry>
void Telling::tell(Session& session, std::uint32_t number, News news, const std::shared_ptr<const Entry>& entry,
                   Said& said) {
  auto& told = session.told[number];
  const bool is_known = told.contains(news.about);
  if (news.change == Change::del) {
    if (!is_known) return;
    told.erase(news.about);
  } else {
    news.change = is_known ? Change::modify : Change::add;
    told.insert(news.about);
  }
  ++sessions_.counters.events;
  ++session.events;
  work_.add(cost_of_event);
  if constexpr (std::is_same_v<Entry, registry::PublicationEntry>) {
    if (news.change == Change::add) ++sessions_.counters.matched.at(std::to_underlying(news.match.degree));
    if (news.change != Change::del) keys_.tell(session, number, entry->publication.attributes);
  }
  say(session, number, news, entry, said);
}

/// Whether the peer has so much to read that it is not told of each change.
bool Telling::must_wait(Session& session, std::uint32_t number) {
  const std::size_t backlog = session.backlog(env_);
  if (backlog <= limits_.unread) return false;
  if (!session.lags_since) {
    session.lags_since = env_.now();
    session.lag_backlog = backlog;
    ++sessions_.counters.lags;
  }
  session.resyncs[number] = {};
  return true;
}

void Telling::deliver(Session& session, const matching::Event& event, Said& said) {
  const std::uint32_t number = event.to.number;
  std::visit(
      [&](const auto& about) {
        const auto resync = session.resyncs.find(number);
        if (resync != session.resyncs.end() && resync->second.will_tell(about->key)) return;
        if (must_wait(session, number)) return;
        News news{
            .change = event.change, .about = about->key, .match = event.match, .reason = {}, .chain = event.chain};
        if (event.change == Change::del) news.reason = to_string(event.reason);
        tell(session, number, std::move(news), about, said);
      },
      event.about);
}

void Telling::deliver_events() {
  Said said;
  Session* session = nullptr;  // events for one peer often follow each other
  for (const matching::Event& event : matcher_.take_events()) {
    work_.add(cost_of_entry);
    if (session == nullptr || session->peer() != event.to.peer) session = sessions_.find(event.to.peer);
    if (session != nullptr) deliver(*session, event, said);  // else its peer has gone
  }
  for (const matching::Clash& clash : matcher_.take_clashes()) {
    Session* told = sessions_.find(clash.to.peer);
    if (told == nullptr || told->backlog(env_) > limits_.unread) continue;
    sessions_.refuse(*told, clash.to.number, {ErrorCode::already_exists, clash.text});
  }
}

void Telling::tell_gone(Session& session, std::uint32_t number, matching::Reason reason) {
  deliver_events();  // Events on their way may tell a part of it.
  const auto told = session.told.find(number);
  if (told == session.told.end()) return;
  if (must_wait(session, number)) return;
  const std::vector<ServiceKey> keys(told->second.begin(), told->second.end());
  Said said;
  for (const ServiceKey& key : keys) {
    News news{.change = Change::del, .about = key, .match = {}, .reason = std::string(to_string(reason))};
    if (session.publications.contains(number)) {
      tell<registry::SubscriptionEntry>(session, number, std::move(news), nullptr, said);
    } else {
      tell<registry::PublicationEntry>(session, number, std::move(news), nullptr, said);
    }
  }
  session.told.erase(number);
}

void Telling::proceed_resync(Session& session) {
  if (session.lags_since) {
    session.lags_since.reset();
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

void Telling::begin(Session& session, std::uint32_t number, Resync& resync) {
  const ServiceKey own = key_of(session, number);
  std::vector<ServiceKey> current;
  if (const auto offer = session.publications.find(number); offer != session.publications.end()) {
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
void Telling::tell_as_it_stands(Session& session, std::uint32_t number, const ServiceKey& about) {
  const ServiceKey own = key_of(session, number);
  const bool is_offer = session.publications.contains(number);
  if (!is_offer) matcher_.catch_up(own);
  const auto match = is_offer ? matcher_.choices().given(about, own) : matcher_.choices().given(own, about);
  News news{.change = match ? Change::add : Change::del, .about = about, .match = {}, .reason = lagged};
  if (match) news.match = *match;
  if (match) news.reason.clear();
  if (!is_offer && match && match->cost != 0) news.chain = matcher_.choices().chain(own, about);
  Said said;
  if (is_offer) {
    tell(session, number, std::move(news), borrowed(matcher_.subscriptions().find_entry(about)), said);
  } else {
    tell(session, number, std::move(news), borrowed(matcher_.publications().find_entry(about)), said);
  }
}

}  // namespace geminga::participant
