#include "web/examining/background_doctor.hpp"

#include <boost/asio/post.hpp>
#include <utility>

#include "doctor/examination.hpp"

namespace geminga::web {
namespace {

std::expected<boost::json::value, ClientError> examined(const ClientOptions& connection, std::string_view version) {
  auto client = Client::connect(connection);
  auto looked = doctor::examine(client, {.version = version, .connect = connection.connect});
  if (!looked) return std::unexpected(std::move(looked.error()));
  return doctor::to_json(*looked);
}

}  // namespace

void BackgroundDoctor::ask(Then then) {
  if (last_ && std::chrono::steady_clock::now() - came_ < examination_life) return then(last_);
  waiting_.push_back(std::move(then));
  if (waiting_.size() > 1) return;  // it is under way
  boost::asio::post(thread_, [this, connection = connection_, version = version_] {
    auto outcome =
        std::make_shared<const std::expected<boost::json::value, ClientError>>(examined(connection, version));
    boost::asio::post(context_, [this, outcome = std::move(outcome)] { take(outcome); });
  });
}

void BackgroundDoctor::take(const Examined& examined) {
  last_ = examined;
  came_ = std::chrono::steady_clock::now();
  for (const Then& then : std::exchange(waiting_, {})) then(examined);
}

}  // namespace geminga::web
