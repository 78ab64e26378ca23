// Multicasts on one interface: sends that fail.
#include "env/asio/multicast.hpp"

#include <gtest/gtest.h>

#include <cerrno>
#include <vector>

#include "env/asio/links.hpp"

namespace geminga::env {
namespace {

TEST(MulticastLink, ForgetsAFailureThatItWasAskedFor) {
  boost::asio::io_context context;
  AirCounts counts;
  const auto scan = scan_links({"lo"});
  ASSERT_TRUE(scan);
  const auto& links = scan->links;
  ASSERT_FALSE(links.empty());
  MulticastLink link(context, links.front(), {boost::asio::ip::make_address("239.192.47.17")}, 4717, counts,
                     [](const auto&, auto) {});
  EXPECT_FALSE(link.take_failure());
  const std::vector<std::byte> too_long(65'536);
  link.send(too_long);
  EXPECT_EQ(link.last_send_error(), EMSGSIZE);
  link.send(std::vector<std::byte>(1));
  EXPECT_EQ(link.last_send_error(), 0);
  EXPECT_TRUE(link.take_failure()) << "the look that may mend it is not due yet";
  link.send(too_long);
  EXPECT_TRUE(link.take_failure());
  EXPECT_FALSE(link.take_failure()) << "nothing was said since";
}

}  // namespace
}  // namespace geminga::env
