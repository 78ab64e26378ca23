// Messages that wait: by the vectors of all languages (tests/client/vectors/inbox.tsv), and at the limits.
#include "client/protocol/inbox.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace geminga::client {
namespace {

/// The message of `LIFE:SEQUENCE:MISSED`.
Message message_of(const std::string& word) {
  std::istringstream in(word);
  std::uint64_t life = 0;
  Message message;
  char colon = 0;
  in >> life >> colon >> message.sequence >> colon >> message.missed;
  message.life = Life{life};
  return message;
}

std::string taken_from(Inbox& inbox) {
  const auto message = inbox.take();
  if (!message) return {};
  return std::to_string(static_cast<std::uint64_t>(message->life)) + ':' + std::to_string(message->sequence) + ':' +
         std::to_string(message->missed);
}

std::vector<std::string> split(const std::string& text, char by) {
  std::vector<std::string> words;
  std::istringstream in(text);
  for (std::string word; std::getline(in, word, by);) words.push_back(word);
  return words;
}

TEST(Inbox, LosesTheEldestDatagramAsInEveryLanguage) {
  std::ifstream file(std::string(GEMINGA_SOURCE_DIR) + "/tests/client/vectors/inbox.tsv");
  int rows = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    ++rows;
    const auto columns = split(line, '\t');
    ASSERT_EQ(columns.size(), 4U) << line;
    Inbox inbox(std::stoul(columns[0]));
    std::vector<std::string> taken;
    std::size_t lost = 0;
    for (const std::string& word : split(columns[1], ' ')) {
      if (word == "-") {
        taken.push_back(taken_from(inbox));
      } else if (word[0] == 's') {
        inbox.put_streamed(message_of(word.substr(1)));
      } else {
        lost += inbox.put_datagram(message_of(word.substr(1)));
      }
    }
    while (!inbox.is_empty()) taken.push_back(taken_from(inbox));
    EXPECT_EQ(taken, split(columns[2], ' ')) << line;
    EXPECT_EQ(lost, std::stoul(columns[3])) << line;
  }
  EXPECT_GE(rows, 10);
}

TEST(Inbox, IsFullAtEitherLimit) {
  Inbox many;
  for (std::size_t i = 0; i < max_waiting_messages; ++i) {
    EXPECT_FALSE(many.is_full());
    EXPECT_EQ(many.put_datagram({}), 0U);
  }
  EXPECT_TRUE(many.is_full());
  EXPECT_EQ(many.put_datagram({}), 1U);
  EXPECT_TRUE(many.take());
  EXPECT_FALSE(many.is_full());

  Inbox large;
  large.put_streamed({Life{1}, 1, 0, std::vector<std::byte>(max_waiting_octets - 1)});
  EXPECT_FALSE(large.is_full());
  large.put_streamed({Life{1}, 2, 0, std::vector<std::byte>(1)});
  EXPECT_TRUE(large.is_full());
}

TEST(Inbox, LosesAsManyDatagramsAsOneMoreNeeds) {
  Inbox inbox;
  for (const std::uint64_t sequence : {1U, 2U}) {
    EXPECT_EQ(inbox.put_datagram({Life{1}, sequence, 0, std::vector<std::byte>(max_waiting_octets / 2)}), 0U);
  }
  EXPECT_EQ(inbox.put_datagram({Life{1}, 3, 0, std::vector<std::byte>(1)}), 1U);
  EXPECT_EQ(taken_from(inbox), "1:2:1");
}

TEST(Inbox, RemembersWhatWasLostOfSoManyLives) {
  for (const std::size_t lives : {max_remembered_lives - 1, max_remembered_lives, max_remembered_lives + 1}) {
    Inbox inbox(1);
    for (std::uint64_t life = 1; life <= lives + 1; ++life) inbox.put_datagram({Life{life}, 1, 0, {}});
    inbox.put_datagram({Life{1}, 2, 0, {}});
    EXPECT_EQ(taken_from(inbox), lives >= max_remembered_lives ? "1:2:0" : "1:2:1") << lives;
  }
}

}  // namespace
}  // namespace geminga::client
