// Participants with the same name at the same address, or with the same lasting identity.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NAMESAKES_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NAMESAKES_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/hash.hpp"
#include "geminga/service.hpp"

namespace geminga::membership {

/// The most participants of one name at one address that are looked for: a host has one daemon, a lab may run several.
/// The same for one lasting identity: more are copies of one disk, of which each would be asked whenever one starts.
inline constexpr std::size_t max_namesakes = 8;

[[nodiscard]] inline std::uint64_t hash_of(std::uint32_t lasting) { return lasting; }

/// Finds participants by a key, so that a flood of newcomers costs no look at all of them.
template <typename Key>
class ParticipantsByKey {
 public:
  /// Sets the key of a participant.
  void update(ParticipantId id, const Key& key) {
    const auto [known, is_new] = keys_.try_emplace(id, key);
    if (!is_new && known->second == key) return;
    if (!is_new) unlist(known->second, id);
    known->second = key;
    const Listed listed{hash_of(key), id};
    listed_.insert(std::ranges::lower_bound(listed_, listed), listed);
  }
  void remove(ParticipantId id) {
    const auto known = keys_.find(id);
    if (known == keys_.end()) return;
    unlist(known->second, id);
    keys_.erase(known);
  }
  /// The participants with this key; none if there are more than max_namesakes.
  [[nodiscard]] std::vector<ParticipantId> find(const Key& key) const {
    std::vector<ParticipantId> found;
    const std::uint64_t hash = hash_of(key);
    auto each = std::ranges::lower_bound(listed_, Listed{hash, ParticipantId{}});
    for (; each != listed_.end() && each->hash == hash; ++each) {
      if (keys_.find(each->id)->second != key) continue;
      if (found.size() == max_namesakes) return {};
      found.push_back(each->id);
    }
    return found;
  }

 private:
  /// Only candidates, as equal hashes are no proof of equal keys.
  struct Listed {
    std::uint64_t hash = 0;
    ParticipantId id{};
    friend auto operator<=>(const Listed&, const Listed&) = default;
  };
  void unlist(const Key& key, ParticipantId id) {
    listed_.erase(std::ranges::lower_bound(listed_, Listed{hash_of(key), id}));
  }

  std::map<ParticipantId, Key> keys_;
  std::vector<Listed> listed_;  ///< in ascending order
};

class Namesakes {
 public:
  struct NameAtAddress {
    std::string name;    ///< empty: it announces none
    std::string source;  ///< the address that it was first heard from
    friend bool operator==(const NameAtAddress&, const NameAtAddress&) = default;
    friend std::uint64_t hash_of(const NameAtAddress& key) { return base::hash64(key.source, base::hash64(key.name)); }
  };

  /// Sets the name and the lasting identity of a participant; 0: it has no lasting identity.
  void update(ParticipantId id, const NameAtAddress& name, std::uint32_t lasting) {
    by_name_.update(id, name);
    if (lasting == 0) {
      by_lasting_.remove(id);
    } else {
      by_lasting_.update(id, lasting);
    }
  }
  void remove(ParticipantId id) {
    by_name_.remove(id);
    by_lasting_.remove(id);
  }
  /// The participants of this name at this address, and those of this lasting identity; each once.
  [[nodiscard]] std::vector<ParticipantId> find(const NameAtAddress& name, std::uint32_t lasting) const {
    auto found = name.name.empty() ? std::vector<ParticipantId>{} : by_name_.find(name);
    if (lasting == 0) return found;
    for (const auto id : by_lasting_.find(lasting)) {
      if (std::ranges::find(found, id) == found.end()) found.push_back(id);
    }
    return found;
  }

 private:
  ParticipantsByKey<NameAtAddress> by_name_;
  ParticipantsByKey<std::uint32_t> by_lasting_;
};

}  // namespace geminga::membership

#endif
