#include "discovery/membership/witnesses/difference.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "base/hash.hpp"

namespace geminga::membership {
namespace {

/// One thing in which the other side may differ from us, and what it does to the fold.
struct Cause {
  enum class Kind : std::uint8_t { us_unknown, ours_older, newer, older, unknown } kind{};
  std::uint16_t fold = 0;
  ParticipantId id{};

  [[nodiscard]] bool is_ours() const { return kind == Kind::us_unknown || kind == Kind::ours_older; }
};

/// The folds of other revisions, up to so many steps away, and of none.
template <typename Add>
void add_older(const Folded& one, std::uint64_t steps, const Add& add) {
  if (one.revision == 0) return;
  add(one.fold_of(0));
  for (std::uint64_t step = 1; step <= steps && step < one.revision; ++step) add(one.fold_of(one.revision - step));
}

std::vector<Cause> causes(const Folded& self, std::span<const Folded> others, bool may_be_unknown,
                          std::uint64_t steps) {
  using enum Cause::Kind;
  std::vector<Cause> all;
  const auto add = [&all](Cause::Kind kind, const Folded& one, std::uint16_t fold) {
    all.push_back({.kind = kind, .fold = static_cast<std::uint16_t>(one.fold() ^ fold), .id = one.id});
  };
  add(us_unknown, self, 0);
  add_older(self, steps, [&](std::uint16_t fold) { add(ours_older, self, fold); });
  for (const Folded& one : others) {
    for (std::uint64_t step = 1; step <= steps; ++step) add(newer, one, one.fold_of(one.revision + step));
    add_older(one, steps, [&](std::uint16_t fold) { add(older, one, fold); });
    if (may_be_unknown) add(unknown, one, 0);
  }
  return all;
}

/// The difference that these causes together make.
Difference difference_by(std::span<const Cause> together) {
  using enum Cause::Kind;
  Difference difference{.unknown = Unknown::nobody, .is_of_revisions = true};
  for (const Cause& cause : together) {
    if (cause.kind == us_unknown) difference.unknown = Unknown::us;
    if (cause.kind == unknown && difference.unknown == Unknown::nobody) difference.unknown = Unknown::others;
    if (cause.kind == us_unknown || cause.kind == unknown) difference.is_of_revisions = false;
    if (cause.kind == ours_older) difference.lacks_our_state = true;
    if (cause.kind == newer) difference.newer = cause.id;
  }
  return difference;
}

}  // namespace

std::uint16_t Folded::fold_of(std::uint64_t another_revision) const {
  const std::array<std::uint64_t, 3> numbers{std::to_underlying(id), std::to_underlying(boot), another_revision};
  return static_cast<std::uint16_t>(base::hash64(base::octets_of(std::span(numbers))));
}

Difference explain_among_many(std::uint16_t difference, const Folded& self) {
  const auto one_of = causes(self, {}, false, few_revisions);
  const auto one = std::ranges::find(one_of, difference, &Cause::fold);
  return one == one_of.end() ? Difference{.unknown = Unknown::unclear} : difference_by(std::span(&*one, 1));
}

Difference explain(std::uint16_t difference, const Folded& self, std::span<const Folded> others) {
  if (others.size() >= max_told_revised) return explain_among_many(difference, self);
  // The other side is one more.
  const bool are_few = others.size() < max_told_apart;
  const auto one_of = causes(self, others, are_few, are_few ? many_revisions : few_revisions);
  const auto one = std::ranges::find(one_of, difference, &Cause::fold);
  if (one != one_of.end()) return difference_by(std::span(&*one, 1));
  if (!are_few) return {.unknown = Unknown::unclear};
  const auto two_of = causes(self, others, true, few_revisions);
  // Causes that are about us come first: we are the one who can mend them.
  for (auto first = two_of.begin(); first != two_of.end(); ++first) {
    const auto rest = static_cast<std::uint16_t>(difference ^ first->fold);
    const auto second = std::ranges::find_if(
        first + 1, two_of.end(), [&](const Cause& cause) { return cause.fold == rest && cause.id != first->id; });
    if (second != two_of.end()) return difference_by(std::array{*first, *second});
  }
  return {.unknown = Unknown::unclear};
}

}  // namespace geminga::membership
