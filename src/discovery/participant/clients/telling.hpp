// Telling: events of the matcher to the peers whose requests they concern, at once or when a peer's turn comes.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_TELLING_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_TELLING_HPP

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>

#include "discovery/gcnp/way.hpp"
#include "discovery/matching/matcher.hpp"
#include "discovery/participant/clients/key_telling.hpp"
#include "discovery/participant/clients/limits.hpp"
#include "discovery/participant/clients/sessions.hpp"
#include "discovery/participant/knowledge/self.hpp"
#include "discovery/participant/knowledge/work.hpp"
#include "env/env.hpp"

namespace geminga::participant {

/// Per request and service each peer is told add (modify)* del, even if some changes were left out because it lagged.
class Telling {
 public:
  /// Tells the way to a participant.
  using WayOf = std::function<gcnp::Way(ParticipantId)>;
  /// Borrows all for its life. Of the matcher it takes the events, and has it judge a stale subscription that is told.
  Telling(const env::Env& env, const ClientLimits& limits, const Self& self, matching::Matcher& matcher,
          Sessions& sessions, KeyTelling& keys, WorkMeter& work, WayOf way_of)
      : env_(env),
        limits_(limits),
        self_(self),
        matcher_(matcher),
        sessions_(sessions),
        keys_(keys),
        work_(work),
        way_of_(std::move(way_of)) {}

  /// Hands the events of the matcher to the peers, in its order. O(events).
  void deliver_events();
  /// Tells a peer that everything is gone that it was told of for this request, which it keeps.
  void tell_gone(Session& session, std::uint32_t number, matching::Reason reason);
  /// Tells the next piece of the resync of the request with the smallest number; there must be one.
  void proceed_resync(Session& session);

 private:
  struct News;
  struct Said;

  [[nodiscard]] ServiceKey key_of(const Session& session, std::uint32_t number) const;
  [[nodiscard]] bool must_wait(Session& session, std::uint32_t number);
  void deliver(Session& session, const matching::Event& event, Said& said);
  template <typename Entry>
  void tell(Session& session, std::uint32_t number, News news, const std::shared_ptr<const Entry>& entry, Said& said);
  template <typename Entry>
  void say(Session& session, std::uint32_t number, const News& news, const std::shared_ptr<const Entry>& entry,
           Said& said);
  void tell_as_it_stands(Session& session, std::uint32_t number, const ServiceKey& about);
  void begin(Session& session, std::uint32_t number, Resync& resync);

  const env::Env& env_;
  const ClientLimits& limits_;
  const Self& self_;
  matching::Matcher& matcher_;
  Sessions& sessions_;
  KeyTelling& keys_;
  WorkMeter& work_;
  WayOf way_of_;
};

}  // namespace geminga::participant

#endif
