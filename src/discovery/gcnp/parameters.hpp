// Appends typed values to the parameters of a statement: the inverse of KeyReader.
#ifndef GEMINGA_DISCOVERY_GCNP_PARAMETERS_HPP
#define GEMINGA_DISCOVERY_GCNP_PARAMETERS_HPP

#include <concepts>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "discovery/gcnp/statement.hpp"
#include "geminga/service.hpp"

namespace geminga::gcnp {

inline void append(std::vector<Parameter>& parameters, std::string_view key, std::string value) {
  parameters.push_back({std::string(key), std::move(value)});
}
template <std::integral Number>
void append(std::vector<Parameter>& parameters, std::string_view key, Number value) {
  append(parameters, key, std::to_string(value));
}

/// Appends the parameter unless its value is empty.
inline void append_stated(std::vector<Parameter>& parameters, std::string_view key, std::string_view value) {
  if (!value.empty()) append(parameters, key, std::string(value));
}

/// `A/1,B`, as in `provider=`.
[[nodiscard]] std::string provider_list(const std::vector<ProviderFilter>& providers);

/// The value of `convert=` for the largest accepted cost: "no", "yes" for any_cost, or the number.
[[nodiscard]] std::string conversion_word(std::uint32_t cost);
/// `udp,tcp`, as in a subscription's `protocol=`.
[[nodiscard]] std::string protocol_list(const std::vector<std::string>& protocols);

}  // namespace geminga::gcnp

#endif
