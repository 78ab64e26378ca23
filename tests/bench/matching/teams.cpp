#include "bench/matching/teams.hpp"

#include <utility>

namespace geminga::matching {
namespace {

constexpr std::uint32_t here = 1;

}  // namespace

Identity rare_text() { return TextIdentity{"what only few offer"}; }

Identity identity(std::uint32_t of_class) {
  return SemanticIdentity{class_iri(of_class), "http://example.org/team#Frame"};
}

registry::PublicationEntry service(std::uint32_t number, Identity identity) {
  registry::PublicationEntry entry;
  entry.key = {ParticipantId{2 + number / 100}, PeerId{1}, number};
  entry.publication.identity = std::move(identity);
  entry.publication.address = "192.0.2.1";
  entry.publication.port = 5000;
  return entry;
}

registry::SubscriptionEntry wish(std::uint32_t number, Identity identity) {
  registry::SubscriptionEntry entry;
  entry.key = {ParticipantId{here}, PeerId{1}, number};
  entry.is_local = true;
  entry.subscription.identity = std::move(identity);
  return entry;
}

Strangers::Strangers(std::uint32_t size) : matcher(tree()) {
  base::Random random(size);
  for (std::uint32_t number = 0; number < size; ++number) matcher.put(wish(number, identity(common_class(random))));
}

Consumers::Consumers(std::uint32_t size) : matcher(tree()) {
  base::Random random(size);
  for (std::uint32_t number = 0; number < size - answers; ++number)
    matcher.put(wish(number, identity(common_class(random))));
  std::uint32_t wider = rare_class();
  for (std::uint32_t i = 0; i < answers; ++i, wider = class_above(wider)) {
    if (wider == 0) wider = rare_class();
    matcher.put(wish(size - answers + i, identity(wider)));
  }
}

Providers::Providers(std::uint32_t size) : matcher(tree()) {
  base::Random random(size);
  const auto identity_of = [&](std::uint32_t number) {
    if (number < answers) return identity(rare_class());
    return number < 2 * answers ? rare_text() : identity(common_class(random));
  };
  for (std::uint32_t number = 0; number < size; ++number) {
    entries.push_back(service(number, identity_of(number)));
    matcher.put(entries.back());
  }
}

}  // namespace geminga::matching
