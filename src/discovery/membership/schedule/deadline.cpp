#include "discovery/membership/schedule/deadline.hpp"

#include <algorithm>

namespace geminga::membership {

base::Instant after_intervals(base::Instant seen, base::Duration interval, double intervals) {
  return seen + base::Duration(static_cast<base::Duration::rep>(static_cast<double>(interval.count()) * intervals));
}

base::Duration answer_time(double loss) {
  // Multiplied out, since the logarithms of two machines may differ in their last digit.
  double missed = 1;
  for (int denial = 0; denial < denials_awaited; ++denial) missed *= loss;
  base::Duration time = least_answer_time;
  for (int denial = denials_awaited; denial < denials && missed > wrong_successions; ++denial) {
    missed *= loss;
    // The first denials may be missing because their sender missed what prompts them.
    time = (denial + 1 + denials_unprompted) * denial_spacing;
  }
  // A missing denial is asked for: the question and its answer must both arrive.
  const double miss_round = std::min(1 - (1 - loss) * (1 - loss), 0.9);
  for (; missed > wrong_successions; missed *= miss_round) time += question_time;
  return time;
}

base::Duration witnessed_time(base::Duration interval, double loss) {
  // The longest deadline from 27.5 % on: who is out of our reach so often is asked seldom enough to be cheap.
  const double intervals = std::min(shortest_deadline + 10 * loss, longest_deadline);
  return after_intervals(base::Instant{}, interval, intervals) - base::Instant{};
}

base::Duration patience(base::Duration interval, const Reception& reception) {
  // With witnesses all ways must lose the sign of life at once. The fewer witnesses there are, the more our own tries
  // must make up for it.
  const double alone = 1 - static_cast<double>(std::min(reception.witnesses, enough_witnesses)) / enough_witnesses;
  const double more = std::max(2.5 * (reception.loss - 0.2), 10 * reception.loss * reception.loss * alone);
  const double intervals = std::min(shortest_deadline + std::max(0.0, more), longest_deadline);
  const auto least = after_intervals(base::Instant{}, interval, doubt_after) + least_questions * question_time;
  return std::max(after_intervals(base::Instant{}, interval, intervals), least) - base::Instant{} + reception.delay;
}

}  // namespace geminga::membership
