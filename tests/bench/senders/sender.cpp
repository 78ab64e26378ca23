// Sends for tests/bench/clients: `sender PROTOCOL IDENTITY PORT` offers the text IDENTITY, and says "ready" when it has
// a consumer. Told "library COUNT SIZE" or "plain COUNT SIZE" it sends so many messages to its consumer, or by a plain
// socket to that port of this host, and says how many nanoseconds that took.
#include <arpa/inet.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <string>

#include "geminga/node.hpp"

namespace {

class PlainSocket {
 public:
  PlainSocket(bool is_tcp, std::uint16_t port)
      : is_tcp_(is_tcp), socket_(::socket(AF_INET, is_tcp ? SOCK_STREAM : SOCK_DGRAM, 0)) {
    there_.sin_family = AF_INET;
    there_.sin_port = htons(port);
    there_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (!is_tcp) return;
    const int on = 1;
    if (::connect(socket_, reinterpret_cast<const sockaddr*>(&there_), sizeof there_) != 0) std::exit(1);
    ::setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  }
  ~PlainSocket() { ::close(socket_); }
  PlainSocket(const PlainSocket&) = delete;
  PlainSocket& operator=(const PlainSocket&) = delete;

  void send(const std::string& payload) const {
    if (is_tcp_) {
      (void)!::send(socket_, payload.data(), payload.size(), MSG_NOSIGNAL);
    } else {
      (void)!::sendto(socket_, payload.data(), payload.size(), MSG_NOSIGNAL, reinterpret_cast<const sockaddr*>(&there_),
                      sizeof there_);
    }
  }

 private:
  bool is_tcp_;
  int socket_;
  sockaddr_in there_{};
};

template <typename Send>
long long nanoseconds_of(unsigned count, const Send& send) {
  const auto begin = std::chrono::steady_clock::now();
  for (unsigned i = 0; i < count; ++i) send();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  geminga::ClientOptions options;
  options.name = "sender";
  auto node = geminga::Node::open(options);
  if (!node) return 3;
  geminga::NamedPublication offer;
  offer.identity = geminga::TextIdentity{argv[3]};
  offer.mode = geminga::channel_mode(argv[1]).value_or(geminga::ChannelMode::one_to_one);
  offer.protocol = argv[2];
  auto publisher = node->publish(offer);
  if (!publisher) return 2;
  const PlainSocket plain(offer.protocol == "tcp", static_cast<std::uint16_t>(std::atoi(argv[4])));
  while (publisher->count().sent == 0) {  // nobody tells of the consumers of a stream
    (void)publisher->send("there?");
    node->run_for(std::chrono::milliseconds(10));
  }
  std::cout << "ready\n" << std::flush;
  std::string how;
  unsigned count = 0;
  std::size_t size = 0;
  while (std::cin >> how && how != "quit" && std::cin >> count >> size) {
    const std::string payload(size, 'x');
    const auto took = how == "library" ? nanoseconds_of(count, [&] { (void)publisher->send(payload); })
                                       : nanoseconds_of(count, [&] { plain.send(payload); });
    std::cout << took << '\n' << std::flush;
  }
  return 0;
}
