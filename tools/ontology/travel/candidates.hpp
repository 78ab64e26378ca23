// The ontologies that the team offers, as the daemon tells of them.
#ifndef GEMINGA_ONTOLOGY_TRAVEL_CANDIDATES_HPP
#define GEMINGA_ONTOLOGY_TRAVEL_CANDIDATES_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geminga/client.hpp"

namespace geminga::ontology {

/// The concept of the services that offer an ontology (ontology/core.ttl).
inline constexpr std::string_view ontology_concept = "https://geminga.example/core#Ontology";
/// The number of that concept, by which daemons find such services that have not loaded the core vocabulary.
[[nodiscard]] NumericIdentity ontology_number();

/// One service that offers an ontology.
struct Candidate {
  std::string service;           ///< PARTICIPANT/PEER/NUMBER
  std::string participant;       ///< its identifier
  std::string participant_name;  ///< empty: unknown
  std::string peer;              ///< its number
  std::string digest;
  std::uint64_t version = 0;  ///< 0: unstated
  friend bool operator==(const Candidate&, const Candidate&) = default;
};

/// The services of an answer to `query match`: those with a readable digest and version, the greatest version first,
/// then by digest and service. A name that a terminal could obey stays as it is: print it through base/harmless.hpp.
[[nodiscard]] std::vector<Candidate> candidates_in(const Answer& answer);
/// Asks the daemon for them.
[[nodiscard]] std::expected<std::vector<Candidate>, ClientError> candidates(Client& client);

/// Whether this host seals channels, and takes none that are not: then nobody without the team's key takes part.
[[nodiscard]] std::expected<bool, ClientError> are_channels_sealed(Client& client);

}  // namespace geminga::ontology

#endif
