// Robots as in the paper's section 4, for scenarios.
#ifndef GEMINGA_TESTS_SIM_ROBOTS_HPP
#define GEMINGA_TESTS_SIM_ROBOTS_HPP

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim/team.hpp"

namespace geminga::sim {

inline constexpr const char* stream = "otm/stream";
inline constexpr const char* pubsub = "otm/pubsub";

/// Three modules on a host, which offer and want what the others do (paper section 4: nine and seven a robot).
inline void furnish(Team& team, Host& host) {
  Module& vision = team.add(host, host.name() + "-vision");
  Module& model = team.add(host, host.name() + "-model");
  Module& motion = team.add(host, host.name() + "-motion");
  for (const char* what : {"ball", "obstacles", "lines"}) vision.offer(what, stream);
  for (const char* what : {"world", "role", "plan"}) model.offer(what, pubsub);
  for (const char* what : {"odometry", "joystick", "kicker"}) motion.offer(what, "oto");
  for (const char* what : {"ball", "lines", "compass"}) model.wish(what, stream);
  for (const char* what : {"world", "role"}) motion.wish(what, pubsub);
  for (const char* what : {"odometry"}) vision.wish(what, "oto");
}

/// A team of such hosts.
class Robots {
 public:
  Robots(std::uint64_t seed, int count, Air air, Bounds bounds = {}) : world(seed, air), team(world, bounds) {
    for (int i = 1; i <= count; ++i) add("robot" + std::to_string(i));
  }

  Host& add(const std::string& name) {
    Host& host = world.add_host(name);
    furnish(team, host);
    return host;
  }

  /// Switches all on, each at a moment of its own in the first second.
  void start() {
    for (const auto& host : world.hosts()) {
      world.after(world.random().between(std::chrono::milliseconds(0), std::chrono::seconds(1)),
                  [one = host.get()] { one->switch_on(); });
    }
    for (const auto& module : team.modules()) module->run();
    world.run_for(std::chrono::seconds(1));
  }

  [[nodiscard]] Host& host(std::size_t index) { return *world.hosts().at(index); }
  [[nodiscard]] Module& module(std::size_t index) { return *team.modules().at(index); }

  World world;
  Team team;
};

/// Something small changes again and again: a module offers a thing or withdraws it.
inline void keep_changing(Robots& robots, base::Duration period) {
  auto offered = std::make_shared<std::vector<std::pair<Module*, std::uint32_t>>>();
  robots.world.every(period, [&robots, offered] {
    base::Random& random = robots.world.random();
    if (offered->size() < 5) {
      Module& module = robots.module(random.below(robots.team.modules().size()));
      offered->emplace_back(&module, module.offer("ball", stream));
    } else {
      const auto [module, number] = offered->front();
      offered->erase(offered->begin());
      module->withdraw(number);
    }
  });
}

}  // namespace geminga::sim

#endif
