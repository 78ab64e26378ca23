// How publications are listed; requests --unused shows them, too.
#ifndef GEMINGA_QUERY_SERVICES_HPP
#define GEMINGA_QUERY_SERVICES_HPP

#include "query/listing.hpp"

namespace geminga::query {

/// The publications that the parameters and `keeps` leave.
[[nodiscard]] Listing services_listing(std::vector<std::pair<std::string, std::string>> parameters,
                                       std::function<bool(const Record&)> keeps);

/// Who, what and where of a publication or subscription, for --watch.
[[nodiscard]] std::string service_line(const Record& record);

}  // namespace geminga::query

#endif
