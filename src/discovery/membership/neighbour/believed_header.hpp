// The header of a participant's states: the part that is about the participant itself.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_BELIEVED_HEADER_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_BELIEVED_HEADER_HPP

#include <cstdint>
#include <string>
#include <utility>

#include "base/time.hpp"
#include "discovery/announcement/announcement.hpp"
#include "discovery/membership/neighbour/revocable.hpp"

namespace geminga::membership {

struct Header {
  std::string name;  ///< the identifier, where it announces none
  std::uint64_t ontology_digest = 0;
  base::Duration interval{};
  std::uint32_t lasting = 0;  ///< the lasting identity of all its incarnations; 0: it has none
  friend bool operator==(const Header&, const Header&) = default;
};

[[nodiscard]] inline Header header_of(const announcement::Announcement& state) {
  return {state.name.empty() ? to_string(state.participant) : state.name, state.ontology_digest, state.interval,
          state.lasting};
}

/// The header that is believed, and whether anybody has to be told of another one.
class BelievedHeader {
 public:
  BelievedHeader(Header header, base::Instant now) : header_(std::move(header), now) {}

  [[nodiscard]] const Header& value() const { return header_.value(); }
  /// Takes in the header of a state. Another one is taken unless the participant is contested and the present one is
  /// held. Returns whether it was taken.
  bool say(Header header, base::Instant now, base::Duration hold, bool is_contested) {
    if (header == value()) {
      header_.affirm(now);
      return false;
    }
    if (is_contested && header_.is_held(now, hold)) return false;
    header_.replace(std::move(header), now, hold);
    is_anew_ = true;
    return true;
  }
  /// Takes in that it still holds.
  void affirm(base::Instant now) { header_.affirm(now); }
  /// Undoes what was said less than `hold` ago.
  void roll_back(base::Instant now, base::Duration hold) { is_anew_ |= header_.roll_back(now, hold); }
  /// Whether it has changed since the last call.
  [[nodiscard]] bool take_anew() { return std::exchange(is_anew_, false); }

 private:
  Revocable<Header> header_;
  bool is_anew_ = false;
};

}  // namespace geminga::membership

#endif
