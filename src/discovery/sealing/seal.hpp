// The seal between a participant and the air: seals what it says, and lets through what the team has said.
#ifndef GEMINGA_DISCOVERY_SEALING_SEAL_HPP
#define GEMINGA_DISCOVERY_SEALING_SEAL_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "discovery/sealing/challenges.hpp"
#include "discovery/sealing/compression.hpp"
#include "discovery/sealing/envelope.hpp"
#include "discovery/sealing/key.hpp"
#include "discovery/sealing/ledger.hpp"
#include "discovery/sealing/sessions.hpp"
#include "geminga/service.hpp"

namespace geminga::sealing {

/// The mode: how a participant sends and what it hears. A team goes from `plain` to `encrypted` by way of the two in
/// between.
enum class Mode : std::uint8_t {
  plain,          ///< there are no keys: nothing is sealed
  prepared,       ///< sends unsealed, hears both
  mixed,          ///< sends encrypted, hears both
  authenticated,  ///< sends what everybody can read, hears only sealed datagrams
  encrypted,      ///< sends encrypted, hears only sealed datagrams
};
/// "plain", "prepared", ... Static storage.
[[nodiscard]] std::string_view to_string(Mode mode);
/// The mode of this word, or nothing.
[[nodiscard]] std::optional<Mode> read_mode(std::string_view word);

/// `keys` are empty if the mode is plain, and only then.
struct Policy {
  Mode mode = Mode::plain;
  Keyring keys{};
  friend bool operator==(const Policy&, const Policy&) = default;
};

/// The largest announcement, also after expanding a compressed one.
inline constexpr std::size_t max_text_bytes = env::max_datagram_bytes - env::max_envelope_bytes;

/// A datagram that may be decoded.
struct Opened {
  std::span<const std::byte> text;  ///< borrowed until the next call
  Protection protection = Protection::plain;
  std::optional<Session> session{};  ///< present unless it is plain
  std::uint32_t counter = 0;         ///< of a sealed one: which datagram of its session it is
};

/// How a participant of the team seals.
struct Sealing {
  Protection protection{};
  KeyId key{};
  std::vector<KeyId> keys;  ///< keys that it opens with, the one that it seals with included
  base::Instant heard{};
};

class Seal {
 public:
  /// Gives 64 unpredictable bits; called only if there are keys.
  using RandomBits = std::function<std::uint64_t()>;
  explicit Seal(RandomBits random_bits);

  /// Sets the policy. If a key was taken away, everybody must prove itself anew, since a holder of that key may have
  /// spoken in anybody's name.
  void adopt(const Policy& policy, base::Instant now);
  [[nodiscard]] const Policy& policy() const { return policy_; }

  /// The datagram to send for this announcement on this interface, borrowed until the next call and from `text`.
  /// Requires that the text has at most max_text_bytes octets.
  [[nodiscard]] std::span<const std::byte> seal(std::span<const std::byte> text, env::InterfaceIndex interface,
                                                base::Instant now);
  /// The envelope of a text that a server keeps (SEALING.md, "Kept words"), in the same session, without greeting: who
  /// opens it later owes nothing. Borrowed until the next call. Requires that we seal, and at most max_text_bytes
  /// octets.
  [[nodiscard]] std::span<const std::byte> seal_kept(std::span<const std::byte> text, base::Instant now);
  /// The text of a datagram, if it is to be heard. Takes bytes from anywhere; a forged datagram costs less than 1 us.
  [[nodiscard]] std::expected<Opened, Rejection> open(std::span<const std::byte> datagram, const Arrival& arrival);
  /// The text of a word that a relay has passed on (SEALING.md, "Relayed words"). The relay's own datagram was opened
  /// before, so it vouches for the word's session, which need not have proved itself to us. A plain word
  /// is given only in mode plain: nobody can vouch for who said it. The greeting is not answered, and nothing is
  /// entered into the ledger. Whether the word is new is for VouchedWords to say.
  [[nodiscard]] std::expected<Opened, Rejection> open_vouched(std::span<const std::byte> word);
  /// Tells which participant said what was opened last. False: it is not to be heard, since that participant seals, and
  /// this was not sealed.
  [[nodiscard]] bool attribute(const Opened& opened, ParticipantId participant, const Arrival& arrival);
  /// Tells that what was opened last cannot be read.
  void reject_unreadable(const Opened& opened, const Arrival& arrival);

