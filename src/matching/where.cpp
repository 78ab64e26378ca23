// Evaluates `where` expressions against publications.
#include "matching/where.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <compare>
#include <string>
#include <utility>

#include "base/text.hpp"
#include "matching/where_parser.hpp"

namespace geminga::matching {
namespace {

using registry::PublicationEntry;

/// The identity as GCNP writes it under this key, or nothing where it is of another kind.
std::optional<std::string> identity_field(const Identity& identity, std::string_view key) {
  const auto* numeric = std::get_if<NumericIdentity>(&identity);
  const auto* text = std::get_if<TextIdentity>(&identity);
  const auto* semantic = std::get_if<SemanticIdentity>(&identity);
  if (key == "id" && numeric != nullptr) return std::to_string(numeric->number);
  if (key == "text" && text != nullptr) return text->text;
  if (key == "concept" && semantic != nullptr) return semantic->concept_iri;
  if (key == "representation" && semantic != nullptr && !semantic->representation_iri.empty()) {
    return semantic->representation_iri;
  }
  return std::nullopt;
}

using Reader = std::optional<std::string> (*)(const PublicationEntry&, std::string_view);

std::optional<std::string> stated(const std::string& text) { return text.empty() ? std::nullopt : std::optional(text); }

/// The fields of a service, in the order of WHERE.md.
constexpr std::array<std::pair<std::string_view, Reader>, 13> fields{{
    {"mode",
     [](const PublicationEntry& p, std::string_view) { return stated(std::string(to_string(p.publication.mode))); }},
    {"id", [](const PublicationEntry& p, std::string_view key) { return identity_field(p.publication.identity, key); }},
    {"text",
     [](const PublicationEntry& p, std::string_view key) { return identity_field(p.publication.identity, key); }},
    {"concept",
     [](const PublicationEntry& p, std::string_view key) { return identity_field(p.publication.identity, key); }},
    {"representation",
     [](const PublicationEntry& p, std::string_view key) { return identity_field(p.publication.identity, key); }},
    {"address", [](const PublicationEntry& p, std::string_view) { return stated(p.publication.address); }},
    {"port", [](const PublicationEntry& p, std::string_view) { return stated(std::to_string(p.publication.port)); }},
    {"protocol", [](const PublicationEntry& p, std::string_view) { return stated(p.publication.protocol); }},
    {"priority",
     [](const PublicationEntry& p, std::string_view) { return stated(std::to_string(p.publication.priority)); }},
    {"participant", [](const PublicationEntry& p, std::string_view) { return stated(to_string(p.key.participant)); }},
    {"participant_name", [](const PublicationEntry& p, std::string_view) { return stated(p.participant_name); }},
    {"peer", [](const PublicationEntry& p,
                std::string_view) { return stated(std::to_string(std::to_underlying(p.key.peer))); }},
    {"name", [](const PublicationEntry& p, std::string_view) { return stated(p.peer_name); }},
}};

/// What the publication says under a key: a field, otherwise an attribute, otherwise nothing.
std::optional<std::string> value_of(const PublicationEntry& publication, std::string_view key) {
  for (const auto& [name, read] : fields) {
    if (name == key) return read(publication, key);
  }
  const auto& attributes = publication.publication.attributes;
  const auto at = attributes.find(key);
  return at == attributes.end() ? std::nullopt : std::optional(at->second);
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
bool compares(const std::string& value, Where::Operator operation, const Where::Literal& literal) {
  if (!literal.is_number) return is_met(operation, value <=> literal.text);
  if (!is_number(value)) return operation == Where::Operator::different;
  return is_met(operation, compare_numbers(value, literal.text));
}

}  // namespace

std::expected<Where, Error> Where::parse(std::string_view expression) {
  if (expression.size() > max_where_octets) {
    return std::unexpected(Error{ErrorCode::too_large, "where: longer than 4096 octets: ask for less at once"});
  }
  if (expression.empty()) return Where({});
  auto nodes = WhereParser(expression).parse();
  if (!nodes) return std::unexpected(std::move(nodes.error()));
  return Where(std::move(*nodes));
}

bool Where::accepts(const PublicationEntry& publication) const {
  return nodes_.empty() || holds(static_cast<std::uint32_t>(nodes_.size() - 1), publication);
}

bool Where::holds(std::uint32_t number, const PublicationEntry& publication) const {
  const Node& node = nodes_[number];
  const auto child_holds = [&](std::uint32_t child) { return holds(child, publication); };
  switch (node.kind) {
    case Node::Kind::all_of:
      return std::ranges::all_of(node.children, child_holds);
    case Node::Kind::any_of:
      return std::ranges::any_of(node.children, child_holds);
    case Node::Kind::negation:
      return !holds(node.children.front(), publication);
    case Node::Kind::has:
      return value_of(publication, node.key).has_value();
    case Node::Kind::comparison: {
      const auto value = value_of(publication, node.key);
      return value && compares(*value, node.operation, node.literal);
    }
  }
  return false;
}

std::optional<Error> check_where(std::string_view expression) {
  const auto parsed = Where::parse(expression);
  return parsed ? std::nullopt : std::optional(parsed.error());
}

}  // namespace geminga::matching
