// The neighbours that at-mosts can count, and the number of neighbours that an at-least needs beyond them.
//
// If an at-least asks for more neighbours than all at-mosts together can count, one of its neighbours is counted by
// none of them, and may stand for any number of copies of itself. The lemma and its proof are in
// hypertableau/README.md ("Numbers"). It does not hold with nominals.
#ifndef GEMINGA_REASONING_DL_CLAUSES_COUNTED_NEIGHBOURS_HPP
#define GEMINGA_REASONING_DL_CLAUSES_COUNTED_NEIGHBOURS_HPP

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"

namespace geminga::clauses {

/// The at-mosts that an engine uses.
enum class UsedAtMosts : std::uint8_t {
  all,
  inlined,  ///< those that are clauses with equalities, but not ClauseSet::at_mosts and data_at_mosts
};

class CountedNeighbours {
 public:
  CountedNeighbours(const ClauseSet& set, UsedAtMosts used);

  /// The number of neighbours that is as good as the number of the at-least: at most the number itself, at least one.
  /// Whatever the clauses entail about concepts, they entail with the one and with the other.
  [[nodiscard]] std::uint32_t enough(const AtLeast& at_least) const;
  /// The same for values, if every range that occurs has infinitely many values or none.
  [[nodiscard]] std::uint32_t enough(const DataAtLeast& at_least) const;

  /// Whether the at-leasts and facts may give something more neighbours than the at-most allows. False is certain.
  [[nodiscard]] bool may_exceed(const AtMost& at_most) const;
  [[nodiscard]] bool may_exceed(const DataAtMost& at_most) const;

 private:
  /// A role in one direction, or a data property.
  using Direction = std::uint32_t;
  /// The neighbours that an at-most counts: the direction in which they are, and the atoms that hold of them.
  using Family = std::pair<Direction, std::vector<Atom>>;

  [[nodiscard]] Direction direction_of(Role role) const {
    return number(role.property) * 2 + (role.is_inverse ? 1U : 0U);
  }
  [[nodiscard]] Direction direction_of(DataPropertyId property) const { return first_data_ + number(property); }
  [[nodiscard]] std::optional<Direction> direction_of(const Atom& atom) const;
  void note_hierarchy(const Clause& clause);
  void note_at_most(const Clause& clause);
  void note_family(Family family, std::uint32_t count);
  void sum_up();
  void count_asked(const ClauseSet& set);
  [[nodiscard]] std::vector<Direction> reached(Direction start) const;
  [[nodiscard]] std::uint64_t counted_in(Direction start) const;
  [[nodiscard]] std::uint32_t enough(std::uint32_t count, std::uint64_t counted) const;

  std::uint32_t first_data_ = 0;
  bool is_plain_ = true;  ///< there is no nominal, and every equality is of an at-most
  std::vector<std::vector<Direction>> above_;
  std::map<Family, std::uint32_t> families_;  ///< the greatest number of each
  std::vector<std::uint64_t> sums_;           ///< by direction: of its families
  std::uint64_t sum_of_roles_ = 0;
  std::vector<std::uint64_t> asked_;  ///< by direction: how many neighbours the at-leasts ask for
  bool has_links_ = false;            ///< facts give neighbours
};

}  // namespace geminga::clauses

#endif
