#include "reasoning/dl/consequence/saturation.hpp"

#include <utility>

#include "base/parallel/crew.hpp"
#include "reasoning/dl/consequence/worker.hpp"

namespace geminga::consequence {

void Saturation::ask(ContextKey&& key) { static_cast<void>(outbox(0).context_for(std::move(key))); }

void Saturation::assert_existence(ContextKey&& key) {
  Outbox to = outbox(0);
  to.send(to.context_for(std::move(key)), MessageKind::exists, nullptr, x_term);
}

void Saturation::run(unsigned threads) {
  parallel::Crew crew(threads);
  schedule_.set_threads(crew.size());
  crew.run(
      [this](unsigned thread) {
        const ArenaUse use(schedule_.arena(thread));
        Worker worker(rules_, effort_, outbox(thread));
        schedule_.run(thread, [&](Context& context) { worker.work(context); });
      },
      [this] {
        effort_.give_up();
        schedule_.abandon();
      });
}

}  // namespace geminga::consequence
