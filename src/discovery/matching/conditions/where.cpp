#include "discovery/matching/conditions/where.hpp"

#include <algorithm>
#include <compare>
#include <string>
#include <utility>

#include "base/edit_distance.hpp"
#include "base/text.hpp"
#include "discovery/matching/conditions/number.hpp"
#include "discovery/matching/conditions/pattern.hpp"
#include "discovery/matching/conditions/unit.hpp"
#include "discovery/matching/conditions/where_parser.hpp"

namespace geminga::matching {

using vocabulary::Units;

namespace {

constexpr std::size_t max_shown_bytes = 60;

bool is_met(Where::Operator operation, std::partial_ordering order) {
  switch (operation) {
    case Where::Operator::equal:
      return order == 0;
    case Where::Operator::different:
      return order != 0;
    case Where::Operator::less:
      return order < 0;
    case Where::Operator::at_most:
      return order <= 0;
    case Where::Operator::greater:
      return order > 0;
    case Where::Operator::at_least:
      return order >= 0;
  }
  return false;
}

/// Whether a value meets a comparison. A value that is no number, or has no unit or a unit of another kind, differs
/// from the wanted one and is neither less nor greater.
bool compares(std::string_view value, Where::Operator operation, std::string_view wanted, Where::Wanted kind,
              const Units& declared) {
  switch (kind) {
    case Where::Wanted::text:
      return is_met(operation, value <=> wanted);
    case Where::Wanted::number:
      return is_met(operation, number(value) ? compare_numbers(value, wanted) : std::partial_ordering::unordered);
    case Where::Wanted::quantity: {
      const auto stated = quantity(value, declared);
      const auto sought = quantity(wanted, declared);
      return is_met(operation, stated && sought ? compare(*stated, *sought) : std::partial_ordering::unordered);
    }
    case Where::Wanted::pattern:
      return is_like(value, wanted) == (operation == Where::Operator::equal);
  }
  return false;
}

/// The reason why a value cannot be compared with the wanted one at all; empty where it can.
std::string misfit(std::string_view value, std::string_view wanted, Where::Wanted kind, const Units& declared) {
  const bool is_number = kind == Where::Wanted::number;
  if (is_number && number(value)) return "";
  if (!is_number && kind != Where::Wanted::quantity) return "";
  const auto stated = quantity(value, declared);
  if (!stated) return is_number ? ", which is no number" : ", which is no number with a unit";
  if (is_number) return ", which has a unit: compare it with a number with a unit of its kind";
  const auto sought = quantity(wanted, declared);
  if (sought && stated->dimension == sought->dimension) return "";
  return ", which is in a unit of another kind than " + base::printable(wanted, max_shown_bytes);
}

/// Whether a stated text may be what was meant by a wanted one: it differs by a slip, or where digits make a
/// difference, by the case of letters.
bool is_likely_meant(std::string_view stated, std::string_view wanted) {
  const auto has_digit = [](std::string_view text) {
    return text.find_first_of("0123456789") != std::string_view::npos;
  };
  const std::size_t slips = has_digit(stated) || has_digit(wanted) ? 0 : base::tolerated_slips(wanted);
  return stated != wanted && base::edit_distance(stated, wanted, slips) <= slips;
}

}  // namespace

std::expected<Where, Error> Where::parse(std::string_view expression, const Units& declared) {
  return read(expression, &declared);
}

std::expected<Where, Error> Where::parse_with_any_unit(std::string_view expression) {
  return read(expression, nullptr);
}

std::optional<Error> Where::problem(std::string_view expression, const Units& declared) {
  const auto parsed = read(expression, &declared, true);
  return parsed ? std::nullopt : std::optional(parsed.error());
}

std::expected<Where, Error> Where::read(std::string_view expression, const Units* declared, bool suggests) {
  if (expression.size() > max_where_octets) {
    return std::unexpected(
        Error{ErrorCode::too_large, std::string(parse_error_prefix) + "longer than 4096 octets: ask for less at once"});
  }
  if (expression.empty()) return Where();
  auto parsed = WhereParser(expression, declared, suggests).parse();
  if (!parsed) return std::unexpected(std::move(parsed.error()));
  parsed->nodes.shrink_to_fit();
  parsed->texts.shrink_to_fit();
  return Where(std::move(*parsed));
}

std::vector<std::uint16_t> Where::operands(std::uint16_t number) const {
  const Node& node = parsed_.nodes[number];
  std::vector<std::uint16_t> places(node.operands);
  std::uint16_t end = number;
  for (auto place = places.rbegin(); place != places.rend(); ++place) {
    *place = static_cast<std::uint16_t>(end - 1);
    end = parsed_.nodes[*place].first;
  }
  return places;
}

bool Where::leaf_holds(const Node& node, const Stated& stated, const Units& declared) const {
  std::string room;
  const auto value = stated.under(text(node.key), room);
  if (node.kind == Node::Kind::has || !value) return value.has_value();
  return compares(*value, node.operation, text(node.value), node.wanted, declared);
}

bool Where::holds(std::uint16_t number, const Stated& stated, const Units& declared) const {
  const Node& node = parsed_.nodes[number];
  if (node.operands == 0) return leaf_holds(node, stated, declared);
  if (node.kind == Node::Kind::negation) return !holds(static_cast<std::uint16_t>(number - 1), stated, declared);
  // `all_of` is decided by the first operand that does not hold, `any_of` by the first that does. Their order does not
  // matter.
  const bool decides = node.kind == Node::Kind::any_of;
  std::uint16_t end = number;
  for (std::uint16_t left = node.operands; left > 0; --left) {
    const auto last = static_cast<std::uint16_t>(end - 1);
    if (holds(last, stated, declared) == decides) return decides;
    end = parsed_.nodes[last].first;
  }
  return !decides;
}

void Where::blame(std::uint16_t number, const Stated& stated, const Units& declared,
                  std::vector<const Node*>& leaves) const {
  const Node& node = parsed_.nodes[number];
  if (node.operands == 0) {
    const bool is_known =
        std::ranges::any_of(leaves, [&](const Node* leaf) { return text(leaf->key) == text(node.key); });
    if (!is_known) leaves.push_back(&node);
    return;
  }
  const bool value = holds(number, stated, declared);
  // One operand is enough to make `any_of` true and `all_of` false. Otherwise all operands together decide.
  const bool is_by_one = node.kind != Node::Kind::negation && value == (node.kind == Node::Kind::any_of);
  for (const std::uint16_t operand : operands(number)) {
    if (!is_by_one || holds(operand, stated, declared) == value) blame(operand, stated, declared, leaves);
  }
}

std::string Where::said(const Node& leaf, const Stated& stated, const Units& declared) const {
  std::string room;
  const auto value = stated.under(text(leaf.key), room);
  const std::string key = base::printable(text(leaf.key), max_shown_bytes);
  if (!value) {
    const std::string_view meant = stated.similar_key(text(leaf.key));
    return key + " is absent" +
           (meant.empty() ? "" : " (did you mean " + base::printable(meant, max_shown_bytes) + "?)");
  }
  const bool is_word = !value->empty() && value->find_first_of(" ,'") == std::string_view::npos;
  const std::string shown = base::printable(*value, max_shown_bytes);
  std::string words = key + " is " + (is_word ? shown : "'" + shown + "'");
  if (leaf.kind != Node::Kind::comparison) return words;
  const bool is_text = leaf.wanted == Wanted::text && leaf.operation == Operator::equal;
  if (is_text && is_likely_meant(*value, text(leaf.value))) return words + " (did you mean it?)";
  return words + misfit(*value, text(leaf.value), leaf.wanted, declared);
}

std::string_view Where::unknown_unit(const Units& declared) const {
  for (const Node& node : parsed_.nodes) {
    const bool has_unit = node.kind == Node::Kind::comparison && node.wanted == Wanted::quantity;
    if (has_unit && !quantity(text(node.value), declared)) return text(node.value);
  }
  return {};
}

std::string Where::misses(const Stated& stated, const Units& declared) const {
  if (accepts(stated, declared)) return "";
  if (const std::string_view unknown = unknown_unit(declared); !unknown.empty()) {
    return "the unit of " + base::printable(unknown, max_shown_bytes) + " is unknown here";
  }
  std::vector<const Node*> leaves;
  blame(static_cast<std::uint16_t>(parsed_.nodes.size() - 1), stated, declared, leaves);
  std::string words;
  for (std::size_t i = 0; i < leaves.size() && i < max_missed_keys; ++i) {
    words += (i == 0 ? "" : ", ") + said(*leaves[i], stated, declared);
  }
  return leaves.size() > max_missed_keys ? words + ", ..." : words;
}

std::optional<Error> check_where(std::string_view expression, std::string_view key, const Units& declared) {
  const auto problem = Where::problem(expression, declared);
  if (!problem) return std::nullopt;
  return Error{problem->code, std::string(key) + ": " + problem->text.substr(parse_error_prefix.size())};
}

std::string unit_problem(std::string_view expression, const Units& declared) {
  const auto problem = Where::problem(expression, declared);
  if (!problem || !Where::parse_with_any_unit(expression)) return "";
  return problem->text.substr(parse_error_prefix.size());
}

}  // namespace geminga::matching
