// The doctor's findings, and all that it has seen, as JSON.
#ifndef GEMINGA_DOCTOR_REPORT_HPP
#define GEMINGA_DOCTOR_REPORT_HPP

#include <boost/json/object.hpp>
#include <cstdint>
#include <optional>
#include <string_view>

#include "doctor/answers.hpp"
#include "doctor/finding.hpp"
#include "doctor/host.hpp"
#include "doctor/other_view.hpp"

namespace geminga::doctor {

/// `failure` or `risk`
[[nodiscard]] std::string_view word(Severity severity);

[[nodiscard]] boost::json::object to_json(const Findings& findings);
[[nodiscard]] boost::json::object to_json(const OtherView& other);

enum class Names : std::uint8_t { as_they_are, numbered };

/// A report for somebody who helps: findings, this host and the team. It has no secret of a key and no payload of a
/// channel, since the daemon tells neither, and no attributes of services. With `numbered` the names of participants,
/// of local programs and of this user are `name1`, `name2`, ... everywhere, also within sentences.
[[nodiscard]] boost::json::object report_of(const Findings& findings, const Host& host,
                                            const std::optional<Answers>& answers,
                                            const std::optional<OtherView>& other, Names names);

}  // namespace geminga::doctor

#endif
