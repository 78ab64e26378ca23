#include "env/asio/virtual_links.hpp"

#include <linux/if_link.h>
#include <linux/netlink.h>
#include <linux/rtnetlink.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <vector>

#include "env/asio/descriptor.hpp"

namespace geminga::env {
namespace {

/// A datagram of a dump is at most this long where the reader offers no more (netlink(7)).
constexpr std::size_t max_answer_bytes = std::size_t{32} * 1024;
/// Datagrams of one answer. A host with a thousand interfaces needs some sixty.
constexpr int max_answers = 4096;

std::string last_error() { return std::generic_category().message(errno); }

bool has_kind(std::span<const std::byte> attributes) {
  while (attributes.size() >= sizeof(rtattr)) {
    rtattr header{};
    std::memcpy(&header, attributes.data(), sizeof header);
    if (header.rta_len < sizeof header || header.rta_len > attributes.size()) return false;
    const auto content = attributes.subspan(sizeof header, header.rta_len - sizeof header);
    const int type = header.rta_type & NLA_TYPE_MASK;
    if (type == IFLA_LINKINFO) {
      rtattr inner{};
      if (content.size() < sizeof inner) return false;
      std::memcpy(&inner, content.data(), sizeof inner);
      return (inner.rta_type & NLA_TYPE_MASK) == IFLA_INFO_KIND;
    }
    const std::size_t length = RTA_ALIGN(header.rta_len);
    if (length >= attributes.size()) return false;
    attributes = attributes.subspan(length);
  }
  return false;
}

}  // namespace

bool add_virtual_links(std::span<const std::byte> answer, std::set<InterfaceIndex>& found) {
  while (answer.size() >= sizeof(nlmsghdr)) {
    nlmsghdr header{};
    std::memcpy(&header, answer.data(), sizeof header);
    if (header.nlmsg_len < sizeof header || header.nlmsg_len > answer.size()) return false;
    if (header.nlmsg_type == NLMSG_DONE || header.nlmsg_type == NLMSG_ERROR) return false;
    const auto content = answer.subspan(sizeof header, header.nlmsg_len - sizeof header);
    if (header.nlmsg_type == RTM_NEWLINK && content.size() >= NLMSG_ALIGN(sizeof(ifinfomsg))) {
      ifinfomsg link{};
      std::memcpy(&link, content.data(), sizeof link);
      if (has_kind(content.subspan(NLMSG_ALIGN(sizeof link)))) {
        found.insert(InterfaceIndex{static_cast<std::uint32_t>(link.ifi_index)});
      }
    }
    const std::size_t length = NLMSG_ALIGN(header.nlmsg_len);
    if (length >= answer.size()) return true;
    answer = answer.subspan(length);
  }
  return true;
}

std::expected<std::set<InterfaceIndex>, std::string> virtual_links() {
  const Descriptor socket(::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_ROUTE));
  if (socket.get() < 0) return std::unexpected(last_error());
  struct {
    nlmsghdr header;
    ifinfomsg link;
  } request{};
  request.header.nlmsg_len = sizeof request;
  request.header.nlmsg_type = RTM_GETLINK;
  request.header.nlmsg_flags = NLM_F_REQUEST | NLM_F_DUMP;
  if (::send(socket.get(), &request, sizeof request, 0) < 0) return std::unexpected(last_error());
  std::set<InterfaceIndex> found;
  std::vector<std::byte> buffer(max_answer_bytes);
  for (int count = 0; count < max_answers; ++count) {
    const ssize_t size = ::recv(socket.get(), buffer.data(), buffer.size(), 0);
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) return std::unexpected(last_error());
    if (!add_virtual_links(std::span(buffer).first(static_cast<std::size_t>(size)), found)) break;
  }
  return found;
}

}  // namespace geminga::env
