#include "discovery/participant/clients/telling.hpp"

#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace geminga::participant {

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
  session.say(wording_.line(session.peer(), number, news, entry, said));
}

void Telling::tell(Session& session, std::uint32_t number, News news,
                   const std::shared_ptr<const registry::PublicationEntry>& entry) {
  Said said;
  tell(session, number, std::move(news), entry, said);
}

void Telling::tell(Session& session, std::uint32_t number, News news,
                   const std::shared_ptr<const registry::SubscriptionEntry>& entry) {
  Said said;
  tell(session, number, std::move(news), entry, said);
}

/// Whether the peer has so much to read that it is not told of each change.
bool Telling::must_wait(Session& session, std::uint32_t number) {
  const std::size_t backlog = session.backlog(env_);
  if (backlog <= limits_.unread) return false;
  if (session.lag.begin(backlog, env_.now())) ++sessions_.counters.lags;
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
    if (session.services.publications.contains(number)) {
      tell<registry::SubscriptionEntry>(session, number, std::move(news), nullptr, said);
    } else {
      tell<registry::PublicationEntry>(session, number, std::move(news), nullptr, said);
    }
  }
  session.told.erase(number);
}

}  // namespace geminga::participant
