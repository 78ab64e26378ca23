// How publications are listed; requests --unused shows them, too.
#ifndef GEMINGA_QUERY_SERVICES_HPP
#define GEMINGA_QUERY_SERVICES_HPP

#include "query/listing.hpp"

namespace geminga::query {

/// The publications that the FILTER words leave, with `unused` those of them that nobody asks for.
[[nodiscard]] Listing services_listing(const std::vector<std::string>& words, bool unused);

/// What a subscription says beside its identity, mode, providers and condition: `convert=yes scope=team`.
[[nodiscard]] std::string request_words(const Record& record);

/// Who, what and where of a publication or subscription, for --watch.
[[nodiscard]] std::string service_line(const Record& record);

}  // namespace geminga::query

#endif
