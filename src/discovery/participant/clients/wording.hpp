// The words of events: what a line says of a service or a consumer.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_WORDING_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_WORDING_HPP

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "discovery/gcnp/way.hpp"
#include "discovery/matching/choices.hpp"
#include "discovery/matching/editions.hpp"
#include "discovery/participant/knowledge/self.hpp"
#include "geminga/event.hpp"
#include "geminga/service.hpp"

namespace geminga::participant {

/// One event about one pair. `match` is meaningful unless it is a del.
struct News {
  Change change = Change::add;
  ServiceKey about;
  matching::Match match;
  std::string reason;  ///< for del
  /// The chain that converts what is there; null: it need not be converted.
  std::shared_ptr<const vocabulary::Chain> chain{};
};

/// The last line about a service and about a consumer. Many requests are told the same line but for the number in
/// front.
struct Said {
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

class Wording {
 public:
  /// Tells the way to a participant.
  using WayOf = std::function<gcnp::Way(ParticipantId)>;
  /// Borrows all but `way_of` for its life.
  Wording(const Self& self, const matching::Editions& editions, const matching::Choices& choices, WayOf way_of)
      : self_(self), editions_(editions), choices_(choices), way_of_(std::move(way_of)) {}

  /// The line for a request of a peer of ours, with its end. `entry` may be null for del; `said` is what was said last.
  template <typename Entry>
  [[nodiscard]] std::string line(PeerId peer, std::uint32_t number, const News& news,
                                 const std::shared_ptr<const Entry>& entry, Said& said) const;

 private:
  void fill(const ServiceKey& own, const registry::PublicationEntry& entry, const vocabulary::Chain* chain,
            ServiceEvent& told) const;
  void fill(const ServiceKey& own, const registry::SubscriptionEntry& entry, const vocabulary::Chain* chain,
            ConsumerEvent& told) const;

  const Self& self_;
  const matching::Editions& editions_;
  const matching::Choices& choices_;
  WayOf way_of_;
};

}  // namespace geminga::participant

#endif
