#include "discovery/matching/conditions/scope.hpp"

#include <algorithm>
#include <utility>

#include "base/text.hpp"
#include "discovery/matching/conditions/items.hpp"
#include "discovery/matching/conditions/pattern.hpp"

namespace geminga::matching {

std::optional<Scope::Entry> Scope::entry(std::string_view text) {
  Entry entry;
  entry.excludes = text.starts_with('!');
  if (entry.excludes) text = base::trimmed(text.substr(1));
  if (entry.excludes && text.starts_with('!')) return std::nullopt;
  const auto slash = std::min(text.find('/'), text.size());
  const std::string_view host = text.substr(0, slash);
  if (host.empty() || (slash != text.size() && text.find('/', slash + 1) != std::string_view::npos))
    return std::nullopt;
  if (slash + 1 == text.size()) return std::nullopt;
  if (slash != text.size()) entry.peer = text.substr(slash + 1);
  if (host == "host" || host == "localhost") {
    entry.host = Entry::Host::own;
  } else if (host != "any" && host != "group") {
    entry.host = Entry::Host::named;
    entry.participant = host;
  }
  return entry;
}

std::expected<Scope, Error> Scope::parse(std::string_view text) {
  const auto unreadable = [&](std::string_view item) {
    return std::unexpected(Error{
        ErrorCode::impossible, "scope: " + base::printable(item.empty() ? text : item, max_shown_item) +
                                   " cannot be read: host, group, any or HOST, perhaps with /PEER behind and ! before, "
                                   "at most " +
                                   std::to_string(max_scope_entries) + " with commas"});
  };
  Scope scope;
  if (text.ends_with(',')) return unreadable(text);
  for (std::string_view rest = text; !rest.empty();) {
    const std::string_view item = take_item(rest);
    auto read = entry(item);
    if (!read || scope.entries_.size() == max_scope_entries) return unreadable(item);
    scope.entries_.push_back(std::move(*read));
  }
  return scope;
}

bool Scope::suits(const Entry& entry, const Party& own, const Party& other) {
  if (entry.host == Entry::Host::own && own.key.participant != other.key.participant) return false;
  if (entry.host == Entry::Host::named && participant_id(entry.participant) != other.key.participant &&
      !is_like(other.participant_name, entry.participant)) {
    return false;
  }
  return entry.peer.empty() || base::parse_number<std::uint32_t>(entry.peer) == std::to_underlying(other.key.peer) ||
         is_like(other.peer_name, entry.peer);
}

bool Scope::admits(const Party& own, const Party& other) const {
  bool is_open = true;  // no entry admits anybody
  bool is_admitted = false;
  for (const Entry& entry : entries_) {
    const bool suits_it = suits(entry, own, other);
    if (entry.excludes && suits_it) return false;
    is_open = is_open && entry.excludes;
    is_admitted = is_admitted || (!entry.excludes && suits_it);
  }
  return is_open || is_admitted;
}

std::optional<Error> check_scope(std::string_view text) {
  auto scope = Scope::parse(text);
  return scope ? std::nullopt : std::optional(std::move(scope.error()));
}

}  // namespace geminga::matching
