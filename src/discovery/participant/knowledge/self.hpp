// The identifier and the name of this participant, as its registry and its clients know it.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_SELF_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_SELF_HPP

#include <string>

#include "geminga/service.hpp"

namespace geminga::participant {

struct Self {
  /// 0 until an identifier is claimed. After a clash it stays until another one is claimed.
  ParticipantId id{};
  std::string stated_name;  ///< may be empty

  /// The name that the team uses: the identifier where no name is stated.
  [[nodiscard]] std::string name() const { return stated_name.empty() ? to_string(id) : stated_name; }
  /// Whether an identifier has been claimed, so that services can be entered under it.
  [[nodiscard]] bool is_claimed() const { return id != ParticipantId{}; }
  /// Whether a request is one of ours; 0 stands for a peer of ours, too.
  [[nodiscard]] bool is_ours(ParticipantId from) const { return from == ParticipantId{} || from == id; }
};

}  // namespace geminga::participant

#endif
