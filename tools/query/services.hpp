// The listing of publications, which requests --unused shows, too.
#ifndef GEMINGA_QUERY_SERVICES_HPP
#define GEMINGA_QUERY_SERVICES_HPP

#include "query/listing.hpp"

namespace geminga::query {

/// The publications that the FILTER words keep; with `unused` only those that no subscription asks for.
[[nodiscard]] Listing services_listing(const std::vector<std::string>& words, bool unused);

/// The keys of a subscription beside its identity, mode, providers and condition: `convert=yes scope=team`.
[[nodiscard]] std::string request_words(const Record& record);

/// The line of a publication or subscription for --watch.
[[nodiscard]] std::string service_line(const Record& record);

}  // namespace geminga::query

#endif
