// Evaluates `where` expressions against publications.
#include "discovery/matching/where.hpp"

#include <algorithm>
#include <compare>
#include <string>
#include <utility>

#include "base/text.hpp"
#include "discovery/matching/number.hpp"
#include "discovery/matching/stated.hpp"
#include "discovery/matching/unit.hpp"
#include "discovery/matching/where_parser.hpp"

namespace geminga::matching {
namespace {

using registry::PublicationEntry;

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

/// Whether `text` is the pattern with something in the place of each `*`. Each piece between two of them is looked for
/// once, behind the one before it.
bool is_like(std::string_view text, std::string_view pattern) {
  const auto first = pattern.find('*');
  if (first == std::string_view::npos) return text == pattern;
  const auto last = pattern.rfind('*');
  const std::string_view front = pattern.substr(0, first);
  const std::string_view back = pattern.substr(last + 1);
  if (text.size() < front.size() + back.size() || !text.starts_with(front) || !text.ends_with(back)) return false;
  text = text.substr(front.size(), text.size() - front.size() - back.size());
  for (std::string_view rest = pattern.substr(first, last - first); !rest.empty();) {
    rest.remove_prefix(1);
    const std::string_view piece = rest.substr(0, rest.find('*'));
    const auto at = text.find(piece);
    if (at == std::string_view::npos) return false;
    text.remove_prefix(at + piece.size());
    rest.remove_prefix(piece.size());
  }
  return true;
}

/// What is no number, or has no unit or another kind of unit, differs from what is wanted and is neither less nor
/// greater.
bool compares(std::string_view value, Where::Operator operation, std::string_view wanted, Where::Wanted kind) {
  switch (kind) {
    case Where::Wanted::text:
      return is_met(operation, value <=> wanted);
    case Where::Wanted::number:
      return is_met(operation, number(value) ? compare_numbers(value, wanted) : std::partial_ordering::unordered);
    case Where::Wanted::quantity: {
      const auto stated = quantity(value);
      const auto sought = quantity(wanted);
      return is_met(operation, stated && sought ? compare(*stated, *sought) : std::partial_ordering::unordered);
    }
    case Where::Wanted::pattern:
      return is_like(value, wanted) == (operation == Where::Operator::equal);
  }
  return false;
}

/// Why a value cannot be compared with what is wanted at all; empty where it can.
std::string misfit(std::string_view value, std::string_view wanted, Where::Wanted kind) {
  if (kind == Where::Wanted::number && !number(value)) return ", which is no number";
  if (kind != Where::Wanted::quantity) return "";
  const auto stated = quantity(value);
  const auto sought = quantity(wanted);
  if (!stated) return ", which is no number with a unit";
  return sought && stated->dimension == sought->dimension ? "" : ", which is in a unit of another kind";
}

}  // namespace

std::expected<Where, Error> Where::parse(std::string_view expression) {
  if (expression.size() > max_where_octets) {
    return std::unexpected(Error{ErrorCode::too_large, "where: longer than 4096 octets: ask for less at once"});
  }
  if (expression.empty()) return Where({});
  auto parsed = WhereParser(expression).parse();
  if (!parsed) return std::unexpected(std::move(parsed.error()));
  parsed->nodes.shrink_to_fit();
  parsed->texts.shrink_to_fit();
  return Where(std::move(*parsed));
}

bool Where::accepts(const PublicationEntry& publication) const {
  return parsed_.nodes.empty() || holds(static_cast<std::uint16_t>(parsed_.nodes.size() - 1), publication);
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

bool Where::leaf_holds(const Node& node, const PublicationEntry& publication) const {
  std::string room;
  const auto value = stated_under(text(node.key), publication, room);
  if (node.kind == Node::Kind::has || !value) return value.has_value();
  return compares(*value, node.operation, text(node.value), node.wanted);
}

bool Where::holds(std::uint16_t number, const PublicationEntry& publication) const {
  const Node& node = parsed_.nodes[number];
  if (node.operands == 0) return leaf_holds(node, publication);
  if (node.kind == Node::Kind::negation) return !holds(static_cast<std::uint16_t>(number - 1), publication);
  // All of them hold until one does not; any of them holds as soon as one does. Their order does not matter.
  const bool decides = node.kind == Node::Kind::any_of;
  std::uint16_t end = number;
  for (std::uint16_t left = node.operands; left > 0; --left) {
    const auto last = static_cast<std::uint16_t>(end - 1);
    if (holds(last, publication) == decides) return decides;
    end = parsed_.nodes[last].first;
  }
  return !decides;
}

void Where::blame(std::uint16_t number, const PublicationEntry& publication, std::vector<const Node*>& leaves) const {
  const Node& node = parsed_.nodes[number];
  if (node.operands == 0) {
    const bool is_known =
        std::ranges::any_of(leaves, [&](const Node* leaf) { return text(leaf->key) == text(node.key); });
    if (!is_known) leaves.push_back(&node);
    return;
  }
  const bool value = holds(number, publication);
  // One operand is enough to make `any_of` true and `all_of` false; otherwise all of them together do it.
  const bool is_by_one = node.kind != Node::Kind::negation && value == (node.kind == Node::Kind::any_of);
  for (const std::uint16_t operand : operands(number)) {
    if (!is_by_one || holds(operand, publication) == value) blame(operand, publication, leaves);
  }
}

std::string Where::said(const Node& leaf, const PublicationEntry& publication) const {
  std::string room;
  const auto value = stated_under(text(leaf.key), publication, room);
  const std::string key = base::printable(text(leaf.key), max_shown_bytes);
  if (!value) return key + " is absent";
  const bool is_word = !value->empty() && value->find_first_of(" ,'") == std::string_view::npos;
  const std::string shown = base::printable(*value, max_shown_bytes);
  return key + " is " + (is_word ? shown : "'" + shown + "'") +
         (leaf.kind == Node::Kind::comparison ? misfit(*value, text(leaf.value), leaf.wanted) : "");
}

std::string Where::misses(const PublicationEntry& publication) const {
  if (accepts(publication)) return "";
  std::vector<const Node*> leaves;
  blame(static_cast<std::uint16_t>(parsed_.nodes.size() - 1), publication, leaves);
  std::string words;
  for (std::size_t i = 0; i < leaves.size() && i < max_missed_keys; ++i) {
    words += (i == 0 ? "" : ", ") + said(*leaves[i], publication);
  }
  return leaves.size() > max_missed_keys ? words + ", ..." : words;
}

std::optional<Error> check_where(std::string_view expression) {
  const auto parsed = Where::parse(expression);
  return parsed ? std::nullopt : std::optional(parsed.error());
}

}  // namespace geminga::matching
