#include "discovery/matching/conversions/converter.hpp"

#include "base/text.hpp"

namespace geminga::matching {
namespace {

constexpr char arrow = '>';
constexpr std::size_t max_shown_name = 200;

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

bool is_name(std::string_view word) {
  if (word.starts_with('<')) return word.size() > 2 && word.find(arrow) == word.size() - 1 && !word.contains(' ');
  return !word.empty() && !word.contains(arrow) && !word.contains(' ');
}

std::optional<vocabulary::ClassNumber> class_of(std::string_view name, const vocabulary::Vocabulary& vocabulary) {
  const auto number = vocabulary.find_term(name);
  return number && vocabulary.is_satisfiable(*number) ? number : std::nullopt;
}

}  // namespace

bool is_converter(const Attributes& attributes) {
  if (attributes.empty()) return false;
  const auto stated = attributes.find(converts_attribute);
  return stated != attributes.end() && stated->second.contains(arrow);
}

std::expected<StatedConversion, std::string> stated_conversion(const Attributes& attributes) {
  StatedConversion stated;
  const std::string_view text = trimmed(attributes.find(converts_attribute)->second);
  const std::size_t bracket = text.starts_with('<') ? text.find(arrow) : std::string_view::npos;
  const std::size_t end = text.find(arrow, bracket == std::string_view::npos ? 0 : bracket + 1);
  stated.from = trimmed(text.substr(0, end));
  if (end != std::string_view::npos) stated.to = trimmed(text.substr(end + 1));
  if (!is_name(stated.from) || !is_name(stated.to)) {
    return std::unexpected("converts: " + base::printable(text, max_shown_name) + " is not FROM>TO, two names");
  }
  const auto cost = attributes.find(conversion_cost_attribute);
  if (cost == attributes.end()) return stated;
  const auto number = base::parse_number<std::uint32_t>(cost->second);
  if (!number || *number == 0 || *number > owl::max_conversion_cost) {
    return std::unexpected("cost: " + base::printable(cost->second, max_shown_name) + " is no whole number from 1 to " +
                           std::to_string(owl::max_conversion_cost) + ", which is what a conversion costs");
  }
  stated.cost = *number;
  return stated;
}

std::string place_of(const registry::PublicationEntry& entry) {
  const Publication& publication = entry.publication;
  const bool is_ipv6 = publication.address.contains(':');
  return publication.protocol + "://" + (is_ipv6 ? "[" : "") + publication.address + (is_ipv6 ? "]" : "") + ":" +
         std::to_string(publication.port) + "/" + to_string(entry.key);
}

std::optional<vocabulary::Step> step_of(const Attributes& attributes, const vocabulary::Vocabulary& vocabulary) {
  if (!vocabulary.is_loaded() || !is_converter(attributes)) return std::nullopt;
  const auto stated = stated_conversion(attributes);
  if (!stated) return std::nullopt;
  const auto from = class_of(stated->from, vocabulary);
  const auto to = class_of(stated->to, vocabulary);
  if (!from || !to) return std::nullopt;
  return vocabulary::Step{.from = *from, .to = *to, .cost = stated->cost, .is_service = true};
}

std::optional<Error> check_conversion(const Attributes& attributes, const vocabulary::Vocabulary& vocabulary) {
  if (!is_converter(attributes)) return std::nullopt;
  const auto stated = stated_conversion(attributes);
  if (!stated) return Error{ErrorCode::impossible, stated.error()};
  if (!vocabulary.is_loaded()) return std::nullopt;
  for (const std::string* name : {&stated->from, &stated->to}) {
    const auto number = vocabulary.find_term(*name);
    if (number && vocabulary.is_satisfiable(*number)) continue;
    const auto meant = vocabulary.find(*name);
    const std::string why = number   ? *name + " is unsatisfiable: it can have no instance"
                            : !meant ? meant.error()
                                     : *name + " is a label: write " + vocabulary.short_name(*meant);
    return Error{ErrorCode::impossible, "converts: " + why};
  }
  return std::nullopt;
}

}  // namespace geminga::matching
