#include "scenarios/script.hpp"

#include <algorithm>

#include "discovery/announcement/limits.hpp"

namespace geminga::scenarios {
namespace {

using sim::Host;

/// For how long a lie may show: it lasts until its victim is believed again (ANNOUNCEMENT.md, "Who is believed").
constexpr int lie_intervals = 2 * announcement::hold_intervals + announcement::contest_intervals;
constexpr const char* stranger = "10.0.7.66";

std::string name(std::size_t host) { return "robot" + std::to_string(host + 1); }

std::string names(const Hosts& hosts) {
  std::string text;
  for (const std::size_t host : hosts) text += (text.empty() ? "" : ", ") + name(host);
  return text;
}

void switch_on(Stage& stage, std::size_t index) {
  if (!stage.host(index).is_on()) stage.host(index).switch_on();
}

void forget(Stage& stage, std::size_t index) {
  for (const auto& module : stage.team.modules()) {
    if (&module->host() == &stage.host(index) && !module->client().is_connected()) module->forget();
  }
}

/// A false entry counts as a lie for a while, and not as a mistake of the client that was told it.
void excuse_lies(Stage& stage) {
  stage.team.ledger().tampered_until(stage.world.now() + lie_intervals * stage.interval);
}

void tell(Stage& stage, Lie what, const Host& victim) {
  if (!stage.liar.has_heard(victim)) return;
  auto forged = stage.liar.last_state(victim);
  const std::string source = sim::Liar::address_of(victim);
  ++forged.sequence;
  switch (what) {
    case Lie::goodbye:
      forged.kind = announcement::Kind::goodbye;
      forged.peers.clear();
      break;
    case Lie::emptied:
      forged.peers.clear();
      ++forged.revision;
      break;
    case Lie::moved:
      forged.addresses = {stranger};
      ++forged.revision;
      break;
    case Lie::repeated:
      return stage.liar.replay(victim, stranger);
    case Lie::reborn:
      forged.boot = announcement::BootNonce{66};
      break;
  }
  stage.liar.say(forged, source);
}

std::string words_of(Lie lie) {
  switch (lie) {
    case Lie::goodbye:
      return "that it leaves";
    case Lie::emptied:
      return "that it offers nothing";
    case Lie::moved:
      return "that its services are elsewhere";
    case Lie::repeated:
      return "all that it has said, again";
    case Lie::reborn:
      return "that it is another one";
  }
  return {};
}

}  // namespace

void Script::add(base::Duration at, std::string words, std::function<void(Stage&)> act) {
  steps_.push_back({.at = at, .words = std::move(words), .act = std::move(act)});
  end_ = std::max(end_, at);
}

std::vector<Script::Step> Script::steps() const {
  std::vector<Step> sorted = steps_;
  std::ranges::stable_sort(sorted, {}, &Step::at);
  return sorted;
}

void Script::crash(base::Duration at, std::size_t host) {
  add(at, name(host) + " dies", [host](Stage& stage) { stage.host(host).crash(); });
}

void Script::restart(base::Duration at, std::size_t host, base::Duration off, Memory memory) {
  const bool forgets = memory == Memory::lost;
  add(at, name(host) + (forgets ? " and its modules are killed" : " is killed"),
      [host](Stage& stage) { stage.host(host).crash(); });
  add(at + off, name(host) + " starts again", [host, forgets](Stage& stage) {
    if (forgets) forget(stage, host);
    switch_on(stage, host);
  });
}

void Script::leave(base::Duration at, std::size_t host, base::Duration off) {
  add(at, name(host) + " says goodbye", [host](Stage& stage) {
    if (stage.host(host).pause() == Host::Pause::none) stage.host(host).stop();
  });
  add(at + off, name(host) + " comes back", [host](Stage& stage) { switch_on(stage, host); });
}

void Script::sleep(base::Duration at, std::size_t host, base::Duration lasts) {
  add(at, name(host) + " falls asleep", [host](Stage& stage) { stage.host(host).pause(Host::Pause::asleep); });
  add(at + lasts, name(host) + " wakes up", [host](Stage& stage) { stage.host(host).resume(); });
}

void Script::stall(base::Duration at, std::size_t host, base::Duration lasts) {
  add(at, name(host) + " gets no processor", [host](Stage& stage) { stage.host(host).pause(Host::Pause::stopped); });
  add(at + lasts, name(host) + " goes on", [host](Stage& stage) { stage.host(host).resume(); });
}

void Script::separate(base::Duration at, const Hosts& hosts, base::Duration lasts) {
  const int island = ++islands_;
  const auto move = [hosts](int to) {
    return [hosts, to](Stage& stage) {
      for (const std::size_t host : hosts) stage.host(host).set_island(to);
    };
  };
  add(at, "cut off from the others: " + names(hosts), move(island));
  add(at + lasts, "hear the others again: " + names(hosts), move(0));
}

void Script::deafen(base::Duration at, std::size_t deaf, std::size_t unheard, base::Duration lasts) {
  add(at, name(deaf) + " does not hear " + name(unheard),
      [=](Stage& stage) { stage.world.cut(stage.host(unheard), stage.host(deaf)); });
  add(at + lasts, name(deaf) + " hears " + name(unheard) + " again",
      [=](Stage& stage) { stage.world.mend(stage.host(unheard), stage.host(deaf)); });
}

void Script::weather(base::Duration at, const sim::Air& air, const std::string& words, base::Duration lasts) {
  add(at, words, [air, lasts](Stage& stage) {
    stage.world.air = air;
    if (air.flip > 0) {
      stage.team.ledger().tampered_until(stage.world.now() + lasts + lie_intervals * stage.interval);
    }
  });
  add(at + lasts, "the air is as usual", [](Stage& stage) { stage.world.air = stage.usual; });
}

void Script::lie(base::Duration at, Lie lie, std::size_t victim) {
  add(at, "somebody says in the name of " + name(victim) + " " + words_of(lie), [=](Stage& stage) {
    excuse_lies(stage);
    tell(stage, lie, stage.host(victim));
  });
}

}  // namespace geminga::scenarios
