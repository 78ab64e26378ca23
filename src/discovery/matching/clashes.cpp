#include "discovery/matching/clashes.hpp"

#include <algorithm>

#include "discovery/matching/candidates.hpp"
#include "discovery/registry/fields.hpp"

namespace geminga::matching {

using registry::StoredSubscription;

namespace {

/// Subscriptions that are given in ascending order of key. More are given in the order of the index.
constexpr std::size_t max_ordered = 1024;

template <typename Table>
void add_identities(const Table& table, Id32 number, std::vector<const Identity*>& concepts, bool& has_number) {
  for (const auto entries : table.with_number(number)) {
    const Identity& identity = registry::identity_of(entries.front().stored->entry);
    if (std::holds_alternative<NumericIdentity>(identity)) has_number = true;
    if (std::holds_alternative<SemanticIdentity>(identity) && !has_expression(identity)) concepts.push_back(&identity);
  }
}

}  // namespace

bool Clashes::is_kept_apart(const Identity& offered, const Identity& requested) const {
  if (numbers_.empty() || offered.index() == requested.index()) return false;
  const auto* number = std::get_if<NumericIdentity>(&offered);
  if (number == nullptr) number = std::get_if<NumericIdentity>(&requested);
  if (number == nullptr || !numbers_.contains(number->number)) return false;
  return is_number_of(offered, requested) || is_number_of(requested, offered);
}

std::vector<const StoredSubscription*> Clashes::review(Id32 number, Change change) {
  std::vector<const Identity*> concepts;
  bool has_number = false;
  add_identities(publications_, number, concepts, has_number);
  add_identities(subscriptions_, number, concepts, has_number);
  const auto by_value = [](const Identity* one) -> const Identity& { return *one; };
  std::ranges::sort(concepts, {}, by_value);
  const auto twice = std::ranges::unique(concepts, {}, by_value);
  concepts.erase(twice.begin(), twice.end());
  const bool is_clash = concepts.size() > 1;
  const bool was_clash = numbers_.contains(number);
  if (!is_clash && !was_clash) return {};
  if (is_clash && has_number && (!was_clash || change == Change::came)) tell(number, concepts);
  if (is_clash == was_clash) return {};
  if (is_clash) {
    numbers_.insert(number);
  } else {
    numbers_.erase(number);
  }
  std::vector<const StoredSubscription*> concerned;
  for (const auto entries : subscriptions_.with_number(number)) {
    for (const auto& one : entries) concerned.push_back(one.stored);
  }
  if (concerned.size() <= max_ordered) order_by_key(concerned);
  return concerned;
}

std::vector<const StoredSubscription*> Clashes::review_change(Id32 before, Id32 now, Change change) {
  auto concerned = review(now, change);
  if (before == now) return concerned;
  const auto further = review(before, Change::went);
  concerned.insert(concerned.end(), further.begin(), further.end());
  return concerned;
}

void Clashes::tell(Id32 number, std::span<const Identity* const> concepts) {
  std::string names;
  for (const Identity* one : concepts) names += (names.empty() ? "" : " and ") + canonical_form(*one);
  const std::string text =
      "the number " + std::to_string(number) + " is that of two different services, " + names +
      ": it connects none of those with whoever states the number, who is to ask for and offer the concept";
  const auto tell_all = [&](const auto& table) {
    for (const auto entries : table.with_number(number)) {
      for (const auto& one : entries) {
        if (one.stored->entry.is_local) messages_.push_back({one.stored->entry.key, text});
      }
    }
  };
  tell_all(publications_);
  tell_all(subscriptions_);
}

}  // namespace geminga::matching
