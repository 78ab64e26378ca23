// Catching up: a peer that was not told of each change is told how things stand, piece by piece.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_CATCH_UP_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_CATCH_UP_HPP

#include <cstdint>

#include "discovery/matching/matcher.hpp"
#include "discovery/participant/clients/key_telling.hpp"
#include "discovery/participant/clients/session.hpp"
#include "discovery/participant/clients/telling.hpp"
#include "discovery/participant/knowledge/self.hpp"

namespace geminga::participant {

class CatchUp {
 public:
  /// Borrows all for its life. The matcher judges a stale subscription that is told.
  CatchUp(const Self& self, matching::Matcher& matcher, KeyTelling& keys, Telling& telling)
      : self_(self), matcher_(matcher), keys_(keys), telling_(telling) {}

  /// Tells the next piece of the resync of the request with the smallest number; there must be one.
  void proceed(Session& session);

 private:
  [[nodiscard]] ServiceKey key_of(const Session& session, std::uint32_t number) const;
  void begin(Session& session, std::uint32_t number, Resync& resync);
  void tell_as_it_stands(Session& session, std::uint32_t number, const ServiceKey& about);

  const Self& self_;
  matching::Matcher& matcher_;
  KeyTelling& keys_;
  Telling& telling_;
};

}  // namespace geminga::participant

#endif
