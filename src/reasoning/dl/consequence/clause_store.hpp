// The clauses of one context, indexed by their literals, without redundant clauses.
//
// Most clauses of real ontologies have an empty body and one literal in the head. Such a unit is only a bit in the
// table of literals. Other clauses are filed under their maximal literals, which the rules and the test for redundancy
// look up, and under all others, which the search for clauses that a new clause makes redundant looks up.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_CLAUSE_STORE_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_CLAUSE_STORE_HPP

#include <cstdint>
#include <span>
#include <utility>

#include "reasoning/dl/consequence/pool.hpp"
#include "reasoning/dl/consequence/rules/literal.hpp"

namespace geminga::consequence {

using ClauseNumber = std::uint32_t;

class ClauseStore {
 public:
  /// Entries under a literal, or under a key that stands for one (in_body(), neighbours()).
  struct Lists {
    Pooled<std::uint32_t> maximal;  ///< clauses with it as a maximal literal; of neighbours(): terms
    Pooled<std::uint32_t> others;   ///< clauses with it elsewhere in the head; of in_body(): in the body
    Pooled<std::uint32_t> waiting;  ///< others' clauses that wait for it; of in_body(): edges that assume it
  };

  [[nodiscard]] std::span<const Literal> body(ClauseNumber clause) const {
    return std::span(literals_).subspan(clauses_[clause].begin, clauses_[clause].body);
  }
  /// The head's literals, descending.
  [[nodiscard]] std::span<const Literal> head(ClauseNumber clause) const {
    return std::span(literals_).subspan(clauses_[clause].begin + clauses_[clause].body, clauses_[clause].head);
  }
  [[nodiscard]] bool is_live(ClauseNumber clause) const { return clauses_[clause].state != State::redundant; }
  /// Whether the clause is in the store and has been processed.
  [[nodiscard]] bool is_active(ClauseNumber clause) const { return clauses_[clause].state == State::active; }
  void activate(ClauseNumber clause) { clauses_[clause].state = State::active; }

  /// The bits of a literal. insert_unit() sets `unit`, the callers set the others.
  enum Flag : std::uint32_t { unit = 1, active_unit = 2, listed = 4, assumed = 8 };
  [[nodiscard]] bool has(Literal literal, Flag flag) const {
    const Slot* const slot = find(literal);
    return slot != nullptr && (slot->flags & flag) != 0;
  }
  /// False if it was set already.
  bool set(Literal literal, Flag flag) {
    Slot& slot = slot_of(literal);
    if ((slot.flags & flag) != 0) return false;
    slot.flags |= flag;
    return true;
  }

  /// Calls `use` with each literal that is a unit, in any order.
  template <typename Use>
  void for_each_unit(Use&& use) const {
    for (const Slot& slot : slots_) {
      if (slot.key != no_literal && (slot.flags & unit) != 0) use(slot.key);
    }
  }

  /// nullptr if nothing is filed. Valid until something is filed under a new literal.
  [[nodiscard]] const Lists* lists(Literal literal) const {
    const Slot* const slot = find(literal);
    return slot == nullptr || slot->lists == 0 ? nullptr : &lists_[slot->lists - 1];
  }
  [[nodiscard]] Lists& lists_of(Literal literal);
  /// Where a literal is maximal: in a processed unit, or else in some clauses.
  struct Found {
    bool is_unit = false;
    const Lists* lists = nullptr;
  };
  [[nodiscard]] Found look_up(Literal literal) const {
    const Slot* const slot = find(literal);
    if (slot == nullptr) return {};
    if ((slot->flags & active_unit) != 0) return {true, nullptr};
    return {false, slot->lists == 0 ? nullptr : &lists_[slot->lists - 1]};
  }
  /// Whether look_up() finds anything.
  [[nodiscard]] bool may_match(Literal literal) const {
    const Slot* const slot = find(literal);
    if (slot == nullptr) return false;
    return (slot->flags & active_unit) != 0 || (slot->lists != 0 && !lists_[slot->lists - 1].maximal.empty());
  }
  /// A number that the caller keeps under a key under which nothing else is filed. 0 at first.
  [[nodiscard]] std::uint32_t& number_of(Literal key) { return slot_of(key).lists; }
  [[nodiscard]] std::uint32_t find_number(Literal key) const {
    const Slot* const slot = find(key);
    return slot == nullptr ? 0 : slot->lists;
  }

  /// Adds true -> literal and drops the clauses that it makes redundant. False if it was there already.
  bool insert_unit(Literal literal);
  /// Whether the store makes this clause, which is not a unit, redundant. The head is descending, the body ascending.
  [[nodiscard]] bool is_redundant(std::span<const Literal> body, std::span<const Literal> head) const;
  /// Adds a clause that is not redundant and drops the clauses that it makes redundant. The first `maximal` literals of
  /// the head are the maximal ones.
  ClauseNumber insert(std::span<const Literal> body, std::span<const Literal> head, std::size_t maximal);
  /// Whether some clause has more than one literal in its head.
  [[nodiscard]] bool has_alternatives() const;
  /// Counts a conclusion with alternatives (more than one literal in the head). With more than `most` of them the store
  /// is cut: it drops every clause with alternatives and takes no more. False: it is cut.
  [[nodiscard]] bool count_alternative(std::uint32_t most);
  /// Counts a step of matching a rule with alternatives in its head. With more than `most` of them the store is cut,
  /// and such rules are matched no more. False: it was one too many.
  [[nodiscard]] bool count_match(std::size_t most);
  [[nodiscard]] bool is_cut() const { return is_cut_; }
  void clear();
  /// The number of clauses that were compared since the last call.
  [[nodiscard]] std::size_t take_compared() { return std::exchange(compared_, 0); }

 private:
  enum class State : std::uint8_t { waiting, active, redundant };
  struct Slot {
    Literal key = no_literal;
    std::uint32_t flags = 0;
    std::uint32_t lists = 0;
  };
  struct Record {
    std::uint32_t begin = 0;
    std::uint16_t body = 0;
    std::uint16_t head = 0;
    State state = State::waiting;
    std::uint64_t body_signature = 0;
    std::uint64_t head_signature = 0;
  };

  [[nodiscard]] const Slot* find(Literal key) const {
    if (slots_.empty()) return nullptr;
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t at = static_cast<std::size_t>(hash_of(key)) & mask;; at = (at + 1) & mask) {
      if (slots_[at].key == key) return &slots_[at];
      if (slots_[at].key == no_literal) return nullptr;
    }
  }
  void grow();
  [[nodiscard]] Slot& slot_of(Literal key);
  [[nodiscard]] bool is_part(const Record& record, std::uint64_t body_signature, std::uint64_t head_signature,
                             std::span<const Literal> body, std::span<const Literal> head) const;
  void drop_implied(ClauseNumber clause);
  void drop_implied(const Record& by, const Pooled<std::uint32_t>& candidates);
  void cut();

  Pooled<Slot> slots_;
  std::size_t used_slots_ = 0;
  Pooled<Lists> lists_;
  Pooled<Literal> literals_;
  Pooled<Record> clauses_;
  Pooled<ClauseNumber> headless_;
  std::uint32_t alternatives_ = 0;  ///< conclusions with alternatives
  std::size_t matches_ = 0;         ///< steps of matching rules with alternatives
  bool is_cut_ = false;
  mutable std::size_t compared_ = 0;
};

}  // namespace geminga::consequence

#endif
