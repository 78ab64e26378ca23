#include "discovery/participant/clients/wording.hpp"

#include "discovery/gcnp/event.hpp"
#include "discovery/participant/knowledge/naming.hpp"

namespace geminga::participant {
namespace {

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

}  // namespace

void Wording::fill(const ServiceKey& own, const registry::PublicationEntry& entry, const vocabulary::Chain* chain,
                   ServiceEvent& told) const {
  told.publication = named(editions_.vocabulary(), entry.publication);
  if (chain == nullptr) return;
  told.convert = choices_.chain_words(own, *chain);
  told.cost = chain->cost;
  told.via = chain->via;
}

void Wording::fill(const ServiceKey&, const registry::SubscriptionEntry& entry, const vocabulary::Chain*,
                   ConsumerEvent& told) const {
  told.subscribed = named(editions_.vocabulary(), entry.subscription);
}

template <typename Entry>
std::string Wording::line(PeerId peer, std::uint32_t number, const News& news,
                          const std::shared_ptr<const Entry>& entry, Said& said) const {
  auto& last = said.line(entry.get());
  if (last.fits(news, entry)) return std::to_string(number) + last.behind_number;
  auto told = event_about(entry.get(), news.about);
  told.change = news.change;
  told.reason = news.reason;
  if (news.change != Change::del) {
    told.peer_name = entry->peer_name;
    told.participant_name = entry->participant_name;
    told.degree = news.match.degree;
    told.distance = news.match.distance;
    fill({.participant = self_.id, .peer = peer, .number = number}, *entry, news.chain.get(), told);
    gcnp::Way way = way_of_(news.about.participant);
    told.hops = static_cast<std::uint32_t>(way.hops);
    told.path = std::move(way.path);
    told.reachable = entry->is_reachable;
  }
  std::string line = gcnp::to_line(gcnp::to_statement(number, told));
  if (entry != nullptr) last = {news, entry, line.substr(line.find(' '))};
  return line;
}
template std::string Wording::line(PeerId, std::uint32_t, const News&,
                                   const std::shared_ptr<const registry::PublicationEntry>&, Said&) const;
template std::string Wording::line(PeerId, std::uint32_t, const News&,
                                   const std::shared_ptr<const registry::SubscriptionEntry>&, Said&) const;

}  // namespace geminga::participant
