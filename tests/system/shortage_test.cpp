// Real daemons for which memory or descriptors end: they say so, shed strangers, and go on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/close_range.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <string>

#include "base/text.hpp"
#include "discovery/announcement/codec.hpp"
#include "support/lab.hpp"
#include "system/folder.hpp"
#include "system/stranger.hpp"

namespace geminga::system {
namespace {

using testing::HasSubstr;

/// The octets of address space that a process has.
rlim_t address_space(const Process& process) {
  std::ifstream file("/proc/" + std::to_string(process.pid()) + "/statm");
  rlim_t pages = 0;
  file >> pages;
  return pages * 4096;
}

void limit(const Process& process, __rlimit_resource resource, rlim_t value) {
  const rlimit both{.rlim_cur = value, .rlim_max = value};
  ASSERT_EQ(::prlimit(process.pid(), resource, &both, nullptr), 0);
}

/// A state of a participant that nobody has heard of, with as many services as a datagram holds.
std::string stranger_state(std::uint32_t number) {
  announcement::Announcement state;
  state.kind = announcement::Kind::state;
  state.participant = ParticipantId{0x10000000 + number};
  state.boot = announcement::BootNonce(number + 1);
  state.interval = announcement::max_interval;
  state.sequence = state.revision = 1;
  state.group = "default";
  state.name = "stranger" + std::to_string(number);
  announcement::PeerState peer;
  peer.id = PeerId{1};
  for (std::uint32_t service = 1; service <= 24; ++service) {
    Publication publication;
    publication.identity = TextIdentity{"service " + std::to_string(number) + "." + std::to_string(service)};
    publication.mode = ChannelMode::one_to_many_stream;
    publication.port = 5000;
    peer.publications.push_back({.number = service, .publication = publication});
  }
  state.peers.push_back(std::move(peer));
  const auto datagrams = announcement::encode(state);
  return {reinterpret_cast<const char*>(datagrams.front().data()), datagrams.front().size()};
}

TEST(Shortage, OfMemoryShedsTheNewestStrangersAndNobodyElse) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer ends the process where it cannot map memory, and does not ask operator new's handler";
#endif
  constexpr std::uint32_t most = 1000;
  Lab lab(2);
  lab.start_all({"--interval", "0.1"});
  Talk provider = lab.talk(1);
  provider.say("1 pub create mode=otm/stream text=ball port=5000");
  Talk consumer = lab.talk(0);
  consumer.say("1 sub create mode=otm/stream text=ball");
  ASSERT_TRUE(consumer.line_with({"1 pub add"}));
  Process& daemon = lab.daemon(0);
  limit(daemon, RLIMIT_AS, address_space(daemon) + 8 * 1024 * 1024);
  const Stranger stranger(lab, 1);
  const auto is_short = [&] {
    daemon.listen();
    return daemon.said().find("memory is short") != std::string::npos;
  };
  for (std::uint32_t number = 0; number < most && !is_short(); ++number) {
    ASSERT_TRUE(stranger.send(stranger_state(number)));
    if (number % 8 == 0) (void)consumer.lines_until_pong();
  }
  for (std::uint32_t number = most; number < most + 200; ++number) {
    ASSERT_TRUE(stranger.send(stranger_state(number)));
    if (number % 8 == 0) (void)consumer.lines_until_pong();
  }
  EXPECT_TRUE(is_short()) << daemon.said();
  EXPECT_TRUE(consumer.wait_until("status", [](const auto& lines) {
    const auto kept = lines.empty() ? std::nullopt : base::parse_number<long>(field(lines[0], "memory_kept_back"));
    return kept && *kept >= 2 * 1024 * 1024;
  })) << "it keeps memory back again";
  EXPECT_THAT(consumer.query("participants"), testing::Contains(HasSubstr("name=robot1")));
  provider.say("1 pub remove");
  EXPECT_TRUE(consumer.line_with({"1 pub del", "reason=withdrawn"})) << "it serves as ever";
}

TEST(Shortage, OfDescriptorsAtTheStartIsSaid) {
  const Lab lab(1);
  for (const rlim_t count : {8U, 31U, 32U}) {
    auto start = lab.on(0, {program("gemingad"), "--check-config"});
    start.before = [count, enter = start.before] {
      if (enter) enter();
      const rlimit both{.rlim_cur = count, .rlim_max = count};
      ::setrlimit(RLIMIT_NOFILE, &both);
    };
    const Ran ran = run(start);
    EXPECT_EQ(ran.status, count < 32 ? 2 : 0) << ran.said;
    if (count < 32) {
      EXPECT_THAT(ran.said, HasSubstr("may open " + std::to_string(count) + " files and sockets, and needs 32"));
    }
  }
}

TEST(Shortage, OfDescriptorsIsNoMissingPermission) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "the check of types needs descriptors of its own, and says without them that there is no object";
#endif
  const std::string file = shipped("core.ttl");
  const auto before = [] {
    ::close_range(3, ~0U, CLOSE_RANGE_CLOEXEC);  // whatever the test has inherited
    const rlimit both{.rlim_cur = 4, .rlim_max = 4};
    ::setrlimit(RLIMIT_NOFILE, &both);
  };
  const Ran ran = run({.words = {program("geminga-ontology"), "check", file}, .environment = {}, .before = before});
  EXPECT_THAT(ran.said, testing::Not(HasSubstr("Permission denied")));
  if (ran.status == 0) GTEST_SKIP() << "this kernel has no Landlock, whose rules take a descriptor";
  EXPECT_EQ(ran.status, 2);
  EXPECT_THAT(ran.said, HasSubstr(": cannot be opened: Too many open files"));
}

}  // namespace
}  // namespace geminga::system
