#include "reasoning/dl/consequence/successor_rule.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace geminga::consequence {

void SuccessorRule::apply(Context& context, Successor& successor) {
  if (successor.replaced_by != successor.f) {
    if (successor.target != nullptr) outbox_.send(*successor.target, MessageKind::no_edge, &context, successor.f);
    successor.target = nullptr;
    return;
  }
  ContextKey key;
  key.is_value = rules_.is_value(function_of(successor.f));
  if (successor.is_certain) {
    key.core = successor.certain;
  } else {
    key.function = function_of(successor.f);
  }
  if (successor.target == nullptr || successor.target->key != key) {
    if (successor.target != nullptr) outbox_.send(*successor.target, MessageKind::no_edge, &context, successor.f);
    successor.target = &outbox_.context_for(std::move(key));
    successor.told = 0;
    successor.knows_existence = false;
  } else if (successor.told == successor.possible.size()) {
    return;
  }
  successor.told = successor.possible.size();
  hypotheses_.clear();
  std::ranges::set_difference(successor.possible, successor.target->key.core, std::back_inserter(hypotheses_));
  outbox_.send(*successor.target, MessageKind::edge, &context, successor.f, hypotheses_);
  tell_existence(context, successor);
}

void SuccessorRule::tell_existence(Context& context, Successor& successor) {
  if (!context.is_nonempty || !successor.is_certain || successor.target == nullptr) return;
  if (successor.knows_existence) return;
  successor.knows_existence = true;
  outbox_.send(*successor.target, MessageKind::exists, &context, successor.f);
}

}  // namespace geminga::consequence
