// The greeting of a sealed datagram, at each limit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "discovery/sealing/rig.hpp"

namespace geminga::sealing {
namespace {

Octets written(const Greeting& greeting) {
  Octets octets(max_greeting_bytes);
  octets.resize(write_greeting(greeting, octets));
  return octets;
}

Greeting largest() {
  Greeting greeting{.calls_everybody = true, .challenge = Challenge(1)};
  greeting.keys.assign(max_keys, KeyId(2));
  greeting.asked.assign(max_asked, SessionTag(3));
  greeting.echoes.assign(max_echoes, Challenge(4));
  return greeting;
}

TEST(Greeting, ComesBackAsItWasWritten) {
  const Greeting some{.keys = {KeyId(0xabcd), KeyId(1)},
                      .challenge = Challenge(0x0102030405060708),
                      .asked = {SessionTag(0xffff)},
                      .echoes = {Challenge(~std::uint64_t{0}), Challenge(0)}};
  for (const Greeting& greeting : {Greeting{}, some, largest()}) {
    Octets octets = written(greeting);
    const std::size_t size = octets.size();
    octets.push_back(std::byte{9});  // the announcement behind it
    const auto read = read_greeting(octets);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->greeting, greeting);
    EXPECT_EQ(read->size, size);
  }
  EXPECT_EQ(written(largest()).size(), max_greeting_bytes);
}

TEST(Greeting, IsMalformedWhereAnythingOfItIsMissing) {
  const Octets octets = written(largest());
  for (std::size_t size = 0; size < octets.size(); ++size) {
    EXPECT_FALSE(read_greeting(std::span(octets).first(size))) << size;
  }
}

TEST(Greeting, IsMalformedOverEachLimitAndNotAtIt) {
  Octets octets = written(largest());
  octets.resize(4096);
  const auto with = [&](std::size_t at, std::size_t number) {
    Octets changed = octets;
    changed.at(at) = static_cast<std::byte>(number);
    return read_greeting(changed).has_value();
  };
  constexpr std::size_t flags = 0xc0;
  for (const std::size_t more : {std::size_t{0}, std::size_t{1}}) {
    const bool is_fine = more == 0;
    EXPECT_EQ(with(0, flags | (max_keys + more)), is_fine);
    EXPECT_EQ(with(1, max_asked + more), is_fine);
    EXPECT_EQ(with(2, max_echoes + more), is_fine);
  }
}

TEST(Greeting, IsMalformedWithUnknownBitsOrAQuestionWithoutAChallenge) {
  for (const Octets& octets : {octets_of(std::string("\x10\0\0", 3)), octets_of(std::string("\x20\0\0", 3)),
                               octets_of(std::string("\x80\0\0", 3)), octets_of(std::string("\0\1\0\0\0", 5))}) {
    const auto read = read_greeting(octets);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error(), Rejection::malformed);
  }
}

}  // namespace
}  // namespace geminga::sealing
