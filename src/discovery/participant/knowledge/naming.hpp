// Full identities as peers are told them: in short names of the vocabulary in force.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_NAMING_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_NAMING_HPP

#include <cstdint>
#include <string>

#include "geminga/named.hpp"
#include "geminga/service.hpp"

namespace geminga::vocabulary {
class Vocabulary;
}

namespace geminga::participant {

/// `prefix:Name` where a prefix of the ontology fits, else `<IRI>`.
[[nodiscard]] NamedIdentity named(const vocabulary::Vocabulary& vocabulary, const Identity& identity);
[[nodiscard]] NamedPublication named(const vocabulary::Vocabulary& vocabulary, const Publication& publication);
[[nodiscard]] NamedSubscription named(const vocabulary::Vocabulary& vocabulary, const Subscription& subscription);

/// The ontology's digest as GCNP writes it: 16 hexadecimal digits, or `-` for 0, which means that none is loaded.
[[nodiscard]] std::string digest_word(std::uint64_t digest);

}  // namespace geminga::participant

#endif
