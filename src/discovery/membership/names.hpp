// Which participants have which name at which address.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NAMES_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NAMES_HPP

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "geminga/service.hpp"

namespace geminga::membership {

/// So many participants of one name at one address are looked for at most: a host has one daemon, a lab may run
/// several.
inline constexpr std::size_t max_namesakes = 8;

/// Found by name and address, so that a flood of newcomers costs no look at everybody.
class Names {
 public:
  struct Named {
    std::string name;
    std::string source;  ///< the address that it was first heard from
    friend auto operator<=>(const Named&, const Named&) = default;
  };

  /// Somebody has this name from now on.
  void update(ParticipantId id, const std::string& name, const std::string& source) {
    auto& known = names_[id];
    if (known.name == name && known.source == source) return;
    by_name_.erase({known, id});
    known = {name, source};
    by_name_.emplace(known, id);
  }
  void remove(ParticipantId id) {
    const auto known = names_.find(id);
    if (known == names_.end()) return;
    by_name_.erase({known->second, id});
    names_.erase(known);
  }
  /// All of this name and address; nobody where there are more than max_namesakes.
  [[nodiscard]] std::vector<ParticipantId> find(const Named& named) const {
    std::vector<ParticipantId> found;
    for (auto each = by_name_.lower_bound({named, ParticipantId{}}); each != by_name_.end() && each->first == named;
         ++each) {
      if (found.size() == max_namesakes) return {};
      found.push_back(each->second);
    }
    return found;
  }

 private:
  std::map<ParticipantId, Named> names_;
  std::set<std::pair<Named, ParticipantId>> by_name_;
};

}  // namespace geminga::membership

#endif
