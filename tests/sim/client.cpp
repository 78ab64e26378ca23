#include "sim/client.hpp"

#include "discovery/gcnp/channel_keyring.hpp"
#include "sim/host.hpp"
#include "sim/world.hpp"

namespace geminga::sim {

void Client::connect(Host& host) { host.connect(*this); }

void Client::connected(Host& host, env::StreamId stream) {
  host_ = &host;
  stream_ = stream;
  unfinished_.clear();
  participant_.clear();
  peer_.clear();
  views_.clear();
}

void Client::say(std::string_view line) {
  const auto statement = gcnp::parse(line);
  // Whoever takes a request back is not told that what it had is gone.
  if (statement && statement->subcommand == "remove") views_.erase(statement->id);
  send_bytes(std::string(line) + "\r\n");
}

void Client::send_bytes(std::string bytes) {
  if (host_ != nullptr) host_->connections().from_client(stream_, std::move(bytes));
}

void Client::set_reading(bool is_reading) {
  if (host_ != nullptr) host_->connections().set_reading(stream_, is_reading);
}

void Client::read(std::size_t octets) {
  if (host_ != nullptr) host_->connections().read(stream_, octets);
}

std::size_t Client::unread() const { return host_ == nullptr ? 0 : host_->unsent(stream_); }

void Client::hang_up() {
  if (host_ == nullptr) return;
  host_->connections().client_closed(stream_);
  host_ = nullptr;
}

void Client::connection_lost() {
  host_ = nullptr;
  world_.trace(name_, "lost");
  if (on_lost) on_lost();
}

void Client::closed_by_host(env::StreamId stream) {
  if (host_ != nullptr && stream == stream_) connection_lost();
}

void Client::receive(env::StreamId stream, std::string_view bytes) {
  if (stream != stream_) return;
  unfinished_.append(bytes);
  std::size_t begin = 0;
  for (std::size_t end = 0; (end = unfinished_.find("\r\n", begin)) != std::string::npos; begin = end + 2) {
    const std::string line = unfinished_.substr(begin, end - begin);
    const auto statement = gcnp::parse(line);
    // An error line ends in free text, which need not be a statement.
    const gcnp::Statement read = statement ? *statement : gcnp::Statement{};
    if (statement) check(line, read);
    if (keeps_lines) lines.push_back(line);
    if (on_line) on_line(line, read);
  }
  unfinished_.erase(0, begin);
}

void Client::check(std::string_view line, const gcnp::Statement& statement) {
  if (statement.command == "msg" && statement.subcommand == "hello") {
    participant_ = statement.value("participant").value_or("");
    peer_ = statement.value("peer").value_or("");
  }
  if (statement.command != "pub" && statement.command != "sub") return;
  if (statement.subcommand == gcnp::keys_subcommand) return;
  const auto complain = [&](const std::string& what) {
    world_.complain("events: " + what + " to " + name_ + ": " + std::string(line) + ",");
  };
  const auto key = statement.value(statement.command == "pub" ? "service" : "subscription");
  if (!key) return complain("said without its service");
  View& view = views_[statement.id];
  const auto known = view.find(*key);
  if (statement.subcommand == "add") {
    if (known != view.end()) complain("told twice");
    view.insert_or_assign(std::string(*key), statement);
  } else if (statement.subcommand == "modify") {
    if (known == view.end()) return complain("changed without having been told");
    known->second = statement;
  } else {
    if (statement.subcommand != "del") complain("neither add, modify nor del");
    if (known == view.end()) return complain("gone without having been told");
    view.erase(known);
  }
}

const Client::View& Client::view(std::uint32_t request) const {
  static const View nothing;
  const auto found = views_.find(request);
  return found == views_.end() ? nothing : found->second;
}

}  // namespace geminga::sim
