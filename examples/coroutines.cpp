// Two coroutines on one thread: one says where the ball is, ten times a second, the other prints what anybody says.
#include <boost/asio/awaitable.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <cstdlib>
#include <iostream>
#include <string>

#include "geminga/asio.hpp"

namespace asio = boost::asio;

namespace {

asio::awaitable<void> publish(geminga::AsioNode& node, geminga::Publisher& ball) {
  asio::steady_timer timer(node.get_executor());
  while (!ball.has_ended()) {
    const std::string text = "ball " + std::to_string(ball.count().sent + 1);
    co_await node.async_send(ball, text, asio::use_awaitable);
    timer.expires_after(std::chrono::milliseconds(100));
    co_await timer.async_wait(asio::use_awaitable);
  }
}

asio::awaitable<void> subscribe(geminga::AsioNode& node, geminga::Subscriber& balls, geminga::Publisher& ball,
                                unsigned long count) {
  for (unsigned long number = 0; number < count; ++number) {
    const auto message = co_await node.async_receive(balls, asio::use_awaitable);
    std::cout.write(reinterpret_cast<const char*>(message->payload.data()),
                    static_cast<std::streamsize>(message->payload.size()))
        << '\n'
        << std::flush;
  }
  ball.begin_withdraw();
  co_await node.async_close(asio::use_awaitable);
}

}  // namespace

int main(int argc, char** argv) {
  auto node = geminga::Node::open();
  if (!node) {
    std::cerr << "coroutines: " << node.error().text << '\n';
    return 2;
  }
  geminga::NamedPublication offer;
  offer.identity = geminga::ConceptNames{"soccer:BallInfo", ""};
  geminga::NamedSubscription wish;
  wish.identity = geminga::ConceptNames{"soccer:TrackedObject", ""};
  offer.mode = wish.mode = geminga::ChannelMode::one_to_many_pubsub;

  asio::io_context context;
  geminga::AsioNode driven(context.get_executor(), std::move(*node));
  auto ball = driven.node().publish(offer, geminga::Wait::for_nothing);
  auto balls = driven.node().subscribe(wish, {}, geminga::Wait::for_nothing);
  if (!ball || !balls) return 2;
  const unsigned long count = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 1'000'000;
  asio::co_spawn(context, publish(driven, *ball), asio::detached);
  asio::co_spawn(context, subscribe(driven, *balls, *ball, count), [&context](const std::exception_ptr&) {
    context.stop();  // what the publisher waits for does not matter any more
  });
  context.run();
  return 0;
}
