// The words for services and their parts, the same in every table and line.
#ifndef GEMINGA_SHELL_DESCRIBE_HPP
#define GEMINGA_SHELL_DESCRIBE_HPP

#include <string>
#include <string_view>

#include "geminga/client.hpp"
#include "geminga/event.hpp"
#include "geminga/named.hpp"
#include "geminga/service.hpp"

namespace geminga::shell {

/// `vision@robot2`. Without a peer's name `3@robot2`, from the word PARTICIPANT/PEER; without a participant's name its
/// id.
[[nodiscard]] std::string who(std::string_view peer_word, std::string_view peer_name,
                              std::string_view participant_name);
/// `soccer:BallInfo in soccer:FieldFrame`, `4711`, `"text"`
[[nodiscard]] std::string identity_words(const NamedIdentity& identity);
[[nodiscard]] std::string identity_words(const Record& record);
/// The reasons of records that nobody answers (`because`). Where the identity alone makes them differ they say `it`
/// instead, so that they can be grouped: thirty requests that nobody offers have one reason.
[[nodiscard]] std::vector<std::string> reasons_of(const std::vector<Record>& records);
/// `10.0.0.2:5000`, `[fe80::1]:5000`, `:5000` without an address, or an empty text
[[nodiscard]] std::string place(std::string_view address, std::string_view port);
/// `frame=map rate=30`
[[nodiscard]] std::string attribute_words(const Attributes& attributes);
/// `0.4 s`, `3 min`, from seconds
[[nodiscard]] std::string duration_words(std::string_view seconds);

/// `7.6 MiB`: one decimal below ten, none above
[[nodiscard]] std::string number_words(double value, const char* unit);

/// One line of an event, e.g. `+ vision@robot2  soccer:BallInfo  narrower 1  otm/stream  10.0.0.2:5000`.
[[nodiscard]] std::string line_of(const ServiceEvent& event);
[[nodiscard]] std::string line_of(const ConsumerEvent& event);
/// The peer and the identity of an event, e.g. `vision@robot2  soccer:BallInfo`. An event `del` has neither.
[[nodiscard]] std::string name_of(const ServiceEvent& event);
[[nodiscard]] std::string name_of(const ConsumerEvent& event);
/// The line for a service or request that is gone: `- NAME  PARTICIPANT/PEER/NUMBER  reason`, without NAME where none
/// is known.
[[nodiscard]] std::string gone_line(std::string_view name, const ServiceKey& key, std::string_view reason);

}  // namespace geminga::shell

#endif
