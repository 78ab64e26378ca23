// A subscriber's TCP connection to one provider, made again while the provider is believed to be there.
#ifndef GEMINGA_CLIENT_CHANNELS_TCP_INLET_HPP
#define GEMINGA_CLIENT_CHANNELS_TCP_INLET_HPP

#include <functional>
#include <random>

#include "client/channels/reactor.hpp"
#include "client/protocol/backoff.hpp"
#include "client/protocol/frame.hpp"
#include "client/protocol/frame_reader.hpp"

namespace geminga::client {

/// Says hello by itself. Neither copies nor moves. What it tells may destroy it as the last thing that happens.
class TcpInlet {
 public:
  struct Told {
    /// A frame; false: nothing more may be read for now, and this one was the last.
    std::function<bool(const Frame&)> frame;
    /// The connection is gone. Where it returns true, it is made again.
    std::function<bool()> lost;
    /// What came was no frame.
    std::function<void()> broken;
  };

  TcpInlet(Reactor& reactor, PeerAddress to, Life own, Told told);
  ~TcpInlet() {
    if (is_destroyed_ != nullptr) *is_destroyed_ = true;
  }
  TcpInlet(const TcpInlet&) = delete;
  TcpInlet& operator=(const TcpInlet&) = delete;

  /// Begins at once.
  void start() { connect(); }
  [[nodiscard]] const PeerAddress& to() const { return to_; }
  /// Whether it is there, and not only tried.
  [[nodiscard]] bool is_connected() const { return is_connected_; }
  /// Reads no more until it is told otherwise.
  void pause(bool is_paused);

 private:
  void connect();
  void on_ready(Reactor::Ready ready);
  void read();
  /// Gives the frames that were read; false where it was paused or destroyed.
  bool give();
  void lose();

  Reactor& reactor_;
  PeerAddress to_;
  Life own_;
  Told told_;
  Socket socket_;
  Reactor::Watch watch_;
  Reactor::Timer retry_;
  Backoff backoff_;
  std::minstd_rand chance_;
  FrameReader reader_;
  bool is_connected_ = false;
  bool is_paused_ = false;
  bool* is_destroyed_ = nullptr;  ///< told to a call that is under way
};

}  // namespace geminga::client

#endif
