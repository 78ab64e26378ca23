#include "discovery/matching/conditions/stated.hpp"

#include <array>
#include <utility>

#include "base/edit_distance.hpp"
#include "geminga/attribute.hpp"

namespace geminga::matching {
namespace {

using registry::PublicationEntry;
using registry::SubscriptionEntry;
using Value = std::optional<std::string_view>;

const Publication& service_of(const PublicationEntry& entry) { return entry.publication; }
const Subscription& service_of(const SubscriptionEntry& entry) { return entry.subscription; }

Value unless_empty(std::string_view text) { return text.empty() ? std::nullopt : Value(text); }

template <typename Kind, typename Entry>
const Kind* identity_as(const Entry& entry) {
  return std::get_if<Kind>(&service_of(entry).identity);
}

/// A function that reads one field.
template <typename Entry>
using Reader = Value (*)(const Entry&, std::string& room);

/// The fields that both have, in the order of WHERE.md.
template <typename Entry>
constexpr std::array<std::pair<std::string_view, Reader<Entry>>, 12> fields{{
    {"mode", [](const Entry& e, std::string&) { return Value(to_string(service_of(e).mode)); }},
    {"id",
     [](const Entry& e, std::string& room) {
       const auto* numeric = identity_as<NumericIdentity>(e);
       return numeric == nullptr ? Value() : Value(room = std::to_string(numeric->number));
     }},
    {"text",
     [](const Entry& e, std::string&) {
       const auto* text = identity_as<TextIdentity>(e);
       return text == nullptr ? Value() : Value(text->text);
     }},
    {"concept",
     [](const Entry& e, std::string&) {
       const auto* semantic = identity_as<SemanticIdentity>(e);
       return semantic == nullptr ? Value() : Value(semantic->concept_iri);
     }},
    {"representation",
     [](const Entry& e, std::string&) {
       const auto* semantic = identity_as<SemanticIdentity>(e);
       return semantic == nullptr ? Value() : unless_empty(semantic->representation_iri);
     }},
    {"address", [](const Entry& e, std::string&) { return unless_empty(service_of(e).address); }},
    {"port",
     [](const Entry& e, std::string& room) {
       return service_of(e).port == 0 ? Value() : Value(room = std::to_string(service_of(e).port));
     }},
    {"priority",
     [](const Entry& e, std::string& room) { return Value(room = std::to_string(service_of(e).priority)); }},
    {"participant", [](const Entry& e, std::string& room) { return Value(room = to_string(e.key.participant)); }},
    {"participant_name", [](const Entry& e, std::string&) { return unless_empty(e.participant_name); }},
    {"peer",
     [](const Entry& e, std::string& room) { return Value(room = std::to_string(std::to_underlying(e.key.peer))); }},
    {"name", [](const Entry& e, std::string&) { return unless_empty(e.peer_name); }},
}};

Value attribute_of(const Attributes& attributes, std::string_view name) {
  const auto at = attributes.find(name);
  return at == attributes.end() ? Value() : Value(at->second);
}

template <typename Entry>
Value under(const Entry& entry, std::string_view key, std::string& room) {
  const Attributes& attributes = service_of(entry).attributes;
  if (key.starts_with(attribute_prefix)) return attribute_of(attributes, key.substr(attribute_prefix.size()));
  for (const auto& [name, read] : fields<Entry>) {
    if (name == key) return read(entry, room);
  }
  // A subscription has a list of protocols and no field `protocol`.
  if constexpr (std::is_same_v<Entry, PublicationEntry>) {
    if (key == "protocol") return unless_empty(entry.publication.protocol);
  }
  return attribute_of(attributes, key);
}

template <typename Entry>
std::string_view similar_key(const Entry& entry, std::string_view key) {
  const bool is_attribute = key.starts_with(attribute_prefix);
  if (is_attribute) key.remove_prefix(attribute_prefix.size());
  std::size_t nearest = base::tolerated_slips(key) + 1;
  std::string_view found;
  const auto compare = [&](std::string_view name) {
    const std::size_t distance = base::edit_distance(name, key, nearest);
    if (distance > nearest || name == key) return;
    if (distance == nearest && (found.empty() || found <= name)) return;
    nearest = distance;
    found = name;
  };
  for (const auto& [name, value] : service_of(entry).attributes) compare(name);
  if (is_attribute) return found;
  std::string room;
  for (const auto& [name, read] : fields<Entry>) {
    if (read(entry, room)) compare(name);
  }
  return found;
}

}  // namespace

std::string_view Stated::similar_key(std::string_view key) const {
  return std::visit([&](const auto* entry) { return matching::similar_key(*entry, key); }, entry_);
}

Value Stated::under(std::string_view key, std::string& room) const {
  return std::visit([&](const auto* entry) { return matching::under(*entry, key, room); }, entry_);
}

}  // namespace geminga::matching
