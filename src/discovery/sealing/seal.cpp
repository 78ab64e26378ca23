#include "discovery/sealing/seal.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/assert.hpp"

namespace geminga::sealing {
namespace {

constexpr std::array<std::pair<std::string_view, Mode>, 5> modes{{{"plain", Mode::plain},
                                                                  {"prepared", Mode::prepared},
                                                                  {"mixed", Mode::mixed},
                                                                  {"authenticated", Mode::authenticated},
                                                                  {"encrypted", Mode::encrypted}}};

}  // namespace

std::string_view to_string(Mode mode) { return modes.at(static_cast<std::size_t>(mode)).first; }

std::optional<Mode> read_mode(std::string_view word) {
  const auto* const found = std::ranges::find(modes, word, [](const auto& pair) { return pair.first; });
  return found == modes.end() ? std::nullopt : std::optional(found->second);
}

Seal::Seal(RandomBits random_bits) : random_bits_(std::move(random_bits)) {}

void Seal::adopt(const Policy& policy, base::Instant now) {
  GEMINGA_ASSERT(policy.keys.is_empty() == (policy.mode == Mode::plain));
  const Policy before = std::exchange(policy_, policy);
  // A participant in mode `prepared` sends nothing sealed, so nobody could prove anything to it.
  const bool is_proof_lost = !before.keys.is_within(policy_.keys) || before.mode == Mode::prepared;
  if (is_proof_lost) {
    sessions_.clear();
    sealers_.clear();
  }
  if (policy_.mode == Mode::plain) return;
  if (!compression_) compression_ = std::make_unique<Compression>();
  if (before.mode <= Mode::prepared) {
    begin_session(now);
  } else if (is_proof_lost) {
    challenges_.renew(Challenge(random_bits_()));
  }
}

void Seal::begin_session(base::Instant now) {
  session_ = Session(random_bits_());
  counter_ = 0;
  challenges_.begin(session_, Challenge(random_bits_()), now);
}

std::span<const std::byte> Seal::seal(std::span<const std::byte> text, env::InterfaceIndex interface,
                                      base::Instant now) {
  GEMINGA_ASSERT(text.size() <= max_text_bytes);
  if (!is_sealing()) return text;
  if (counter_ == std::numeric_limits<std::uint32_t>::max()) begin_session(now);  // no nonce is ever used twice
  const std::size_t compressed = compression_->compress(text, compressed_);
  if (compressed > 0) text = std::span(compressed_).first(compressed);
  const Greeting greeting = challenges_.greeting(interface, policy_.keys, max_text_bytes - text.size(), now);
  const std::size_t greeted = greeting.is_empty() ? 0 : write_greeting(greeting, greeted_);
  std::copy_n(text.data(), text.size(), greeted_.data() + greeted);
  const Header header = next_header(greeted > 0, compressed > 0);
  const std::size_t size =
      sealing::seal(policy_.keys.first(), header, std::span(greeted_).first(greeted + text.size()), said_);
  return std::span(said_).first(size);
}

std::span<const std::byte> Seal::seal_kept(std::span<const std::byte> text, base::Instant now) {
  GEMINGA_ASSERT(is_sealing() && text.size() <= max_text_bytes);
  if (counter_ == std::numeric_limits<std::uint32_t>::max()) begin_session(now);
  return std::span(said_).first(sealing::seal(policy_.keys.first(), next_header(false, false), text, said_));
}

Header Seal::next_header(bool has_greeting, bool is_compressed) {
  return {.protection = policy_.mode == Mode::authenticated ? Protection::authenticated : Protection::encrypted,
          .has_greeting = has_greeting,
          .is_compressed = is_compressed,
          .key = policy_.keys.first().id(),
          .session = session_,
          .counter = counter_++};
}

std::expected<Opened, Rejection> Seal::open(std::span<const std::byte> datagram, const Arrival& arrival) {
  Outcome outcome;
  const auto opened = [&]() -> std::expected<Opened, Rejection> {
    if (is_sealed(datagram)) return open_sealed(datagram, arrival, outcome);
    if (!hears_plain()) return std::unexpected(Rejection::plain);
    return Opened{.text = datagram};
  }();
  if (!opened) outcome.rejection = opened.error();
  // An unsealed datagram is entered by attribute(), which may still reject it.
  const bool is_counted =
      opened ? opened->session.has_value() : opened.error() != Rejection::own && opened.error() != Rejection::copied;
  if (is_counted) ledger_.enter(outcome, arrival);
  return opened;
}

std::expected<Opened, Rejection> Seal::open_sealed(std::span<const std::byte> datagram, const Arrival& arrival,
                                                   Outcome& outcome) {
  if (datagram.size() > env::max_datagram_bytes) return std::unexpected(Rejection::too_large);
  const auto header = read_header(datagram);
  if (!header) return std::unexpected(header.error());
  outcome.protection = header->protection;
  outcome.key = header->key;
  const Key* key = policy_.keys.find(header->key);
  if (key == nullptr) return std::unexpected(Rejection::unknown_key);
  if (is_sealing() && header->session == session_) {
    look_at_own(*header, datagram, arrival);
    return std::unexpected(Rejection::own);
  }
  KnownSession* known = sessions_.find(header->session);
  const bool is_heard = known != nullptr && !known->window.is_open(arrival.interface, header->counter, arrival.now);
  if (is_heard && !known->window.is_copy(arrival.interface, header->counter, arrival.is_alone)) {
    return std::unexpected(Rejection::replayed);
  }
  auto content = this->content(*key, *header, datagram);
  if (!content) return std::unexpected(content.error());
  if (is_heard) {
    known->window.take_copy(arrival.interface, header->counter, arrival.is_alone);
    return std::unexpected(Rejection::copied);
  }
  Read read{.header = *header, .greeting = std::move(content->greeting)};
  read.had_room = datagram.size() + greeting_bytes(max_keys, false, 0, 0) <= env::max_datagram_bytes;
  if (!admit(read, arrival)) return std::unexpected(Rejection::unproved);
  const auto text = expanded(*header, content->text);
  if (!text) return std::unexpected(text.error());
  return Opened{
      .text = *text, .protection = header->protection, .session = header->session, .counter = header->counter};
}

std::expected<Opened, Rejection> Seal::open_vouched(std::span<const std::byte> word) {
  if (!is_sealed(word)) {
    if (policy_.mode != Mode::plain) return std::unexpected(Rejection::plain);
    return Opened{.text = word};
  }
  const auto header = read_header(word);
  if (!header) return std::unexpected(header.error());
  const Key* key = policy_.keys.find(header->key);
  if (key == nullptr) return std::unexpected(Rejection::unknown_key);
  if (is_sealing() && header->session == session_) return std::unexpected(Rejection::own);
  auto content = this->content(*key, *header, word);
  if (!content) return std::unexpected(content.error());
  const auto text = expanded(*header, content->text);
  if (!text) return std::unexpected(text.error());
  return Opened{
      .text = *text, .protection = header->protection, .session = header->session, .counter = header->counter};
}

std::expected<Seal::Content, Rejection> Seal::content(const Key& key, const Header& header,
                                                      std::span<const std::byte> datagram) {
  const auto size = sealing::open(key, header, datagram, heard_);
  if (!size) return std::unexpected(size.error());
  Content content{.text = std::span(heard_).first(*size)};
  if (!header.has_greeting) return content;
  auto greeting = read_greeting(content.text);
  if (!greeting) return std::unexpected(greeting.error());
  content.greeting = std::move(greeting->greeting);
  content.text = content.text.subspan(greeting->size);
  return content;
}

std::expected<std::span<const std::byte>, Rejection> Seal::expanded(const Header& header,
                                                                    std::span<const std::byte> text) {
  if (!header.is_compressed) return text;
  const auto size = compression_->expand(text, expanded_);
  if (!size) return std::unexpected(size.error());
  return std::span<const std::byte>(expanded_).first(*size);
}

/// Whether a datagram sealed with one of our keys is to be heard: it is neither a copy nor a recording.
bool Seal::admit(const Read& read, const Arrival& arrival) {
  const Header& header = read.header;
  const Greeting& greeting = read.greeting;
  if (is_sealing()) challenges_.hear(greeting, header.session, arrival.interface, arrival.now);
  KnownSession* known = sessions_.find(header.session);
  if (known == nullptr) {
    if (is_sealing() && !challenges_.is_proof(greeting)) {
      challenges_.ask(header.session, arrival.interface, arrival.now);
      return false;
    }
    challenges_.settle(header.session);
    if (sessions_.add(
            header.session,
            {ReplayWindow(arrival.interface, header.counter, arrival.now, arrival.is_alone), {}, {}, {}, {}})) {
      challenges_.renew(Challenge(random_bits_()));
    }
    known = sessions_.find(header.session);
  } else {
    known->window.take(arrival.interface, header.counter, arrival.now, arrival.is_alone);
  }
  known->heard = arrival.now;
  known->protection = header.protection;
  known->key = header.key;
  // A sender with several keys names them in each datagram that has room for them.
  if (!greeting.keys.empty() || read.had_room) known->keys = greeting.keys;
  return true;
}

/// If a running process was copied (a virtual machine, say), both copies go on with one session. The one that hears
/// that begins another: no nonce may be used twice.
void Seal::look_at_own(const Header& header, std::span<const std::byte> datagram, const Arrival& arrival) {
  if (header.counter < counter_) return;
  if (sealing::open(*policy_.keys.find(header.key), header, datagram, heard_)) begin_session(arrival.now);
}

bool Seal::attribute(const Opened& opened, ParticipantId participant, const Arrival& arrival) {
  if (opened.session) {
    if (sealers_.size() >= max_sessions) sealers_.clear();
    sealers_.insert_or_assign(participant, *opened.session);
    return true;
  }
  Outcome outcome;
  if (const auto sealing = sealing_of(participant)) {
    if (arrival.now - sealing->heard < sealed_memory) outcome.rejection = Rejection::downgraded;
  }
  ledger_.enter(outcome, arrival);
  return !outcome.rejection;
}

void Seal::reject_unreadable(const Opened& opened, const Arrival& arrival) {
  if (!opened.session) ledger_.enter({Protection::plain, std::nullopt, Rejection::unreadable}, arrival);
}

std::optional<Sealing> Seal::sealing_of(ParticipantId participant) const {
  const auto sealer = sealers_.find(participant);
  if (sealer == sealers_.end()) return std::nullopt;
  const KnownSession* known = sessions_.find(sealer->second);
  if (known == nullptr) return std::nullopt;
  Sealing sealing{known->protection, known->key, known->keys, known->heard};
  if (sealing.keys.empty()) sealing.keys = {known->key};
  return sealing;
}

}  // namespace geminga::sealing
