// Small entries for tests of the registry.
#ifndef GEMINGA_TESTS_DISCOVERY_REGISTRY_ENTRIES_HPP
#define GEMINGA_TESTS_DISCOVERY_REGISTRY_ENTRIES_HPP

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "discovery/registry/table.hpp"

namespace geminga::registry {

inline ServiceKey key(std::uint32_t participant, std::uint32_t peer, std::uint32_t number) {
  return {ParticipantId{participant}, PeerId{peer}, number};
}

inline base::Instant at(int seconds) { return base::Instant(std::chrono::seconds(seconds)); }

inline PublicationEntry offer(const ServiceKey& key, Identity identity, base::Instant updated = at(0)) {
  PublicationEntry entry;
  entry.key = key;
  entry.publication.identity = std::move(identity);
  entry.updated = updated;
  return entry;
}

inline Identity semantic(const std::string& concept_name, const std::string& representation = {}) {
  const std::string prefix = "http://example.org/";
  return SemanticIdentity{prefix + concept_name, representation.empty() ? "" : prefix + representation};
}

/// The keys of entries that were filed in no particular order, ascending.
template <typename Filed>
std::vector<ServiceKey> keys_of_filed(const Filed& filed) {
  std::vector<ServiceKey> keys;
  for (const auto& one : filed) keys.push_back(one.stored->entry.key);
  std::ranges::sort(keys);
  return keys;
}

/// The keys of entries in the order in which they were given.
template <typename StoredEntry>
std::vector<ServiceKey> keys_of(const std::vector<const StoredEntry*>& entries) {
  std::vector<ServiceKey> keys;
  for (const auto* stored : entries) keys.push_back(stored->entry.key);
  return keys;
}

}  // namespace geminga::registry

#endif
