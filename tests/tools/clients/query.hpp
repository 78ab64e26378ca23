// A real daemon with a peer that offers and asks, for tests of geminga-query.
#ifndef GEMINGA_TESTS_TOOLS_CLIENTS_QUERY_HPP
#define GEMINGA_TESTS_TOOLS_CLIENTS_QUERY_HPP

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <string>
#include <vector>

#include "tools/clients/bench.hpp"

namespace geminga::tools {

/// Two services of a ball, a request for one of them, and a request that no service meets.
class Query : public testing::Test {
 protected:
  Query() {
    peer_.say("0 sys hello name=vision");
    peer_.say(
        "1 pub create mode=otm/stream concept=soccer:SharedBallInfo port=5000 priority=3 rate=30 lens=\"wide angle\"");
    peer_.say("2 pub create mode=oto text=lonely port=5001 address=10.0.0.9");
    peer_.say("3 sub create mode=otm/stream concept=soccer:TrackedObject where=\"rate > 10\"");
    peer_.say("4 sub create mode=oto id=77");
    EXPECT_TRUE(peer_.line_with({"3 pub add"}));
    EXPECT_THAT(peer_.lines_until_pong(), testing::IsEmpty());
  }

  std::string word(const std::vector<std::string>& query, const char* key) {
    return bench_.json(query).at(0).at(key).as_string().c_str();
  }

  Bench bench_;
  Talk peer_ = bench_.talk();
};

}  // namespace geminga::tools

#endif
