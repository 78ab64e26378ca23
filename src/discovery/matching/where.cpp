// Evaluates `where` expressions against publications.
#include "discovery/matching/where.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <compare>
#include <string>
#include <utility>

#include "base/text.hpp"
#include "discovery/matching/where_parser.hpp"
#include "geminga/attribute.hpp"

namespace geminga::matching {
namespace {

using registry::PublicationEntry;
using Value = std::optional<std::string_view>;

constexpr std::size_t max_shown_bytes = 60;

Value stated(std::string_view text) { return text.empty() ? std::nullopt : Value(text); }

template <typename Kind>
const Kind* identity_as(const PublicationEntry& publication) {
  return std::get_if<Kind>(&publication.publication.identity);
}

/// Reads one field. A field that is no text is written into `room`, which the value then borrows.
using Reader = Value (*)(const PublicationEntry&, std::string& room);

/// The fields of a service, in the order of WHERE.md.
constexpr std::array<std::pair<std::string_view, Reader>, 13> fields{{
    {"mode", [](const PublicationEntry& p, std::string&) { return Value(to_string(p.publication.mode)); }},
    {"id",
     [](const PublicationEntry& p, std::string& room) {
       const auto* numeric = identity_as<NumericIdentity>(p);
       return numeric == nullptr ? Value() : Value(room = std::to_string(numeric->number));
     }},
    {"text",
     [](const PublicationEntry& p, std::string&) {
       const auto* text = identity_as<TextIdentity>(p);
       return text == nullptr ? Value() : Value(text->text);
     }},
    {"concept",
     [](const PublicationEntry& p, std::string&) {
       const auto* semantic = identity_as<SemanticIdentity>(p);
       return semantic == nullptr ? Value() : Value(semantic->concept_iri);
     }},
    {"representation",
     [](const PublicationEntry& p, std::string&) {
       const auto* semantic = identity_as<SemanticIdentity>(p);
       return semantic == nullptr ? Value() : stated(semantic->representation_iri);
     }},
    {"address", [](const PublicationEntry& p, std::string&) { return stated(p.publication.address); }},
    {"port",
     [](const PublicationEntry& p, std::string& room) { return Value(room = std::to_string(p.publication.port)); }},
    {"protocol", [](const PublicationEntry& p, std::string&) { return stated(p.publication.protocol); }},
    {"priority",
     [](const PublicationEntry& p, std::string& room) { return Value(room = std::to_string(p.publication.priority)); }},
    {"participant",
     [](const PublicationEntry& p, std::string& room) { return Value(room = to_string(p.key.participant)); }},
    {"participant_name", [](const PublicationEntry& p, std::string&) { return stated(p.participant_name); }},
    {"peer", [](const PublicationEntry& p,
                std::string& room) { return Value(room = std::to_string(std::to_underlying(p.key.peer))); }},
    {"name", [](const PublicationEntry& p, std::string&) { return stated(p.peer_name); }},
}};

Value attribute_of(const PublicationEntry& publication, std::string_view name) {
  const auto& attributes = publication.publication.attributes;
  const auto at = attributes.find(name);
  return at == attributes.end() ? Value() : Value(at->second);
}

/// What the publication says under a key: the attribute behind `attr.`, otherwise a field, otherwise an attribute.
Value value_of(const PublicationEntry& publication, std::string_view key, std::string& room) {
  if (key.starts_with(attribute_prefix)) return attribute_of(publication, key.substr(attribute_prefix.size()));
  for (const auto& [name, read] : fields) {
    if (name == key) return read(publication, room);
  }
  return attribute_of(publication, key);
}

std::string_view without_plus(std::string_view number) {
  if (number.starts_with('+')) number.remove_prefix(1);
  return number;
}

/// Whole numbers of 64 bits are compared exactly, all others as doubles. Requires two numbers.
std::partial_ordering compare_numbers(std::string_view a, std::string_view b) {
  const std::string_view left = without_plus(a);
  const std::string_view right = without_plus(b);
  const auto whole_left = base::parse_number<std::int64_t>(left);
  const auto whole_right = base::parse_number<std::int64_t>(right);
  if (whole_left && whole_right) return *whole_left <=> *whole_right;
  double one = 0;
  double other = 0;
  std::from_chars(left.data(), left.data() + left.size(), one);
  std::from_chars(right.data(), right.data() + right.size(), other);
  return one <=> other;
}

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

/// A number is compared with a number. What is no number differs from every number and is neither less nor greater.
bool compares(std::string_view value, Where::Operator operation, std::string_view wanted, bool is_number_wanted) {
  if (!is_number_wanted) return is_met(operation, value <=> wanted);
  if (!is_number(value)) return operation == Where::Operator::different;
  return is_met(operation, compare_numbers(value, wanted));
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
  const Value value = value_of(publication, text(node.key), room);
  if (node.kind == Node::Kind::has || !value) return value.has_value();
  return compares(*value, node.operation, text(node.value), node.is_number);
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
  const Value value = value_of(publication, text(leaf.key), room);
  const std::string key = base::printable(text(leaf.key), max_shown_bytes);
  if (!value) return key + " is absent";
  const bool is_word = !value->empty() && value->find_first_of(" ,'") == std::string_view::npos;
  const std::string shown = base::printable(*value, max_shown_bytes);
  return key + " is " + (is_word ? shown : "'" + shown + "'") +
         (leaf.is_number && !is_number(*value) ? ", which is no number" : "");
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