  /// Whether a session is to be asked for a proof: something is to be said soon, and again and again.
  [[nodiscard]] bool asks(base::Instant now) { return is_sealing() && challenges_.asks(now); }
  /// Whether somebody waits for a proof of ours: something is to be said at once.
  [[nodiscard]] bool is_asked(base::Instant now) const { return is_sealing() && challenges_.is_asked(now); }

  /// Whether a session is to be asked on this interface that was not heard on the other one.
  [[nodiscard]] bool asks_only_on(env::InterfaceIndex interface, env::InterfaceIndex other, base::Instant now) {
    return is_sealing() && challenges_.asks_only_on(interface, other, now);
  }
  /// Tells that nothing is said on this interface.
  void be_silent_on(env::InterfaceIndex interface) { challenges_.forget_owed(interface); }

  /// How this participant seals; nothing: it has not been heard sealed, or it is forgotten.
  [[nodiscard]] std::optional<Sealing> sealing_of(ParticipantId participant) const;
  [[nodiscard]] const Ledger& ledger() const { return ledger_; }
  [[nodiscard]] std::optional<std::string> take_complaint() { return ledger_.take_complaint(); }

 private:
  [[nodiscard]] bool is_sealing() const { return policy_.mode > Mode::prepared; }
  [[nodiscard]] bool hears_plain() const { return policy_.mode <= Mode::mixed; }
  void begin_session(base::Instant now);
  /// The header of our next datagram.
  [[nodiscard]] Header next_header(bool has_greeting, bool is_compressed);
  /// Opens the envelope; `outcome` says what was found.
  [[nodiscard]] std::expected<Opened, Rejection> open_sealed(std::span<const std::byte> datagram,
                                                             const Arrival& arrival, Outcome& outcome);
  /// The greeting and the text of a datagram, borrowed until the next call.
  struct Content {
    Greeting greeting{};
    std::span<const std::byte> text;
  };
  [[nodiscard]] std::expected<Content, Rejection> content(const Key& key, const Header& header,
                                                          std::span<const std::byte> datagram);
  [[nodiscard]] std::expected<std::span<const std::byte>, Rejection> expanded(const Header& header,
                                                                              std::span<const std::byte> text);
  /// Takes in a datagram that was sealed with one of our keys.
  struct Read {
    Header header;
    Greeting greeting{};
    bool had_room = false;  ///< for more than it says
  };
  [[nodiscard]] bool admit(const Read& read, const Arrival& arrival);
  void look_at_own(const Header& header, std::span<const std::byte> datagram, const Arrival& arrival);

  RandomBits random_bits_;
  Policy policy_;
  Session session_{};
  std::uint32_t counter_ = 0;  ///< of the next datagram
  ProvedSessions sessions_;
  Challenges challenges_;
  std::unique_ptr<Compression> compression_;  ///< null: there are no keys
  Ledger ledger_;
  std::map<ParticipantId, Session> sealers_;  ///< participants that were heard sealed, and the session of each
  std::array<std::byte, env::max_datagram_bytes> said_{};
  std::array<std::byte, env::max_datagram_bytes> heard_{};
  std::array<std::byte, max_text_bytes> expanded_{};          ///< a received text after expanding
  std::array<std::byte, max_text_bytes> compressed_{};        ///< a sent text after compressing
  std::array<std::byte, env::max_datagram_bytes> greeted_{};  ///< a greeting with the text behind it
};

}  // namespace geminga::sealing

#endif
