// Questions to other participants about what they hear, and our answers to theirs: ANNOUNCEMENT.md, "Inquiries".
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_AIR_DIAGNOSES_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_AIR_DIAGNOSES_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/time.hpp"
#include "discovery/announcement/announcement.hpp"
#include "discovery/membership/schedule/token_bucket.hpp"
#include "geminga/service.hpp"

namespace geminga::participant {

/// An inquiry that is not answered is said again after so long, and after a quarter of a minute it is over.
inline constexpr base::Duration inquiry_spacing = std::chrono::milliseconds(250);
inline constexpr base::Duration inquiry_patience = std::chrono::seconds(15);
/// An answer that is older is asked for anew.
inline constexpr base::Duration diagnosis_life = std::chrono::seconds(5);
/// The inquiries that we say, whatever clients want, and the diagnoses that we give: so many, then one a second.
inline constexpr std::int64_t inquiry_capacity = 8;
inline constexpr std::int64_t diagnosis_capacity = 4;
inline constexpr base::Duration exchange_refill = std::chrono::seconds(1);
/// The participants whose answers are remembered; the oldest gives way.
inline constexpr std::size_t max_diagnoses = 8;

class Diagnoses {
 public:
  struct Diagnosis {
    std::vector<std::string> lines;
    base::Instant heard{};
  };

  /// Whether an inquiry of this participant is to be said at once, and with which token. `random` is drawn by the
  /// caller, and used for a new question.
  [[nodiscard]] std::optional<std::uint64_t> ask(ParticipantId participant, std::uint64_t random, base::Instant now);
  /// The answer of a participant, if it is no older than diagnosis_life; else null.
  [[nodiscard]] const Diagnosis* answer_of(ParticipantId participant, base::Instant now) const;

  /// Takes in a diagnosis; one that was not asked for is dropped.
  void hear_diagnosis(const announcement::Announcement& diagnosis, base::Instant now);
  /// Whether an inquiry of ours may be answered at this moment. Pays for the answer.
  [[nodiscard]] bool may_answer(base::Instant now);

 private:
  struct Question {
    ParticipantId participant{};
    std::uint64_t token = 0;
    base::Instant asked{};  ///< first
    base::Instant said{};   ///< last
    std::optional<Diagnosis> answer{};
  };
  [[nodiscard]] Question* find(ParticipantId participant);

  std::vector<Question> questions_;  ///< the one that was asked first comes first
  membership::TokenBucket inquiries_{inquiry_capacity, exchange_refill};
  membership::TokenBucket answers_{diagnosis_capacity, exchange_refill};
};

}  // namespace geminga::participant

#endif
