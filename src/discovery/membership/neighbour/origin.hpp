// How a participant was first heard.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_ORIGIN_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_ORIGIN_HPP

#include <string>

#include "discovery/announcement/announcement.hpp"
#include "discovery/membership/claim/first_claims.hpp"
#include "geminga/service.hpp"

namespace geminga::membership {

/// The origin of one incarnation of a participant, which stays as it is.
struct Origin {
  ParticipantId id{};
  announcement::BootNonce boot{};
  /// The source address that it was first heard from. It counts towards the limit of participants of that address.
  std::string source;
  /// When it was first heard under its identifier; a claim counts, too. Of several incarnations under one identifier
  /// the one that was heard first owns it.
  Turn since{};
};

}  // namespace geminga::membership

#endif
