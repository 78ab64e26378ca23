#include "client/cpp/agent_answers.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <set>

#include "base/text.hpp"
#include "client/protocol/frame.hpp"
#include "discovery/gcnp/event.hpp"
#include "discovery/gcnp/statement.hpp"
#include "geminga/identity.hpp"

namespace geminga::agent {
namespace {

int digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/// A key may stand once in a statement. The reader of a request checks that; an answer of the agent is not checked.
bool has_doubled_key(const gcnp::Statement& statement) {
  std::set<std::string_view> keys;
  return !std::ranges::all_of(statement.parameters, [&](const auto& one) { return keys.insert(one.key).second; });
}

}  // namespace

std::string next_word(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  std::size_t end = text.find(' ');
  if (text.starts_with('"')) {
    for (end = 1; end < text.size() && text[end] != '"'; ++end) end += text[end] == '\\' ? 1 : 0;
    end = std::min(end + 1, text.size());
  }
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(word.size());
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  // The grammar knows how a value is written.
  const auto statement = gcnp::parse("0 agent word value=" + std::string(word));
  return std::string(statement ? statement->value("value").value_or("") : word);
}

std::uint64_t number(std::string_view text) { return base::parse_number<std::uint64_t>(text).value_or(0); }

std::string to_hex(std::span<const std::byte> bytes) {
  std::string hex;
  for (const std::byte octet : bytes) hex += base::to_hex(std::to_integer<std::uint64_t>(octet), 2);
  return hex;
}

std::optional<Bytes> from_hex(std::string_view text) {
  if (text.size() % 2 != 0) return std::nullopt;
  Bytes bytes;
  for (std::size_t i = 0; i < text.size(); i += 2) {
    const int high = digit(text[i]);
    const int low = digit(text[i + 1]);
    if (high < 0 || low < 0) return std::nullopt;
    bytes.push_back(static_cast<std::byte>(high * 16 + low));
  }
  return bytes;
}

std::string identity_answer(std::string_view words) {
  const std::string kind = next_word(words);
  Identity identity = TextIdentity{std::string(words)};
  if (kind == "number") identity = NumericIdentity{static_cast<Id32>(number(words))};
  if (kind == "concept" || kind == "expression") {
    // An expression has spaces, too; its last word is a representation unless it closes a bracket of the expression.
    const auto space = words.ends_with(')') ? std::string_view::npos : words.rfind(' ');
    const auto representation = space == std::string_view::npos ? "" : words.substr(space + 1);
    identity = SemanticIdentity{std::string(words.substr(0, space)), std::string(representation)};
  }
  return "identity " + std::to_string(id32(identity));
}

std::string frame_answer(std::string_view hex) {
  const auto bytes = from_hex(hex);
  const auto frame = bytes ? client::read_frame(*bytes) : std::nullopt;
  if (!frame || frame->form != client::FrameForm::plain) return "frame refused";
  constexpr std::array<const char*, 5> kinds{"message", "hello", "end", "floor", "full"};
  return std::string("frame ") + kinds.at(static_cast<std::size_t>(frame->kind) - 1) + ' ' + to_string(frame->life) +
         ' ' + std::to_string(frame->sequence) + ' ' + to_hex(frame->payload);
}

std::string line_answer(std::string_view line) {
  std::string written;
  const auto reply = gcnp::read_reply(line);
  const auto* event = reply ? std::get_if<Event>(&*reply) : nullptr;
  const auto* error = event == nullptr ? nullptr : std::get_if<Error>(&event->what);
  if (error != nullptr) {
    written = gcnp::to_line(event->request, *error);
  } else if (const auto statement = gcnp::parse(line); statement && !has_doubled_key(*statement)) {
    written = gcnp::to_line(*statement);
  } else {
    return "line refused";
  }
  return "line " + written.substr(0, written.size() - 2);
}

}  // namespace geminga::agent
