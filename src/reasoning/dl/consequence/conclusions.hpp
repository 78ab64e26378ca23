// The conclusions of one inference step: built from premises, and kept until the rule has looked through the store.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_CONCLUSIONS_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_CONCLUSIONS_HPP

#include <cstddef>
#include <span>
#include <vector>

#include "reasoning/dl/consequence/clause_store.hpp"
#include "reasoning/dl/consequence/effort.hpp"
#include "reasoning/dl/consequence/premise.hpp"

namespace geminga::consequence {

/// Of a store that it is given, Conclusions only reads the clauses and counts conclusions with alternatives.
class Conclusions {
 public:
  Conclusions(Effort& effort, SharedEffort& shared) : effort_(effort), shared_(shared) {}

  // A conclusion is begun, given sides, and finished.
  void begin() {
    body_.clear();
    head_.clear();
  }
  /// Adds G and D of the premise G -> D v [L].
  void add_side(const ClauseStore& store, Premise premise);
  void add_body(std::span<const Literal> body) { body_.insert(body_.end(), body.begin(), body.end()); }
  void add_head(Literal literal) { head_.push_back(literal); }
  /// Adds the head's last literals. A unit that the store has is no conclusion, and neither is one with alternatives in
  /// a store that is cut.
  void finish(ClauseStore& store, std::span<const Literal> head);

  /// Counts a step of matching a rule with alternatives. False: the context has had too many, and is cut.
  [[nodiscard]] bool may_match_alternatives(ClauseStore& store);

  /// Concludes G -> D v L' from the premise G -> D v [L].
  void conclude(ClauseStore& store, Premise premise, Literal instead);
  /// Concludes true -> L.
  void add_unit(Literal unit) { units_.push_back(unit); }

  [[nodiscard]] bool has_contradiction() const { return has_contradiction_; }
  [[nodiscard]] std::span<const Literal> units() const { return units_; }
  /// Calls `use` with the body and the head of each conclusion that is no unit, until it returns false.
  template <typename Use>
  void for_each_clause(Use&& use) const {
    std::size_t at = 0;
    for (const Size& size : sizes_) {
      const std::span<const Literal> literals = std::span(literals_).subspan(at, size.body + size.head);
      at += literals.size();
      if (!use(literals.first(size.body), literals.subspan(size.body))) return;
    }
  }
  void clear() {
    units_.clear();
    literals_.clear();
    sizes_.clear();
    has_contradiction_ = false;
  }

 private:
  /// Literals of conclusions that wait (64 MiB). A single step with more of them cannot end in time anyway.
  static constexpr std::size_t max_waiting_literals = std::size_t{1} << 24;
  struct Size {
    std::size_t body = 0;
    std::size_t head = 0;
  };

  [[nodiscard]] bool may_have_alternatives(ClauseStore& store);

  Effort& effort_;
  SharedEffort& shared_;
  std::vector<Literal> body_;  ///< of the conclusion that is begun
  std::vector<Literal> head_;
  std::vector<Literal> units_;     ///< conclusions that are units
  std::vector<Literal> literals_;  ///< of other conclusions, body and head of one after the other
  std::vector<Size> sizes_;        ///< of each of them
  bool has_contradiction_ = false;
};

}  // namespace geminga::consequence

#endif
