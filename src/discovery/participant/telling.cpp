// Events, and the pictures that stand for those that were left out.
#include "discovery/participant/telling.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "discovery/gcnp/event.hpp"
#include "discovery/participant/naming.hpp"
#include "geminga/event.hpp"

namespace geminga::participant {
namespace {

/// Told together, so that a small subscription is told all of its services at once and best first.
constexpr std::size_t picture_piece = 32;
/// Why something is gone that went while the peer did not read: what happened in between is not known any more.
constexpr const char* lagged = "lagged";

/// What one event says about one pair. `match` is meaningful for what is there.
struct News {
  Change change = Change::add;
  ServiceKey about;
  matching::Match match;
  std::string reason;  ///< for del
  /// How what is there is converted; null: it need not be.
  std::shared_ptr<const vocabulary::Chain> chain{};
};

/// What was said last of an entry. Many requests are told the same of it, but for their number in front.
template <typename Entry>
struct SaidOf {
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

struct Said {
  SaidOf<registry::PublicationEntry> publication;
  SaidOf<registry::SubscriptionEntry> subscription;

  SaidOf<registry::PublicationEntry>& of(const registry::PublicationEntry*) { return publication; }
  SaidOf<registry::SubscriptionEntry>& of(const registry::SubscriptionEntry*) { return subscription; }
};

ServiceKey own_key(const Core& core, const Session& session, std::uint32_t number) {
  return ServiceKey{.participant = core.id, .peer = session.peer(), .number = number};
}

void fill(const Core& core, const ServiceKey& own, const registry::PublicationEntry& entry,
          const vocabulary::Chain* chain, ServiceEvent& told) {
  told.publication = named(core.vocabulary(), entry.publication);
  if (chain == nullptr) return;
  told.convert = core.matcher.chain_words(own, *chain);
  told.cost = chain->cost;
  told.via = chain->via;
}

void fill(const Core& core, const ServiceKey&, const registry::SubscriptionEntry& entry, const vocabulary::Chain*,
          ConsumerEvent& told) {
  told.subscribed = named(core.vocabulary(), entry.subscription);
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

/// `entry` may be null for del.
template <typename Entry>
void say(Core& core, Session& session, std::uint32_t number, const News& news,
         const std::shared_ptr<const Entry>& entry, Said& said) {
  SaidOf<Entry>& last = said.of(entry.get());
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
    fill(core, own_key(core, session, number), *entry, news.chain.get(), told);
  }
  std::string line = gcnp::to_line(gcnp::to_statement(number, told));
  session.say(line);
  if (entry != nullptr) last = {news, entry, line.substr(line.find(' '))};
}

/// Chooses the word that fits what the peer knows: no `add` for what it knows already, no `del` for what it does not
/// know.
template <typename Entry>
void tell(Core& core, Session& session, std::uint32_t number, News news, const std::shared_ptr<const Entry>& entry,
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
  ++core.counters.events;
  ++session.events;
  say(core, session, number, news, entry, said);
}

/// Whether the peer has so much to read that it is not told of each change.
bool must_wait(Core& core, Session& session, std::uint32_t number) {
  if (core.backlog(session) <= core.settings.limits.unread) return false;
  if (!session.lags_since) {
    session.lags_since = core.env.now();
    session.lag_backlog = core.backlog(session);
    ++core.counters.lags;
  }
  session.pictures[number] = {};
  return true;
}

void deliver(Core& core, Session& session, const matching::Event& event, Said& said) {
  const std::uint32_t number = event.to.number;
  std::visit(
      [&](const auto& about) {
        const auto picture = session.pictures.find(number);
        if (picture != session.pictures.end() && picture->second.will_tell(about->key)) return;
        if (must_wait(core, session, number)) return;
        News news{
            .change = event.change, .about = about->key, .match = event.match, .reason = {}, .chain = event.chain};
        if (event.change == Change::del) news.reason = to_string(event.reason);
        tell(core, session, number, std::move(news), about, said);
      },
      event.about);
}

/// An entry of the registry as an event has it, without a copy: for the length of one call.
template <typename Entry>
std::shared_ptr<const Entry> borrowed(const Entry* entry) {
  return {std::shared_ptr<const Entry>(), entry};
}

/// How things stand between a request and one service or consumer, told as a change.
void tell_state(Core& core, Session& session, std::uint32_t number, const ServiceKey& about) {
  const ServiceKey own = own_key(core, session, number);
  const bool is_offer = session.publications.contains(number);
  if (!is_offer) core.matcher.catch_up(own);
  const auto match = is_offer ? core.matcher.given(about, own) : core.matcher.given(own, about);
  News news{.change = match ? Change::add : Change::del, .about = about, .match = {}, .reason = lagged};
  if (match) news.match = *match;
  if (match) news.reason.clear();
  if (!is_offer && match && match->cost != 0) news.chain = core.matcher.chain(own, about);
  Said said;
  if (is_offer) {
    tell(core, session, number, std::move(news), borrowed(core.matcher.find_subscription(about)), said);
  } else {
    tell(core, session, number, std::move(news), borrowed(core.matcher.find_publication(about)), said);
  }
}

void begin(Core& core, Session& session, std::uint32_t number, Picture& picture) {
  const ServiceKey own = own_key(core, session, number);
  std::vector<ServiceKey> current;
  if (session.publications.contains(number)) {
    current = core.matcher.consumers(own);
    std::ranges::sort(current);
  } else {
    current = core.matcher.chosen(own);
  }
  const std::set<ServiceKey> there(current.begin(), current.end());
  std::vector<ServiceKey> former;
  std::ranges::set_difference(session.told[number], there, std::back_inserter(former));
  picture.begin(std::move(current), std::move(former));
}

}  // namespace

void deliver_events(Core& core) {
  Said said;
  Session* session = nullptr;  // events for one peer often follow each other
  for (const matching::Event& event : core.matcher.take_events()) {
    core.worked += cost_of_entry;
    if (session == nullptr || session->peer() != event.to.peer) session = core.find(event.to.peer);
    if (session != nullptr) deliver(core, *session, event, said);  // else its peer has gone
  }
  core.is_changed |= core.matcher.take_choice_change();
  for (const matching::Clash& clash : core.matcher.take_clashes()) {
    Session* told = core.find(clash.to.peer);
    if (told == nullptr || core.backlog(*told) > core.settings.limits.unread) continue;
    core.refuse(*told, clash.to.number, {ErrorCode::already_exists, clash.text});
  }
}

void tell_gone(Core& core, Session& session, std::uint32_t number, matching::Reason reason) {
  deliver_events(core);  // What is on its way may tell a part of it.
  const auto told = session.told.find(number);
  if (told == session.told.end()) return;
  if (must_wait(core, session, number)) return;
  const std::vector<ServiceKey> keys(told->second.begin(), told->second.end());
  Said said;
  for (const ServiceKey& key : keys) {
    News news{.change = Change::del, .about = key, .match = {}, .reason = std::string(to_string(reason))};
    if (session.publications.contains(number)) {
      tell<registry::SubscriptionEntry>(core, session, number, std::move(news), nullptr, said);
    } else {
      tell<registry::PublicationEntry>(core, session, number, std::move(news), nullptr, said);
    }
  }
  session.told.erase(number);
}

bool has_picture(const Session& session) { return !session.pictures.empty(); }

void proceed_picture(Core& core, Session& session) {
  if (session.lags_since) {
    session.lags_since.reset();
    session.say(gcnp::Statement{.id = 0, .command = "msg", .subcommand = "lagged", .parameters = {}});
  }
  const auto due = session.pictures.begin();
  const std::uint32_t number = due->first;
  Picture& picture = due->second;
  if (!picture.has_begun()) begin(core, session, number, picture);
  for (std::size_t count = 0; count < picture_piece; ++count) {
    const auto key = picture.next();
    if (!key) {
      session.pictures.erase(due);
      return;
    }
    tell_state(core, session, number, *key);
  }
}

}  // namespace geminga::participant
