// The view of another participant, which tells it over the air where its owner allows it: geminga-query doctor --with.
#ifndef GEMINGA_DOCTOR_OTHER_VIEW_HPP
#define GEMINGA_DOCTOR_OTHER_VIEW_HPP

#include <chrono>
#include <expected>
#include <string>
#include <vector>

#include "doctor/answers.hpp"
#include "doctor/finding.hpp"
#include "geminga/client.hpp"

namespace geminga::doctor {

/// The time in which a participant that may answer does so, also where much is lost.
inline constexpr std::chrono::milliseconds time_to_answer{6000};

struct OtherView {
  std::string id;
  std::string name;
  bool is_known = false;     ///< it is heard here
  std::string path{};        ///< the relays on the way to it, joined by `/`; empty: it is heard directly
  bool is_answered = false;  ///< it has told its view
  Answers answers;           ///< status, interfaces and participants of it, as far as it tells
};

/// Asks the participant with this identifier, name or address for its view, by way of the local daemon. One behind a
/// relay is not asked, since relays pass no questions on (ANNOUNCEMENT.md, "Inquiries").
[[nodiscard]] std::expected<OtherView, ClientError> ask_other(Client& client, const Answers& ours,
                                                              const std::string& host);
/// Its troubles, and where the two views do not fit. `version` is that of this program.
[[nodiscard]] Findings check_other(const OtherView& other, const Answers& ours, std::string_view version);

/// One thing in both views.
struct Compared {
  std::string what;
  std::string here;
  std::string there;
};
/// Both views, row by row.
[[nodiscard]] std::vector<Compared> side_by_side(const OtherView& other, const Answers& ours);

}  // namespace geminga::doctor

#endif
