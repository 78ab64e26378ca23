// The contexts for which the model check has failed.
#ifndef GEMINGA_REASONING_EL_MODEL_FAILING_CONTEXTS_HPP
#define GEMINGA_REASONING_EL_MODEL_FAILING_CONTEXTS_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "reasoning/el/closure/context.hpp"

namespace geminga::el {

/// A set of contexts that only grows (Lemma 2).
class FailingContexts {
 public:
  explicit FailingContexts(const ContextStore& contexts) : contexts_(contexts), has_(contexts.size(), false) {}

  [[nodiscard]] bool has(std::uint32_t context) const { return has_[context]; }
  [[nodiscard]] std::size_t count() const { return count_; }
  void add(std::uint32_t context) {
    if (has_[context]) return;
    has_[context] = true;
    ++count_;
    new_.push_back(context);
  }
  /// Adds the contexts from which links lead to one of the set.
  void follow() {
    while (!new_.empty()) {
      const std::uint32_t at = new_.back();
      new_.pop_back();
      for (const Link link : contexts_[at].backward.items()) {
        if (!contexts_[link.context].is_unsatisfiable) add(link.context);
      }
    }
  }

 private:
  const ContextStore& contexts_;
  std::vector<bool> has_;
  std::size_t count_ = 0;
  std::vector<std::uint32_t> new_;  ///< contexts whose sources have not been added
};

}  // namespace geminga::el

#endif
