#include "daemon/ontology/ontology_in_force.hpp"

#include <algorithm>
#include <utility>

#include "base/text.hpp"

namespace geminga::daemon {
namespace {

using base::LogLevel;

/// The ontology of these files, or an error where it contradicts itself.
OntologyInForce::Loaded without_contradiction(OntologyInForce::Loaded loaded, const std::vector<std::string>& files) {
  if (!loaded) return loaded;
  auto contradiction = contradiction_in(*loaded, files);
  if (!contradiction) return loaded;
  return std::unexpected(std::vector<std::string>{std::move(*contradiction)});
}

/// The reason why the adopted ontologies among those that were loaded cannot be used; nothing where they can.
std::optional<std::string> fault_of_adopted(const OntologyInForce::Loaded& loaded,
                                            const std::vector<std::string>& adopted) {
  if (!loaded) return loaded.error().front();
  const auto is_of_adopted = [&](const std::string& line) {
    return std::ranges::any_of(adopted, [&](const std::string& folder) { return line.contains(folder); });
  };
  const auto left_out = std::ranges::find_if(loaded->left_out, is_of_adopted);
  if (left_out != loaded->left_out.end()) return *left_out;
  if (contradiction_in(*loaded, adopted)) return "the ontologies contradict themselves with it";
  return std::nullopt;
}

}  // namespace

void OntologyInForce::load_consistent(const Configuration& configuration, std::function<void(Loaded)> done,
                                      bool leaves_out_refused) {
  load(configuration, leaves_out_refused, [done = std::move(done), files = configuration.ontologies](Loaded loaded) {
    done(without_contradiction(std::move(loaded), files));
  });
}

void OntologyInForce::start(const Configuration& configuration, std::function<void()> done) {
  load(configuration, !configuration.is_strict, [this, done = std::move(done)](Loaded loaded) {
    if (is_stopped_) return;
    if (participant_ != nullptr) return change_to(std::move(loaded));
    if (loaded) vocabulary_ = vocabulary::Vocabulary(std::move(loaded->ontology));
    done();
    if (!loaded) return change_to(std::move(loaded));
    if (!loaded->left_out.empty()) env_.event([&] { participant_->ontology_failed(loaded->left_out); });
  });
}

void OntologyInForce::reload(const Configuration& configuration) {
  if (std::exchange(is_next_in_preparation_, false)) preparation_.cancel();  // what is read now is newer
  env_.event([&] { participant_->ontology_begun(); });
  const bool leaves_out_refused = !configuration.is_strict && !vocabulary_.is_loaded();
  load_consistent(
      configuration,
      [this](Loaded loaded) {
        if (!is_stopped_) change_to(std::move(loaded));
      },
      leaves_out_refused);
}

void OntologyInForce::serve(participant::Participant& participant) {
  participant_ = &participant;
  if (is_loading()) participant.ontology_begun();
}

void OntologyInForce::prepare_if_wanted() {
  const vocabulary::Vocabulary* wanted = participant_->wants_prepared();
  if (wanted == nullptr || !wanted->has_ontology_of(vocabulary_) || is_next_in_preparation_) return;
  if (preparation_.is_preparing(*wanted)) return;
  preparation_.start(*wanted, [this](vocabulary::Vocabulary prepared) {
    env_.event([&] { participant_->on_prepared(std::move(prepared)); });
    after_event_();
  });
}

void OntologyInForce::load(const Configuration& configuration, bool leaves_out_refused,
                           std::function<void(Loaded)> done) {
  load_adopting(configuration, 0, leaves_out_refused, std::move(done));
}

/// Loads with the adopted versions of this level. Where they cannot be read whole, or make a contradiction, those of
/// the next level are taken, and at last none, so that nobody's ontology takes away the owner's.
void OntologyInForce::load_adopting(const Configuration& configuration, std::size_t level, bool leaves_out_refused,
                                    std::function<void(Loaded)> done) {
  const std::vector<std::string> adopted = adopted_versions(configuration.adopted, level);
  if (adopted.empty()) return load_with(configuration, adopted, leaves_out_refused, std::move(done));
  load_with(configuration, adopted, leaves_out_refused,
            [this, configuration, level, leaves_out_refused, adopted, done = std::move(done)](Loaded loaded) {
              if (is_stopped_) return;
              const auto fault = fault_of_adopted(loaded, adopted);
              if (!fault) return done(std::move(loaded));
              log_.write(LogLevel::warning, "ontology: " + base::joined(adopted, ", ") + " is not adopted: " + *fault);
              load_adopting(configuration, level + 1, leaves_out_refused, done);
            });
}

/// A load that is under way is given up.
void OntologyInForce::load_with(const Configuration& configuration, const std::vector<std::string>& adopted,
                                bool leaves_out_refused, std::function<void(Loaded)> done) {
  std::vector<std::string> files = configuration.ontologies;
  files.insert(files.end(), adopted.begin(), adopted.end());
  const auto began = std::chrono::steady_clock::now();
  const auto take = [this, done = std::move(done), began](Loaded loaded) {
    if (loaded) {
      load_time_ = std::chrono::steady_clock::now() - began;
      for (const std::string& line : loaded->left_out) log_.write(LogLevel::error, "ontology: " + line);
      for (const std::string& remark : loaded->remarks) log_.write(LogLevel::warning, "ontology: " + remark);
    }
    done(std::move(loaded));
  };
  loader_.load(files, configuration.prefixes, take, leaves_out_refused);
}

void OntologyInForce::change_to(Loaded loaded) {
  if (!loaded) {
    report_failure(loaded.error());
  } else if (loaded->ontology != nullptr && participant_->uses_expressions()) {
    // The one in force stays until this one can place expressions, so that no match is lost meanwhile.
    is_next_in_preparation_ = true;
    preparation_.start(vocabulary::Vocabulary(std::move(loaded->ontology)),
                       [this, left_out = std::move(loaded->left_out)](vocabulary::Vocabulary prepared) {
                         if (is_stopped_) return;
                         is_next_in_preparation_ = false;
                         put_in_force(std::move(prepared), left_out);
                         after_event_();
                       });
  } else {
    put_in_force(vocabulary::Vocabulary(std::move(loaded->ontology)), loaded->left_out);
  }
  after_event_();
}

void OntologyInForce::report_failure(const std::vector<std::string>& lines) {
  log_.write_failed_reading(lines, vocabulary_.is_loaded() ? "the ontology in force is kept: " + digest_of(vocabulary_)
                                                           : "serving without an ontology: mend it and send SIGHUP");
  env_.event([&] { participant_->ontology_failed(lines); });
}

void OntologyInForce::put_in_force(vocabulary::Vocabulary vocabulary, const std::vector<std::string>& left_out) {
  preparation_.cancel();
  vocabulary_ = std::move(vocabulary);
  env_.event([&] { participant_->set_vocabulary(vocabulary_, left_out); });
  log_.write(LogLevel::info, "ontology: " + digest_of(vocabulary_) + " is in force");
}

std::string digest_of(const vocabulary::Vocabulary& vocabulary) {
  return vocabulary.is_loaded() ? base::to_hex(vocabulary.digest(), 16) : "none";
}

}  // namespace geminga::daemon
