#include "showing.hpp"

#include <algorithm>
#include <cmath>

#include "first_contact/files/decimal.hpp"
#include "first_contact/geometry/refuse.hpp"
#include "first_contact/motion/keys.hpp"
#include "first_contact/motion/squash.hpp"
#include "first_contact/motion/sweep_rigid.hpp"
#include "first_contact/sweep/sphere_box.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "first_contact/sweep/sphere_plane.hpp"

using namespace first_contact;

namespace tween_bounce {

namespace {

constexpr int most_contacts = 64;

RigidTween poses_of(const Film& film) {
  std::vector<Pose> poses;
  for (const FilmKey& key : film.keys) poses.push_back({key.time, key.place, key.turn, key.easing, key.path});
  return RigidTween(std::move(poses));
}

double largest_of(const std::vector<Wall>& walls) {
  double largest = 0;
  for (const Wall& wall : walls)
    largest = std::max(largest,
                       std::visit([](const auto& obstacle) { return largest_coordinate(obstacle); }, wall));
  return largest;
}

// A rigid sweep wants the surface alone.
const Mesh& surface(const Environment& environment) { return environment.mesh(); }
template <class Any>
const Any& surface(const Any& obstacle) {
  return obstacle;
}

std::optional<Contact> first_of_box(const RigidTween& poses, const Box& box, const std::vector<Wall>& walls) {
  std::optional<Contact> first;
  for (const Wall& wall : walls) {
    auto contact =
        std::visit([&](const auto& obstacle) { return sweep(poses, box, surface(obstacle)); }, wall);
    if (contact && (!first || contact->time < first->time)) first = std::move(contact);
  }
  return first;
}

// A ball that jumps (steps) touches on its way; where a box would stand then, nobody knows.
void must_not_jump(const RigidTween& poses, double time) {
  const Rigid before = poses.at(time), after = poses.at(std::nextafter(time, HUGE_VAL));
  const Vector way = after.translation() - before.translation();
  const double turn = (after.rotation() - before.rotation()).cwiseAbs().maxCoeff();
  const double size = before.translation().cwiseAbs().maxCoeff() + 1;
  if (norm(way) > tween_gap * size || turn > tween_gap)
    refuse("box", "must not jump, by steps, into what is in the way");
}

}  // namespace

Tween places_of(const Film& film) {
  std::vector<KeyFrame> keys;
  for (const FilmKey& key : film.keys) keys.push_back({key.time, key.place, key.easing, key.path});
  return Tween(std::move(keys));
}

//! [first_of_all]
std::optional<Contact> first_of_all(const std::vector<Wall>& walls, const Moving<Sphere>& moving) {
  std::optional<Contact> first;
  for (const Wall& wall : walls) {
    auto contact = std::visit([&](const auto& obstacle) { return sweep(moving, obstacle); }, wall);
    if (contact && (!first || contact->time < first->time)) first = std::move(contact);
  }
  return first;
}
//! [first_of_all]

//! [showing]
Showing::Showing(const Film& film) : poses_(poses_of(film)), keys_(film.keys) {
  if (const Sphere* ball = std::get_if<Sphere>(&film.actor)) {
    const auto meets = [&](const Moving<Sphere>& moving) { return first_of_all(film.walls, moving); };
    ball_ =
        play(places_of(film), ball->radius, meets, largest_of(film.walls), film.contact.after, most_contacts);
    contacts_ = ball_->contacts();
  } else if (const auto contact = first_of_box(poses_, std::get<Box>(film.actor), film.walls)) {
    must_not_jump(poses_, contact->time);
    contacts_ = {*contact};
  }
  const bool stops = film.contact.what == "stop" || std::ssize(contacts_) == most_contacts;
  if (stops && !contacts_.empty()) stopped_ = contacts_.back().time;
}

Frame Showing::at(double time) const {
  const double now = std::min(time, stopped_.value_or(time));
  const Rigid pose = poses_.at(now);
  const std::size_t i = keys::current(keys_, now), next = std::min(i + 1, keys_.size() - 1);
  const double part = next == i ? 0 : (now - keys_[i].time) / (keys_[next].time - keys_[i].time);
  return {time, ball_ ? ball_->at(now) : pose.translation(), Eigen::Quaterniond(pose.rotation()),
          eased_stretch(keys_[i].scale, keys_[next].scale, keys_[i].easing, part)};
}
//! [showing]

std::vector<double> picture_times(double begin, double end, double per_second) {
  const double count = std::ceil((end - begin) * per_second * (1 - 1e-12)) + 1;
  if (!(count <= static_cast<double>(most_frames)))
    refuse("pictures", count, "must be at most " + std::to_string(most_frames));
  std::vector<double> times;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
    times.push_back(std::min(begin + static_cast<double>(i) / per_second, end));
  return times;
}

std::string csv(const Showing& showing, const std::vector<double>& times) {
  std::string text = "time,x,y,z,qw,qx,qy,qz,scale\n";
  for (const double time : times) {
    const auto [now, p, q, scale] = showing.at(time);
    std::string row;
    for (const double number : {now, p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z(), scale})
      row += (row.empty() ? "" : ",") + shortest(number);
    text += row + "\n";
  }
  return text;
}

}  // namespace tween_bounce
