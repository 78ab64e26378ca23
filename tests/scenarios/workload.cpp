#include "scenarios/workload.hpp"

#include <algorithm>
#include <string>

#include "sim/host.hpp"
#include "sim/robots.hpp"

namespace geminga::scenarios {
namespace {

/// Beyond so many participants the views of all of them together would be most of the work.
constexpr std::size_t largest_full_team = 60;
/// In a large team so many share one topic.
constexpr std::size_t circle = 10;
constexpr base::Duration shortest_life = std::chrono::seconds(5);
constexpr base::Duration longest_life = std::chrono::seconds(30);

}  // namespace

Workload::Workload(sim::World& world, sim::Team& team, const Conditions& conditions)
    : world_(world), team_(team), conditions_(conditions), random_(conditions.seed ^ 0x776f726bU) {}

void Workload::start() {
  for (std::size_t i = 0; i < conditions_.participants; ++i) {
    sim::Host& host = world_.add_host("robot" + std::to_string(i + 1));
    host.settings.interval = conditions_.interval;
    if (conditions_.drift > 0) {
      const auto choices = static_cast<std::uint64_t>(2 * conditions_.drift + 1);
      host.set_drift(static_cast<std::int64_t>(random_.below(choices)) - conditions_.drift);
    }
    furnish(host);
    world_.after(random_.between(base::Duration(0), std::chrono::seconds(1)), [&host] {
      if (!host.is_on()) host.switch_on();
    });
  }
  for (const auto& module : team_.modules()) module->run();
  plan_change();
}

void Workload::furnish(sim::Host& host) {
  sim::Module& reporter = team_.add(host, host.name() + "-reporter");
  reporters_.push_back(&reporter);
  reporter.wish("news", sim::stream);
  if (conditions_.services == 0 && conditions_.participants <= largest_full_team) return sim::furnish(team_, host);
  const std::size_t services = std::max<std::size_t>(conditions_.services, 1);
  for (std::size_t i = 0; i < services; ++i) {
    // Every other topic is one whose providers are told who asks.
    const std::string topic = "topic" + std::to_string(i) + "-" + std::to_string((host.number() - 1) / circle);
    const char* mode = i % 2 == 0 ? sim::stream : sim::pubsub;
    reporter.offer(topic, mode);
    reporter.wish(topic, mode);
  }
}

void Workload::plan_change() {
  if (conditions_.changes_per_minute == 0) return;
  const base::Duration mean = base::Duration(std::chrono::minutes(1)) / conditions_.changes_per_minute;
  world_.after(random_.between(mean / 2, mean * 3 / 2), [this] {
    if (is_over_) return;
    change();
    plan_change();
  });
}

void Workload::change() {
  const std::size_t reporter = random_.below(reporters_.size());
  const base::Duration life = random_.between(shortest_life, longest_life);
  sim::Module& module = *reporters_[reporter];
  if (!module.client().is_connected() || module.host().pause() != sim::Host::Pause::none) return;
  ++changes_;
  const News news{reporter, module.offer("news", sim::stream)};
  standing_.insert(news);
  withdraw_after(life, news);
}

void Workload::withdraw_after(base::Duration delay, const News& news) {
  world_.after(delay, [this, news] {
    if (standing_.contains(news) && !withdraw(news)) withdraw_after(std::chrono::seconds(1), news);
  });
}

/// A module whose host does nothing withdraws nothing meanwhile.
bool Workload::withdraw(const News& news) {
  sim::Module& module = *reporters_[news.first];
  if (module.host().pause() != sim::Host::Pause::none) return false;
  module.withdraw(news.second);
  standing_.erase(news);
  return true;
}

void Workload::stop() {
  is_over_ = true;
  for (const News& news : std::set(standing_)) (void)withdraw(news);
}

}  // namespace geminga::scenarios
