// Telling: events of the matcher to the peers whose requests they concern, at once or when a peer's turn comes.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_TELLING_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_TELLING_HPP

#include <cstdint>
#include <memory>
#include <utility>

#include "discovery/matching/matcher.hpp"
#include "discovery/participant/clients/key_telling.hpp"
#include "discovery/participant/clients/limits.hpp"
#include "discovery/participant/clients/sessions.hpp"
#include "discovery/participant/clients/wording.hpp"
#include "discovery/participant/knowledge/work.hpp"
#include "env/env.hpp"

namespace geminga::participant {

/// Per request and service each peer is told add (modify)* del, even if some changes were left out because it lagged.
class Telling {
 public:
  /// Borrows all for its life. Of the matcher it takes the events.
  Telling(const env::Env& env, const ClientLimits& limits, matching::Matcher& matcher, Sessions& sessions,
          KeyTelling& keys, WorkMeter& work, const Wording& wording)
      : env_(env),
        limits_(limits),
        matcher_(matcher),
        sessions_(sessions),
        keys_(keys),
        work_(work),
        wording_(wording) {}

  /// Hands the events of the matcher to the peers, in its order. O(events).
  void deliver_events();
  /// Tells a peer one change, which need not be news to it.
  void tell(Session& session, std::uint32_t number, News news,
            const std::shared_ptr<const registry::PublicationEntry>& entry);
  void tell(Session& session, std::uint32_t number, News news,
            const std::shared_ptr<const registry::SubscriptionEntry>& entry);
  /// Tells a peer that everything is gone that it was told of for this request, which it keeps.
  void tell_gone(Session& session, std::uint32_t number, matching::Reason reason);

 private:
  [[nodiscard]] bool must_wait(Session& session, std::uint32_t number);
  void deliver(Session& session, const matching::Event& event, Said& said);
  template <typename Entry>
  void tell(Session& session, std::uint32_t number, News news, const std::shared_ptr<const Entry>& entry, Said& said);

  const env::Env& env_;
  const ClientLimits& limits_;
  matching::Matcher& matcher_;
  Sessions& sessions_;
  KeyTelling& keys_;
  WorkMeter& work_;
  const Wording& wording_;
};

}  // namespace geminga::participant

#endif
