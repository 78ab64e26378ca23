// The way from one thread to the contexts: it makes them and sends messages to them.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_OUTBOX_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_OUTBOX_HPP

#include <span>
#include <utility>

#include "reasoning/dl/consequence/context_table.hpp"
#include "reasoning/dl/consequence/effort.hpp"
#include "reasoning/dl/consequence/schedule.hpp"

namespace geminga::consequence {

class Outbox {
 public:
  Outbox(ContextTable& contexts, Schedule& schedule, SharedEffort& effort, unsigned thread)
      : contexts_(contexts), schedule_(schedule), effort_(effort), thread_(thread) {}

  /// The context with this key. A new one is sent its first message.
  [[nodiscard]] Context& context_for(ContextKey&& key) {
    const auto [context, is_new] = contexts_.find_or_make(std::move(key));
    if (is_new) send(context, MessageKind::start, nullptr, x_term);
    return context;
  }
  /// Sends a message from the context `from` about its successor f, and schedules the receiver. Where too many messages
  /// wait nothing is sent, and all threads stop.
  void send(Context& to, MessageKind kind, Context* from, Term f, std::span<const Literal> body = {},
            std::span<const Literal> head = {}) {
    if (effort_.count_message() && to.mailbox.put(kind, from, f, body, head)) schedule_.add(to, thread_);
  }

 private:
  ContextTable& contexts_;
  Schedule& schedule_;
  SharedEffort& effort_;
  unsigned thread_;
};

}  // namespace geminga::consequence

#endif
