// The loss that a sample bears out: chance alone makes a small one look bad.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_LEAST_LOSS_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_LEAST_LOSS_HPP

#include "discovery/membership/neighbour/loss_window.hpp"

namespace geminga::membership {

struct Neighbour;

/// The probability that least_loss() is more than the loss that there is. With n neighbours one look at all of them
/// errs n times as often at most: a team of ten once in a thousand looks.
inline constexpr double loss_error = 1e-4;

/// The lower confidence bound of a loss (Clopper and Pearson, Biometrika 26, 1934): a link that loses less shows so
/// many missed numbers with a probability of `error` at most, where each is lost by itself. 0 where none is missed.
[[nodiscard]] double least_loss(const LossSample& sample, double error);

/// The loss of this way that is sure: the greater bound of the last 64 and the last 256 numbers, and no more than what
/// was measured lately, so that a link that was mended is believed soon.
[[nodiscard]] double least_loss(const LossSample& lately, const LossSample& for_long);

/// The same of the best way to a participant. 0 where it is heard through a relay, which tells no sample.
[[nodiscard]] double least_loss(const Neighbour& neighbour);

}  // namespace geminga::membership

#endif
