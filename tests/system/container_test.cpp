// Each way to put modules and daemons into containers, as examples/containers/README.md tells it, tried with real
// daemons.
#include "system/container.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/lab.hpp"
#include "system/folder.hpp"

namespace geminga::system {
namespace {

using testing::HasSubstr;

std::vector<std::string> daemon_words(const std::vector<std::string>& flags) {
  std::vector<std::string> words{program("gemingad"), "--name", "container", "--interval", "0.1"};
  words.insert(words.end(), flags.begin(), flags.end());
  return words;
}

/// Waits until the daemon behind this connection knows exactly so many participants.
bool comes_to(Talk talk, std::size_t count) {
  return talk.wait_until("participants", [&](const auto& lines) { return lines.size() == count; });
}

struct InContainers : testing::Test {
  void SetUp() override {
    if (!Lab::can_lose()) GTEST_SKIP() << "containers need network namespaces and nftables";
  }
};

TEST_F(InContainers, ADaemonOnAMacvlanIsAHostOfItsOwnButNotForItsOwnHost) {
  Lab lab(2);
  lab.start_all({"--interval", "0.1"});
  const Container container(lab, 0, Container::Way::macvlan);
  Process daemon(container.on(daemon_words({})));
  ASSERT_TRUE(daemon.wait_for(" ready: ")) << daemon.said();
  EXPECT_TRUE(lab.wait_for_participants(1, 3));
  Talk talk = lab.talk(1);
  EXPECT_TRUE(talk.wait_until("participants", [&](const auto& lines) {
    return testing::Matches(testing::Contains(HasSubstr(container.address())))(lines);
  })) << "the container's own address is announced";
  // The kernel gives nothing from a macvlan to its parent and back.
  EXPECT_TRUE(comes_to(container.talk(), 2));
  EXPECT_TRUE(lab.wait_for_participants(0, 2));
}

TEST_F(InContainers, ADaemonOnABridgeIsAloneAndAPeerWithAKeyCrossesTheTranslation) {
  const Folder folder;
  const std::string key = folder.path("team.key");
  ASSERT_EQ(refused({"--generate-key", key}).status, 0);
  Lab lab(2);
  lab.start(1, {"--interval", "0.1", "--key-file", key, "--peer", "*"});
  const Container container(lab, 0, Container::Way::bridge);
  {
    Process alone(container.on(daemon_words({"--key-file", key})));
    ASSERT_TRUE(alone.wait_for(" ready: ")) << alone.said();
    Talk talk = container.talk();
    EXPECT_TRUE(talk.wait_until("status", [](const auto& lines) {
      return !lines.empty() && std::stoi("0" + field(lines[0], "datagrams_sent")) >= 10;
    })) << testing::PrintToString(talk.query("status"));
    EXPECT_EQ(talk.query("participants").size(), 1U) << "no multicast leaves the bridge";
  }
  Process daemon(container.on(daemon_words({"--key-file", key, "--peer", lab.address_of(1)})));
  ASSERT_TRUE(daemon.wait_for(" ready: ")) << daemon.said();
  EXPECT_TRUE(comes_to(container.talk(), 2));
  EXPECT_TRUE(lab.wait_for_participants(1, 2));
}

/// A host with a daemon whose socket its container has as a volume, and another host.
struct WithTheSocketOfTheHost : InContainers {
  void SetUp() override {
    InContainers::SetUp();
    if (IsSkipped()) return;
    lab.emplace(2);
    lab->start(0, {"--interval", "0.1", "--gcnp-socket", socket});
    lab->start(1, {"--interval", "0.1"});
    ASSERT_TRUE(lab->wait_for_participants(0, 2));
    ASSERT_TRUE(lab->wait_for_participants(1, 2));
    container.emplace(*lab, 0, Container::Way::bridge);
  }

  Process::Start inside(const std::string& name, std::vector<std::string> flags) const {
    std::vector<std::string> words{program(name), "--connect", socket};
    words.insert(words.end(), flags.begin(), flags.end());
    return container->on(std::move(words));
  }
  /// A line of `text` every 50 ms to a program in the container.
  Process::Start talking(const std::string& text, const std::string& flags) const {
    return container->on({"/bin/bash", "-c",
                          "while echo " + text + "; do read -rt 0.05 <> <(:) || true; done | '" +
                              program("geminga-publish") + "' --connect '" + socket + "' " + flags + " --send"});
  }
  Process::Start outside(const std::string& name, std::vector<std::string> flags) const {
    std::vector<std::string> words{program(name)};
    words.insert(words.end(), flags.begin(), flags.end());
    return lab->on(1, std::move(words));
  }

