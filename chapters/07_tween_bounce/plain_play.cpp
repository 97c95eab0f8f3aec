#include "plain_play.hpp"

#include "first_contact/response/rebound.hpp"

using namespace first_contact;

namespace tween_bounce {

//! [plain_play]
std::vector<Point> plain_play(const Tween& plan, double radius, const SphereSweep& first_contact_of, double e,
                              double pictures_a_second) {
  std::vector<Point> places{plan.at(plan.begin())};
  Eigen::Matrix3d turned = Eigen::Matrix3d::Identity();
  const double pictures = (plan.end() - plan.begin()) * pictures_a_second;
  for (int i = 0; i < pictures; ++i) {
    const double now = plan.begin() + i / pictures_a_second, next = now + 1 / pictures_a_second;
    const Vector step = turned * (plan.at(next) - plan.at(now));
    const auto contact = first_contact_of({{places.back(), radius}, step});
    places.push_back(places.back() + (contact ? contact->time : 1) * step);
    if (contact) turned = rebound(step, contact->normal, Surface(e, 0)) * turned;
  }
  return places;
}
//! [plain_play]

}  // namespace tween_bounce
