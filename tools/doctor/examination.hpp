// One look at everything: this host, its daemon, the link and the team. geminga-query doctor prints it, geminga-web
// serves it.
#ifndef GEMINGA_DOCTOR_EXAMINATION_HPP
#define GEMINGA_DOCTOR_EXAMINATION_HPP

#include <boost/json/object.hpp>
#include <expected>
#include <optional>
#include <string>
#include <string_view>

#include "doctor/answers.hpp"
#include "doctor/finding.hpp"
#include "doctor/host.hpp"
#include "doctor/other_view.hpp"
#include "geminga/client.hpp"

namespace geminga::doctor {

struct Examination {
  Findings findings;  ///< the worst first, without what follows from another one
  Host host;
  std::optional<Answers> answers;  ///< nothing: no daemon answers
  std::optional<OtherView> other;  ///< of the participant `with`
};

struct Wish {
  std::string_view version;  ///< of this program
  std::string connect{};     ///< where the daemon was looked for; empty: at its usual address
  std::string with{};        ///< a participant whose view is asked for, too; empty: none
};

/// Looks at the beginning and at the end of an interval and a quarter, five seconds at most. `client` is the connection
/// to the daemon, or why there is none. Errors: the daemon goes away meanwhile.
[[nodiscard]] std::expected<Examination, ClientError> examine(Result<Client, ClientError>& client, const Wish& wish);

/// The document of `geminga-query --json doctor`.
[[nodiscard]] boost::json::object to_json(const Examination& examination);

}  // namespace geminga::doctor

#endif
