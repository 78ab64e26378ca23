#include "client/protocol/converter.hpp"

#include <algorithm>
#include <exception>
#include <utility>

namespace geminga::client {
namespace {

/// Calls a function of the program; its exceptions end here.
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

/// The names of `A>B>C`. An IRI stands in angle brackets, as `<http://...>`.
std::vector<std::string_view> names_of(std::string_view chain) {
  std::vector<std::string_view> names;
  while (!chain.empty()) {
    const std::size_t bracket = chain.starts_with('<') ? chain.find('>') : std::string_view::npos;
    const std::size_t end = chain.find('>', bracket == std::string_view::npos ? 0 : bracket + 1);
    names.push_back(chain.substr(0, end));
    if (end == std::string_view::npos) break;
    chain.remove_prefix(end + 1);
  }
  return names;
}

/// The service that does a step, counted from 0, by the words of `via`; empty: the consumer does it.
std::string_view service_of(std::string_view via, std::size_t step) {
  for (; step > 0 && !via.empty(); --step) via.remove_prefix(std::min(via.find(','), via.size() - 1) + 1);
  const std::string_view word = via.substr(0, via.find(','));
  return word == "-" ? std::string_view() : word;
}

std::string step_of(std::string_view from, std::string_view to) { return std::string(from) + '>' + std::string(to); }

}  // namespace

std::expected<std::vector<std::byte>, std::string> convert(const Conversions& conversions, std::string_view chain,
                                                           std::span<const std::byte> payload, std::string_view via) {
  std::vector<std::byte> converted(payload.begin(), payload.end());
  const auto names = names_of(chain);
  if (names.size() < 2) return converted;
  const auto at_once = conversions.find(step_of(names.front(), names.back()));
  if (at_once != conversions.end()) return call(*at_once, payload);
  for (std::size_t next = 1; next < names.size(); ++next) {
    const std::string step = step_of(names[next - 1], names[next]);
    const auto found = conversions.find(step);
    if (found == conversions.end()) {
      const std::string_view service = service_of(via, next - 1);
      return std::unexpected("there is no function for the conversion " + step +
                             (service.empty() ? "" : ", which the service " + std::string(service) + " does"));
    }
    auto result = call(*found, converted);
    if (!result) return result;
    converted = std::move(*result);
  }
  return converted;
}

}  // namespace geminga::client
