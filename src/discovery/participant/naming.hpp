// From the names that peers use to full identities and back, by way of the vocabulary.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_NAMING_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_NAMING_HPP

#include <cstddef>
#include <expected>
#include <string>
#include <string_view>

#include "geminga/error.hpp"
#include "geminga/named.hpp"
#include "geminga/service.hpp"

namespace geminga::vocabulary {
class Vocabulary;
}

namespace geminga::participant {

class Expressions;

/// The identity with full IRIs. 422 where no ontology is loaded, a name is unknown or ambiguous, or a class can
/// have no instance. Numbers and texts need no ontology.
[[nodiscard]] std::expected<Identity, Error> resolve(const vocabulary::Vocabulary& vocabulary,
                                                     const NamedIdentity& named);

/// The same for what is asked for: the concept may be a class expression, too
/// (src/reasoning/syntax/manchester/MANCHESTER.md). One that is equivalent to a class is that class; of any other the
/// canonical text is the concept.
[[nodiscard]] std::expected<Identity, Error> resolve(Expressions& expressions, const vocabulary::Vocabulary& vocabulary,
                                                     const NamedIdentity& named);

/// As peers are told: `prefix:Name` where a prefix of the ontology fits, else `<IRI>`.
[[nodiscard]] NamedIdentity named(const vocabulary::Vocabulary& vocabulary, const Identity& identity);
[[nodiscard]] NamedPublication named(const vocabulary::Vocabulary& vocabulary, const Publication& publication);
[[nodiscard]] NamedSubscription named(const vocabulary::Vocabulary& vocabulary, const Subscription& subscription);

/// The ontology's digest as GCNP writes it: 16 hexadecimal digits, or `-` for 0, which means that none is loaded.
[[nodiscard]] std::string digest_word(std::uint64_t digest);

}  // namespace geminga::participant

#endif
