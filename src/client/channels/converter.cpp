#include "client/channels/converter.hpp"

#include <exception>

namespace geminga::client {
namespace {

/// What may go wrong in a function of the program stays there.
std::expected<std::vector<std::byte>, std::string> call(const Conversions::value_type& conversion,
                                                        std::span<const std::byte> payload) {
  try {
    return conversion.second(payload);
  } catch (const std::exception& error) {
    return std::unexpected("the conversion " + conversion.first + " failed: " + error.what());
  } catch (...) {
    return std::unexpected("the conversion " + conversion.first + " failed");
  }
}

}  // namespace

std::expected<std::vector<std::byte>, std::string> convert(const Conversions& conversions, std::string_view chain,
                                                           std::span<const std::byte> payload) {
  if (chain.empty()) return std::vector<std::byte>(payload.begin(), payload.end());
  const auto first_end = chain.find('>');
  const auto last_begin = chain.rfind('>');
  if (first_end != std::string_view::npos) {
    const std::string whole = std::string(chain.substr(0, first_end)) + std::string(chain.substr(last_begin));
    if (const auto at_once = conversions.find(whole); at_once != conversions.end()) return call(*at_once, payload);
  }
  std::vector<std::byte> converted(payload.begin(), payload.end());
  for (std::size_t begin = 0;;) {
    const auto middle = chain.find('>', begin);
    if (middle == std::string_view::npos) return converted;
    const auto step = chain.substr(begin, chain.find('>', middle + 1) - begin);
    const auto found = conversions.find(step);
    if (found == conversions.end()) {
      return std::unexpected("there is no function for the conversion " + std::string(step));
    }
    auto next = call(*found, converted);
    if (!next) return next;
    converted = std::move(*next);
    begin = middle + 1;
  }
}

}  // namespace geminga::client
