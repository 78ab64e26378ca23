#include "discovery/participant/transcript.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "base/text.hpp"
#include "discovery/announcement/codec.hpp"
#include "discovery/sealing/rig.hpp"
#include "sim/small_ontology.hpp"
#include "support/transcript_words.hpp"

namespace geminga::participant {
void Transcript::play() {
  std::ifstream file(path_);
  ASSERT_TRUE(file) << path_;
  std::string text;
  for (int number = 1; std::getline(file, text); ++number) {
    at_ = path_ + ":" + std::to_string(number) + ": " + text;
    if (text.empty() || text.starts_with('#')) continue;
    line(text);
    if (testing::Test::HasFailure()) return;
  }
  at_ = path_ + ": at the end";
  expect_nothing_more();
}

void Transcript::line(std::string_view text) {
  std::string_view rest = text;
  const std::string who = test::next_word(rest);
  if (who == "@") {
    // Waiting is no action: what comes meanwhile is expected after it.
    if (!rest.starts_with(" wait")) expect_nothing_more();
    if (!testing::Test::HasFailure()) direct(rest);
    return;
  }
  const std::string sign = test::next_word(rest);
  rest.remove_prefix(std::min<std::size_t>(1, rest.size()));
  ASSERT_TRUE(clients_.contains(who)) << at_ << ": nobody of that name is connected";
  if (sign == "<") {
    expect(who, rest);
  } else {
    ASSERT_TRUE(sign == ">" || sign == ">>") << at_;
    expect_nothing_more();
    if (!testing::Test::HasFailure()) say(who, substituted(rest), sign == ">>");
  }
}

void Transcript::direct(std::string_view words) {
  const std::string verb = test::next_word(words);
  const std::string name = test::next_word(words);
  const std::string third = test::next_word(words);
  if (verb == "host") {
    sim::Host& made = world_.add_host(name);
    hosts_[name] = &made;
  } else if (verb == "connect") {
    sim::Client& client = clients_.contains(name) ? *clients_.at(name) : *(clients_[name] = &world_.add_client(name));
    ASSERT_NE(host(third), nullptr) << at_;
    client.connect(*host(third));
  } else if (verb == "wait") {
    const auto count = base::parse_number<int>(name);
    ASSERT_TRUE(count && (third == "ms" || third == "s")) << at_;
    run(*count * (third == "s" ? std::chrono::seconds(1) : base::Duration(std::chrono::milliseconds(1))));
  } else if (verb == "deaf" || verb == "reading") {
    clients_.at(name)->set_reading(verb == "reading");
  } else if (verb == "hang-up") {
    clients_.at(name)->hang_up();
  } else if (verb == "closed") {
    EXPECT_FALSE(clients_.at(name)->is_connected()) << at_;
  } else if (verb == "open") {
    EXPECT_TRUE(clients_.at(name)->is_connected()) << at_;
  } else {
    sim::Host* const one = host(name);
    ASSERT_NE(one, nullptr) << at_;
    if (verb == "on") {
      one->switch_on();
    } else if (verb == "crash") {
      one->crash();
    } else if (verb == "stop") {
      one->stop();
    } else if (verb == "ontology") {
      one->ontology = sim::small_ontology(third);
      if (one->is_on()) one->reload(one->ontology);
    } else if (verb == "unprepared") {
      one->ontology = sim::small_ontology(third);
      one->event([&](participant::Participant& participant) { participant.set_vocabulary(one->ontology); });
    } else if (verb == "preparing") {
      const auto count = base::parse_number<int>(third);
      ASSERT_TRUE(count && words == " ms") << at_;
      one->preparing_takes = std::chrono::milliseconds(*count);
    } else if (verb == "loading") {
      one->event([](participant::Participant& participant) { participant.ontology_begun(); });
    } else if (verb == "failed") {
      one->event(
          [&](participant::Participant& participant) { participant.ontology_failed({third + std::string(words)}); });
    } else if (verb == "log" || verb == "no-log") {
      expect_logged(*one, third + std::string(words), verb == "log");
      return;
    } else if (verb == "limit") {
      set_limit(*one, third, std::stoul(test::next_word(words)));
    } else if (verb == "seal") {
      seal(*one, third, words);
    } else if (verb == "receive") {
      const std::string bytes = test::unescaped(substituted(third));
      one->receive(one->ports().front().index, "10.0.0.99", bytes);
    } else if (verb == "clash") {
      clash(*one, substituted(third));
    } else {
      FAIL() << at_ << ": no such direction";
    }
  }
  run(std::chrono::milliseconds(1));
}

void Transcript::clash(sim::Host& host, const std::string& id) {
  announcement::Announcement other;
  other.group = host.settings.group;
  other.participant = participant_id(id).value_or(ParticipantId{});
  other.boot = announcement::BootNonce(99);
  other.name = "another";
  ASSERT_NE(other.participant, ParticipantId{}) << at_;
  for (const announcement::Datagram& datagram : announcement::encode(other)) {
    host.receive(host.ports().front().index, "10.0.0.99",
                 std::string_view(reinterpret_cast<const char*>(datagram.data()), datagram.size()));
  }
}

void Transcript::expect_logged(sim::Host& host, std::string_view pattern, bool is_expected) {
  auto& logged = host.logged;
  const auto found =
      std::ranges::find_if(logged, [&](const std::string& line) { return words_.matches(pattern, line); });
  EXPECT_EQ(found != logged.end(), is_expected) << at_ << "\n  the log: " << testing::PrintToString(logged);
  if (found != logged.end()) logged.erase(logged.begin(), found + 1);
}

void Transcript::set_limit(sim::Host& host, const std::string& name, std::size_t value) {
  ClientLimits& limits = host.settings.limits;
  const std::map<std::string, std::size_t*> known{{"peers", &limits.peers},
                                                  {"services_per_peer", &limits.services_per_peer},
                                                  {"room_per_peer", &limits.room_per_peer},
                                                  {"room", &limits.room},
                                                  {"services", &limits.services},
                                                  {"statements_per_second", &limits.statements_per_second},
                                                  {"flood_per_second", &limits.flood_per_second},
                                                  {"unread", &limits.unread},
                                                  {"unread_before_more", &limits.unread_before_more}};
  ASSERT_TRUE(known.contains(name)) << at_;
  *known.at(name) = value;
}

void Transcript::seal(sim::Host& host, const std::string& mode, std::string_view keys) {
  const auto read = sealing::read_mode(mode);
  ASSERT_TRUE(read) << at_;
  sealing::Policy policy{.mode = *read};
  for (std::string key = test::next_word(keys); !key.empty(); key = test::next_word(keys)) {
    ASSERT_EQ(policy.keys.add(sealing::key_of(std::stoi(key))), sealing::Keyring::Added::yes) << at_;
  }
  host.settings.sealing = policy;
  host.event([&](Participant& participant) { participant.set_sealing(policy); });
}

void Transcript::say(const std::string& client, const std::string& text, bool is_raw) {
  if (is_raw) {
    clients_.at(client)->send_bytes(test::unescaped(text));
  } else {
    clients_.at(client)->say(text);
  }
  run(std::chrono::milliseconds(1));
}

void Transcript::expect(const std::string& client, std::string_view pattern) {
  auto& lines = clients_.at(client)->lines;
  ASSERT_FALSE(lines.empty()) << at_ << ": nothing came";
  const std::string came = lines.front();
  lines.erase(lines.begin());
  ASSERT_TRUE(words_.matches(pattern, came)) << at_ << "\n  came: " << came;
}

void Transcript::expect_nothing_more() {
  for (const auto& [name, client] : clients_) {
    for (const std::string& came : client->lines)
      ADD_FAILURE() << at_ << "\n  came before, to " << name << ": " << came;
    client->lines.clear();
  }
}

void Transcript::run(base::Duration duration) { world_.run_for(duration); }

std::string Transcript::substituted(std::string_view text) const {
  const auto result = words_.substituted(text);
  EXPECT_TRUE(result) << at_ << ": a name is not known yet";
  return result.value_or("");
}

sim::Host* Transcript::host(const std::string& name) {
  const auto found = hosts_.find(name);
  return found == hosts_.end() ? nullptr : found->second;
}

}  // namespace geminga::participant
