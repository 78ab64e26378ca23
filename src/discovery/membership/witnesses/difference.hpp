// The difference of what two participants know, and what explains it.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_WITNESSES_DIFFERENCE_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_WITNESSES_DIFFERENCE_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "discovery/announcement/announcement.hpp"
#include "geminga/service.hpp"

namespace geminga::membership {

/// One participant as it is folded: two folds are alike only if both sides have the same revision of its state.
struct Folded {
  ParticipantId id{};
  announcement::BootNonce boot{};
  std::uint64_t revision = 0;  ///< 0: its state is not known in whole

  [[nodiscard]] std::uint16_t fold() const { return fold_of(revision); }
  [[nodiscard]] std::uint16_t fold_of(std::uint64_t another_revision) const;
};

/// The participants that another one does not know, among ourselves and those that we know. The difference of its fold
/// and ours tells them if they are one or two.
enum class Unknown : std::uint8_t {
  nobody,   ///< or the difference is old
  us,       ///< and perhaps another one
  others,   ///< which can tell it by the same rule
  unclear,  ///< more than two, or it knows somebody that we do not know
};

/// All that a difference of two folds tells.
struct Difference {
  Unknown unknown = Unknown::nobody;
  bool is_of_revisions = false;  ///< both know the same participants, but not the same revisions of their states
  bool lacks_our_state = false;  ///< it has an older state of us
  std::optional<ParticipantId> newer{};  ///< it has a newer state of this one than we have
};

/// Two are told apart among so many others at most. The pairs that are tried equal one of a fold's 65536 values by
/// chance with a probability of .02; then a presence or state is sent that nobody needed.
inline constexpr std::size_t max_told_apart = 15;
/// One that has another revision is found among so many others.
inline constexpr std::size_t max_told_revised = 64;
/// A state of another one may be so many revisions older or newer than ours: a daemon that is told of a robot's
/// services one by one counts each. In a pair, and among more than max_told_apart, it is a few.
inline constexpr std::uint64_t many_revisions = 16;
inline constexpr std::uint64_t few_revisions = 2;

/// Explains a difference between the fold of another participant and ours, which is not 0. `others` are all that we
/// know but the other one itself.
[[nodiscard]] Difference explain(std::uint16_t difference, const Folded& self, std::span<const Folded> others);
/// The same where there are max_told_revised others or more, which are not looked at.
[[nodiscard]] Difference explain_among_many(std::uint16_t difference, const Folded& self);

}  // namespace geminga::membership

#endif
