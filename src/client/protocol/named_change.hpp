// Changes applied to a publication or subscription by names.
#ifndef GEMINGA_CLIENT_PROTOCOL_NAMED_CHANGE_HPP
#define GEMINGA_CLIENT_PROTOCOL_NAMED_CHANGE_HPP

#include "geminga/named.hpp"

namespace geminga::client {

void apply(const PublicationChange& change, NamedPublication& publication);
void apply(const SubscriptionChange& change, NamedSubscription& subscription);

}  // namespace geminga::client

#endif