  Folder folder;
  std::string socket = folder.path("gcnp");
  std::optional<Lab> lab;
  std::optional<Container> container;
};

TEST_F(WithTheSocketOfTheHost, AServiceIsAnnouncedAtTheAddressOfTheHost) {
  Process publish(inside("geminga-publish", {"--text", "lamp", "--mode", "oto", "--port", "5000"}));
  Process subscribe(outside("geminga-subscribe", {"--text", "lamp", "--mode", "oto"}));
  EXPECT_TRUE(subscribe.wait_for(lab->address_of(0) + ":5000")) << subscribe.said();
}

TEST_F(WithTheSocketOfTheHost, MessagesThatAModuleSendsLeaveItsContainer) {
  for (const std::string protocol : {"udp", "tcp"}) {
    // Over TCP consumers connect, so the port is published.
    if (protocol == "tcp") container->publish(5001, "tcp");
    Process publish(talking("ball-" + protocol,
                            "--text ball-" + protocol + " --mode otm/pubsub --port 5001 --protocol " + protocol));
    Process subscribe(outside("geminga-subscribe", {"--text", "ball-" + protocol, "--mode", "otm/pubsub", "--listen"}));
    EXPECT_TRUE(subscribe.wait_for("ball-" + protocol + "\n")) << subscribe.said() << publish.said();
  }
}

TEST_F(WithTheSocketOfTheHost, WhatAModuleAsksForComesBackTheWayThatItsHelloWent) {
  for (const std::string flags : {"--mode otm/stream", "--mode otm/pubsub --protocol tcp"}) {
    const std::string talking = "while echo camera; do read -rt 0.05 <> <(:) || true; done | '";
    Process publish(
        lab->on(1, {"/bin/bash", "-c", talking + program("geminga-publish") + "' --text camera " + flags + " --send"}));
    Process subscribe(container->on({"/bin/bash", "-c",
                                     "exec '" + program("geminga-subscribe") + "' --connect '" + socket +
                                         "' --text camera " + flags + " --listen"}));
    EXPECT_TRUE(subscribe.wait_for("camera\n")) << flags << subscribe.said() << publish.said();
  }
}

TEST_F(WithTheSocketOfTheHost, AModuleThatAsksForMessagesOverUdpGetsNone) {
  for (const std::string mode : {"oto", "otm/pubsub"}) {
    Process subscribe(inside("geminga-subscribe", {"--text", "shot-" + mode, "--mode", mode, "--listen"}));
    Process publish(
        lab->on(1, {"/bin/bash", "-c",
                    "for ((i = 1;; ++i)); do echo frame-$i; read -rt 0.05 <> <(:) || true; done | '" +
                        program("geminga-publish") + "' --text shot-" + mode + " --mode " + mode + " --send"}));
    Talk talk = lab->talk(0);
    ASSERT_TRUE(talk.wait_until("requests", [&](const auto& lines) {
      return lines.size() == 1 && field(lines[0], "served") == "1";
    })) << mode;
    // A module with the network of the host gets twenty messages meanwhile.
    Process beside(lab->on(0, {program("geminga-subscribe"), "--text", "shot-" + mode, "--mode", mode, "--listen"}));
    ASSERT_TRUE(beside.wait_for("frame-")) << beside.said() << publish.said();
    const std::string said = beside.said();
    const int first = std::stoi(said.substr(said.rfind("frame-") + 6));
    EXPECT_TRUE(beside.wait_for("frame-" + std::to_string(first + 20))) << beside.said();
    EXPECT_THAT(subscribe.said(), testing::Not(HasSubstr("frame-"))) << mode;
  }
}

TEST_F(WithTheSocketOfTheHost, AModuleThatStatesTheAddressOfTheHostIsReachedByItsNeighbours) {
  Process publish(
      inside("geminga-publish", {"--text", "map", "--mode", "oto", "--port", "5002", "--address", lab->address_of(0)}));
  Process unstated(inside("geminga-publish", {"--text", "log", "--mode", "oto", "--port", "5003"}));
  Process subscribe(inside("geminga-subscribe", {"--text", "map", "--mode", "oto"}));
  EXPECT_TRUE(subscribe.wait_for(lab->address_of(0) + ":5002")) << subscribe.said();
  Process loopback(inside("geminga-subscribe", {"--text", "log", "--mode", "oto"}));
  EXPECT_TRUE(loopback.wait_for("127.0.0.1:5003"))
      << "the daemon takes both for programs of one host: " << loopback.said();
}

TEST(OverATunnel, HostsMeetThatNameEachOtherWithoutMulticast) {
  Lab lab(2);
  if (!lab.has_namespaces() || !Tunnel::can_be_made()) GTEST_SKIP() << "this needs network namespaces and /dev/net/tun";
  const Tunnel tunnel(lab, 0, 1);
  // The tunnel alone joins them.
  lab.start(0, {"--interval", "0.1", "--interface", "tun0", "--peer", Tunnel::address_of(1)});
  lab.start(1, {"--interval", "0.1", "--interface", "tun0", "--peer", Tunnel::address_of(0)});
  EXPECT_TRUE(lab.wait_for_participants(0, 2)) << lab.daemon(0).said();
  EXPECT_TRUE(lab.wait_for_participants(1, 2)) << lab.daemon(1).said();
  // More than one datagram: what has the size that is allowed fits an MTU of 1280.
  Talk provider = lab.talk(0);
  for (int number = 1; number <= 60; ++number) {
    provider.say(std::to_string(number) + " pub create mode=oto text=service-of-a-long-name-" + std::to_string(number) +
                 " port=" + std::to_string(6000 + number));
  }
  Talk consumer = lab.talk(1);
  consumer.say("1 sub create mode=otm/stream text=nothing");
  EXPECT_TRUE(consumer.wait_until("services", [](const auto& lines) { return lines.size() == 60; }));
  EXPECT_THAT(consumer.query("services"), testing::Each(HasSubstr("address=" + Tunnel::address_of(0))));
}

}  // namespace
}  // namespace geminga::system
