#include "discovery/participant/air/diagnoses.hpp"

#include <algorithm>

namespace geminga::participant {

Diagnoses::Question* Diagnoses::find(ParticipantId participant) {
  const auto found = std::ranges::find(questions_, participant, &Question::participant);
  return found == questions_.end() ? nullptr : &*found;
}

std::optional<std::uint64_t> Diagnoses::ask(ParticipantId participant, std::uint64_t random, base::Instant now) {
  if (answer_of(participant, now) != nullptr) return std::nullopt;
  Question* known = find(participant);
  const bool is_waiting = known != nullptr && !known->answer && now - known->asked < inquiry_patience;
  if (is_waiting && now - known->said < inquiry_spacing) return std::nullopt;
  if (!inquiries_.has(now)) return std::nullopt;
  inquiries_.take(now);
  if (is_waiting) {
    known->said = now;
    return known->token;
  }
  std::erase_if(questions_, [&](const Question& one) { return one.participant == participant; });
  if (questions_.size() == max_diagnoses) questions_.erase(questions_.begin());
  questions_.push_back({.participant = participant, .token = random, .asked = now, .said = now});
  return random;
}

const Diagnoses::Diagnosis* Diagnoses::answer_of(ParticipantId participant, base::Instant now) const {
  const auto found = std::ranges::find(questions_, participant, &Question::participant);
  if (found == questions_.end() || !found->answer || now - found->answer->heard > diagnosis_life) return nullptr;
  return &*found->answer;
}

void Diagnoses::hear_diagnosis(const announcement::Announcement& diagnosis, base::Instant now) {
  Question* question = find(diagnosis.participant);
  if (question == nullptr || question->answer || question->token != diagnosis.token) return;
  if (now - question->asked > inquiry_patience) return;
  question->answer = Diagnosis{.lines = diagnosis.lines, .heard = now};
}

bool Diagnoses::may_answer(base::Instant now) {
  if (!answers_.has(now)) return false;
  answers_.take(now);
  return true;
}

}  // namespace geminga::participant
