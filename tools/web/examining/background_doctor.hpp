// Examines this host and its team while the site answers others.
#ifndef GEMINGA_WEB_EXAMINING_BACKGROUND_DOCTOR_HPP
#define GEMINGA_WEB_EXAMINING_BACKGROUND_DOCTOR_HPP

#include <boost/asio/io_context.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/json/value.hpp>
#include <chrono>
#include <expected>
#include <functional>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "geminga/client.hpp"

namespace geminga::web {

/// The document of an examination, or why there is none. Shared by all who have asked meanwhile.
using Examined = std::shared_ptr<const std::expected<boost::json::value, ClientError>>;

/// The time for which a document is given again. Shorter: fresher findings. Longer: less work for host and daemon.
inline constexpr std::chrono::seconds examination_life{10};

/// One examination at a time, on one thread that does nothing else. Its destructor waits for the end of the examination
/// under way, twelve seconds at most where the daemon answers.
class BackgroundDoctor {
 public:
  using Then = std::function<void(const Examined&)>;

  /// Answers on the thread of `context`, which must outlive this. `connection` leads to the daemon;
  /// `version` is that of this program, in static storage.
  BackgroundDoctor(boost::asio::io_context& context, ClientOptions connection, std::string_view version)
      : context_(context), connection_(std::move(connection)), version_(version) {}
  ~BackgroundDoctor() { thread_.join(); }
  BackgroundDoctor(const BackgroundDoctor&) = delete;
  BackgroundDoctor& operator=(const BackgroundDoctor&) = delete;

  /// Calls `then` once, at once where a document is no older than examination_life.
  void ask(Then then);

 private:
  void take(const Examined& examined);

  boost::asio::io_context& context_;
  ClientOptions connection_;
  std::string_view version_;
  std::vector<Then> waiting_;
  Examined last_;
  std::chrono::steady_clock::time_point came_{};
  boost::asio::thread_pool thread_{1};
};

}  // namespace geminga::web

#endif
