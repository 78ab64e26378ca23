// Services and participants that come near what is asked for, with what is not known of them and what contradicts.
#ifndef GEMINGA_QUERY_NEAR_HPP
#define GEMINGA_QUERY_NEAR_HPP

#include <string>
#include <string_view>
#include <vector>

#include "query/listing.hpp"

namespace geminga::query {

/// The services that match, then those that come near.
[[nodiscard]] shell::Table table_of_near(const std::vector<Record>& records);

/// Whether a record is what was asked for, and does not only come near.
[[nodiscard]] bool is_match(const Record& record);

/// The participants that an expression describes, then those that come near, those that lack least first.
[[nodiscard]] Listing near_participants(const std::string& expression, const std::string& where);

/// `not known: A, B; contradicts: C`.
[[nodiscard]] std::string lack_words(const Record& record);

/// The identifier of the participant of a record of services.
[[nodiscard]] std::string participant_of(const Record& record);

}  // namespace geminga::query

#endif
