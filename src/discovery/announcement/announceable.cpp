#include "discovery/announcement/announceable.hpp"

#include <limits>
#include <string>

#include "discovery/announcement/fault.hpp"
#include "discovery/announcement/limits.hpp"
#include "discovery/announcement/wire_entry.hpp"

namespace geminga::announcement {
namespace {

/// The numbers of up to two terms and their namespaces may take one octet more in a full datagram than alone.
constexpr std::size_t number_reserve = 4;

template <typename Numbered>
std::optional<Error> check_size(const Numbered& numbered) {
  TermTable terms;
  const auto message = to_wire(numbered, terms);
  const auto bytes = framed_bytes(1, message.ByteSizeLong()) + terms.bytes() + number_reserve;
  if (bytes <= max_entry_bytes) return std::nullopt;
  return Error{ErrorCode::too_large, "the service is too large: its announcement takes " + std::to_string(bytes) +
                                         " octets, at most " + std::to_string(max_entry_bytes) +
                                         " are possible: shorten its attributes"};
}

}  // namespace

std::optional<Error> check(const Publication& publication) {
  if (auto found = find_fault(publication)) return std::move(found->error);
  return check_size(NumberedPublication{std::numeric_limits<std::uint32_t>::max(), publication});
}

std::optional<Error> check(const Subscription& subscription) {
  if (auto found = find_fault(subscription)) return std::move(found->error);
  return check_size(NumberedSubscription{std::numeric_limits<std::uint32_t>::max(), subscription});
}

}  // namespace geminga::announcement
