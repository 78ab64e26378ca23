// A parcel offered to the team as a service, until the program is ended (TRAVEL.md).
#ifndef GEMINGA_ONTOLOGY_TRAVEL_OFFERING_HPP
#define GEMINGA_ONTOLOGY_TRAVEL_OFFERING_HPP

#include <expected>
#include <functional>
#include <string>
#include <string_view>

#include "geminga/client.hpp"
#include "ontology/travel/parcel.hpp"

namespace geminga::ontology {

struct Offering {
  std::string connect;                                        ///< where the daemon is; empty: as ClientOptions has it
  bool is_open = false;                                       ///< also where channels are not sealed
  std::function<void(const std::string& participant)> begun;  ///< called once, when the daemon has accepted the service
  std::function<void(std::string_view line)> say;             ///< told when the daemon is away, and when it is back
};

/// The words of the error where channels are not sealed and must be.
[[nodiscard]] ClientError not_sealed();

/// Offers the parcel until SIGTERM, SIGINT or SIGHUP, and then withdraws it. Takes memory for the parcel and for what
/// waits for slow consumers (src/client/CHANNELS.md). Errors are those of Client::connect() and Node::publish(), and
/// not_sealed(), at the start or when the daemon's key goes.
[[nodiscard]] std::expected<void, ClientError> offer(const Parcel& parcel, const Offering& offering);

}  // namespace geminga::ontology

#endif
