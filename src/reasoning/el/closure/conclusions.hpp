// The conclusions of one worker of a saturation: notes each that is new in its context, and queues the context.
#ifndef GEMINGA_REASONING_EL_CLOSURE_CONCLUSIONS_HPP
#define GEMINGA_REASONING_EL_CLOSURE_CONCLUSIONS_HPP

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <mutex>
#include <span>
#include <vector>

#include "base/arena.hpp"
#include "reasoning/el/closure/context.hpp"
#include "reasoning/el/closure/context_queue.hpp"
#include "reasoning/el/closure/limits.hpp"
#include "reasoning/el/closure/work_count.hpp"
#include "reasoning/el/index/indexed_ontology.hpp"

namespace geminga::el {

/// The contexts of one saturation, which all its workers share.
struct SharedContexts {
  SharedContexts(const IndexedOntology& of, const SaturationLimits& within);

  const IndexedOntology& index;
  SaturationLimits limits;
  bool keeps_forward;  ///< all forward links, not only those of chains
  ContextStore contexts;
  std::vector<std::atomic<std::uint32_t>> context_of;  ///< by atom: no_context, claimed_context, or the number and 2
  std::mutex together_mutex;                           ///< guards the next two
  std::map<std::vector<ExprId>, std::uint32_t> context_of_some;
  std::size_t merged_atoms = 0;
  std::atomic<bool> is_inconsistent = false;
  std::atomic<bool> is_over_limit = false;
  std::atomic<bool> is_over_merged = false;  ///< over the limit of merged atoms
  std::atomic<bool> is_cut_off = false;      ///< over the budget

  static constexpr std::uint32_t no_context = 0;
  static constexpr std::uint32_t claimed_context = 1;

  [[nodiscard]] bool has_ended() const {
    return is_inconsistent.load(std::memory_order_relaxed) || is_over_limit.load(std::memory_order_relaxed);
  }
};

/// Makes contexts and notes conclusions; applies no rule. A conclusion about a context that another worker holds
/// travels there as a message. The legend is in saturation.hpp.
class Conclusions {
 public:
  Conclusions(SharedContexts& shared, std::uint8_t rank)
      : shared_(shared), contexts_(shared.contexts), queue_(shared.contexts, rank), work_(shared) {}

  /// The context of an atom; makes it if there is none.
  std::uint32_t require(ExprId root);
  /// The context of several atoms together, ascending; makes it if there is none.
  std::uint32_t require_together(const std::vector<ExprId>& atoms);
  /// The atoms of a context.
  [[nodiscard]] std::vector<ExprId> members_of(std::uint32_t context) const;

  void add_subsumer(std::uint32_t context, ExprId subsumer);
  /// Notes an atom, which need not have rules, above a context.
  void add_atom(std::uint32_t context, ExprId atom);
  void add_bottom(std::uint32_t context);
  /// Notes a link; `is_last` says that it need not be the first of a composition.
  void add_link(std::uint32_t from, RoleId role, std::uint32_t to, bool is_last = false);
  void add_self(std::uint32_t context, RoleId role);

  /// Marks the context as having an instance in every model. False if it was marked.
  bool mark_nonempty(std::uint32_t context);

  [[nodiscard]] ContextStore& contexts() { return contexts_; }
  [[nodiscard]] const IndexedOntology& index() const { return shared_.index; }
  void count_work(std::size_t premises) { work_.add(premises); }
  [[nodiscard]] std::size_t conclusion_count() const { return conclusions_; }
  [[nodiscard]] std::size_t link_count() const { return links_; }

 protected:
  /// Reads a message from the mailbox of a context that this worker holds, and frees it.
  void read(std::uint32_t context, QueuedMessage* waiting);

  SharedContexts& shared_;
  ContextStore& contexts_;
  ContextQueue<ContextStore, QueuedMessage> queue_;
  base::Arena arena_;

 private:
  static constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

  void start(std::uint32_t context, std::span<const ExprId> atoms);
  void add_forward(std::uint32_t from, Link link);
  void post(std::uint32_t context, const Message& message);
  void receive(std::uint32_t context, const Message& message);

  WorkCount<SharedContexts> work_;
  std::size_t conclusions_ = 0;
  std::size_t links_ = 0;
  /// The messages that were posted of late: a table in which a new one displaces an old one.
  struct Posted {
    std::uint32_t context = nowhere;
    Message message;
  };
  static constexpr std::size_t posted_count = std::size_t{1} << 15;
  std::vector<Posted> posted_;
};

}  // namespace geminga::el

#endif
