// The whole daemon without an operating system. Its inputs are GCNP lines, datagrams and the time; its outputs are
// GCNP lines, datagrams and the next deadline.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_PARTICIPANT_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_PARTICIPANT_HPP

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "discovery/gcnp/statement.hpp"
#include "discovery/participant/settings.hpp"
#include "env/env.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::participant {

/// One participant of a team. Its owner feeds it one event at a time by the on_...() functions, on one thread, and
/// never from within an Env call. After each of them, all that follows from the event has been handed to Env. Octets
/// from outside may be anything. No function throws.
class Participant {
 public:
  using Vocabulary = vocabulary::Vocabulary;

  /// Borrows `env` for its life.
  Participant(env::Env& env, Settings settings, Vocabulary vocabulary = {});
  /// May come at any time. Without a stop() that has ended, the team learns of it by the deadline only.
  ~Participant();
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;

  /// Begins to claim an identifier (paper section 3.5.1). Once, before any other event. Clients may connect at once;
  /// their statements wait until the identifier is claimed, and are then handled in their order.
  void start();
  /// Withdraws everything, says goodbye on the air and closes the clients. The goodbye is repeated for a few hundredths
  /// of a second against loss: feed on_timer() until is_stopped().
  void stop();
  /// Whether stop() has done everything; then the participant may be destroyed.
  [[nodiscard]] bool is_stopped() const;
  /// Why no first identifier could be claimed within the iteration limit (paper section 3.5.1), and what to do. Then
  /// the clients were told 503 and closed, is_stopped() holds, and the daemon ends with this error. Empty otherwise.
  [[nodiscard]] std::string failure() const;
  /// Whether the identifier is claimed and the participant not stopping.
  [[nodiscard]] bool is_ready() const;

  /// The instant that was last given to Env::wake_at() has come. A call too early or too often does no harm.
  void on_timer();
  /// A datagram came in on an interface. `source` is the sender's numeric address, for the log and for diagnosis only.
  void on_datagram(env::InterfaceIndex interface, std::string_view source, std::span<const std::byte> datagram);
  /// The result of Env::interfaces() has changed.
  void on_interfaces_changed();
  /// The result of Env::route() may have changed.
  void on_routes_changed();

  /// `user` is the user who connected, where the system tells; else empty.
  void on_stream_opened(env::StreamId stream, std::string_view user);
  /// Octets in the order of the stream, cut anywhere. The statements in them are handled in a later on_timer(), in
  /// turns.
  void on_stream_bytes(env::StreamId stream, std::string_view bytes);
  /// The client is gone: all that it offered and asked for is withdrawn. Not called after Env::close().
  void on_stream_closed(env::StreamId stream);
  /// The client has read everything that was queued for it.
  void on_stream_drained(env::StreamId stream);

  /// Memory is short: gives up the participants that were heard last, a quarter of those that were heard for less than
  /// seasoned_after, and gives no place to further ones for memory_pause. Their services go in later on_timer(), in
  /// turns. To be called again where that was not enough.
  void shed();

  /// Takes other keys, or another way to seal. No participant is lost that has the keys which this step of a rotation
  /// or a migration asks for (src/discovery/sealing/SEALING.md). After start().
  void set_sealing(const sealing::Policy& policy);

  /// Takes another class expression as what describes the participant; empty: none. It takes the place of what clients
  /// have stated by `sys describe`. One that the ontology does not know is logged, and comes into force with one that
  /// does.
  void describe(const std::string& expression);

  /// Takes the vocabulary of another ontology, or of none. Peers are told what follows: a publication or subscription
  /// whose names the new one does not know gets one error 422 and its events `del reason=changed`, and comes back by
  /// itself when a later ontology knows them. For a large team the work is done in later on_timer(), in turns; another
  /// ontology that comes meanwhile waits. Where it is not prepared for class expressions, requests for these are out of
  /// force until on_prepared(), and their peers are told so. `left_out` are lines
  /// about files that are not in it: queries show them as those of ontology_failed().
  void set_vocabulary(Vocabulary vocabulary, const std::vector<std::string>& left_out = {});
  /// The vocabulary that is to be prepared for class expressions, because one has come; null: none. Call after each
  /// event. Preparing is long work: the owner of the participant does it elsewhere, and brings the result by
  /// on_prepared(). Meanwhile statements that need it wait, and so do the statements of their clients behind them.
  [[nodiscard]] const Vocabulary* wants_prepared() const;
  /// Whether class expressions are in use with the ontology in force. Then the next one should come prepared.
  [[nodiscard]] bool uses_expressions() const;
  /// The vocabulary is prepared. One of an ontology that is not in force is dropped.
  void on_prepared(Vocabulary prepared);
  /// Ontologies are being read: `query status` and `query ontology` say so until set_vocabulary() or ontology_failed().
  /// Where none is in force meanwhile, statements with concepts are kept without an answer. They come into force with
  /// the ontology, or get their 422 then. Queries that need an ontology are answered 503 at once.
  void ontology_begun();
  /// The ontologies, or some of their files, could not be read, and these lines say why. The ontology in force stays;
  /// queries show the lines until a later reading ends in set_vocabulary().
  void ontology_failed(const std::vector<std::string>& lines);

  /// Gives fields that only the owner knows (memory, processor time, files), to be appended to the answer of `query
  /// status`. Called within on_timer(); must not call back.
  using StatusSource = std::function<std::vector<gcnp::Parameter>()>;
  void set_status_source(StatusSource source);

 private:
  /// The three owners, and what routing between them needs. Hidden, so that a program which runs a participant includes
  /// no header of theirs.
  struct Owners;

  [[nodiscard]] bool is_over() const;
  /// Ends an event: all that follows from it is handed to Env, and the timer is set.
  void settle();
  void claimed();
  void fail();
  /// Brings what neighbours have changed into the registry: a little at once, the rest in turns.
  void feed();
  void proceed_feed();
  void proceed_ontology_change();
  /// Begins a change of ontology at once, so that a small team has changed when this event is over.
  void change_ontology();
  void report_description();
  void remember_interfaces();
  [[nodiscard]] bool is_feed_due() const;
  [[nodiscard]] base::Instant deadline() const;

  std::unique_ptr<Owners> owners_;
};

}  // namespace geminga::participant

#endif
