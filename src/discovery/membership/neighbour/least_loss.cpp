#include "discovery/membership/neighbour/least_loss.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>

#include "discovery/membership/neighbour/neighbour.hpp"

namespace geminga::membership {

double least_loss(const LossSample& sample, double error) {
  if (sample.missed <= 0) return 0;
  return boost::math::binomial_distribution<>::find_lower_bound_on_p(sample.numbers, sample.missed, error);
}

double least_loss(const LossSample& lately, const LossSample& for_long) {
  if (lately.numbers == 0) return 0;
  const double measured = static_cast<double>(lately.missed) / lately.numbers;
  // Two bounds err together no more often than one whose error is the sum of theirs.
  return std::min(measured, std::max(least_loss(lately, loss_error / 2), least_loss(for_long, loss_error / 2)));
}

double least_loss(const Neighbour& neighbour) {
  double least = neighbour.paths.empty() ? 0 : 1;
  for (const Path& path : neighbour.paths) least = std::min(least, least_loss(path.lately, path.for_long));
  return least;
}

}  // namespace geminga::membership
