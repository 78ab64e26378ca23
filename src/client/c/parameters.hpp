// Requests of the C interface, read from the parameters of a line of GCNP.
#ifndef GEMINGA_CLIENT_C_PARAMETERS_HPP
#define GEMINGA_CLIENT_C_PARAMETERS_HPP

#include <expected>
#include <string_view>

#include "geminga/error.hpp"
#include "geminga/named.hpp"

namespace geminga::client {

/// Reads the parameters of `pub create`. A missing port is 0: any.
[[nodiscard]] std::expected<NamedPublication, Error> read_publication(std::string_view parameters);
/// Reads the parameters of `sub create`.
[[nodiscard]] std::expected<NamedSubscription, Error> read_subscription(std::string_view parameters);
/// Reads the parameters of `pub modify` and `sub modify`.
[[nodiscard]] std::expected<PublicationChange, Error> read_publication_change(std::string_view parameters);
[[nodiscard]] std::expected<SubscriptionChange, Error> read_subscription_change(std::string_view parameters);

}  // namespace geminga::client

#endif
