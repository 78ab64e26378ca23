// Which participants have which name at which address, and which lasting identity.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NAMES_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NAMES_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "geminga/service.hpp"

namespace geminga::membership {

/// So many participants of one name at one address are looked for at most: a host has one daemon, a lab may run
/// several. So many of one lasting identity, too: more are copies of one disk, of which each is asked whenever one
/// starts.
inline constexpr std::size_t max_namesakes = 8;

/// Found by what they have in common, so that a flood of newcomers costs no look at everybody.
template <typename Key>
class NameIndex {
 public:
  /// Somebody has this from now on.
  void update(ParticipantId id, const Key& key) {
    const auto [known, is_new] = keys_.try_emplace(id, key);
    if (!is_new && known->second == key) return;
    if (!is_new) by_key_.erase({known->second, id});
    known->second = key;
    by_key_.emplace(key, id);
  }
  void remove(ParticipantId id) {
    const auto known = keys_.find(id);
    if (known == keys_.end()) return;
    by_key_.erase({known->second, id});
    keys_.erase(known);
  }
  /// All that have it; nobody where there are more than max_namesakes.
  [[nodiscard]] std::vector<ParticipantId> find(const Key& key) const {
    std::vector<ParticipantId> found;
    for (auto each = by_key_.lower_bound({key, ParticipantId{}}); each != by_key_.end() && each->first == key; ++each) {
      if (found.size() == max_namesakes) return {};
      found.push_back(each->second);
    }
    return found;
  }

 private:
  std::map<ParticipantId, Key> keys_;
  std::set<std::pair<Key, ParticipantId>> by_key_;
};

class Names {
 public:
  struct Named {
    std::string name;    ///< empty: of no name
    std::string source;  ///< the address that it was first heard from
    friend auto operator<=>(const Named&, const Named&) = default;
  };

  /// Somebody has this name and this lasting identity from now on; 0: none.
  void update(ParticipantId id, const Named& named, std::uint32_t lasting) {
    by_name_.update(id, named);
    by_lasting_.update(id, lasting);
  }
  void remove(ParticipantId id) {
    by_name_.remove(id);
    by_lasting_.remove(id);
  }
  /// All of this name and address, and all of this identity, which may be the same ones.
  [[nodiscard]] std::vector<ParticipantId> find(const Named& named, std::uint32_t lasting) const {
    auto found = named.name.empty() ? std::vector<ParticipantId>{} : by_name_.find(named);
    if (lasting == 0) return found;
    for (const auto id : by_lasting_.find(lasting)) {
      if (std::ranges::find(found, id) == found.end()) found.push_back(id);
    }
    return found;
  }

 private:
  NameIndex<Named> by_name_;
  NameIndex<std::uint32_t> by_lasting_;
};

}  // namespace geminga::membership

#endif
