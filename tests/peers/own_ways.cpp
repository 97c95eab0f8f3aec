#include "first_contact/bvh/bvh.hpp"
#include "first_contact/bvh/cast/parts.hpp"
#include "first_contact/bvh/cast/sphere_cast.hpp"
#include "peers/ways.hpp"
#include "peers/yardstick.hpp"

namespace peers {

namespace {

double time_of(const std::optional<Contact>& contact) { return contact ? contact->time : never; }

}  // namespace

std::vector<Way> own_ways(const Mesh& mesh) {
  const auto plain = std::make_shared<const PlainBvh>(mesh);
  const auto fast = std::make_shared<const Bvh>(mesh);
  const auto contacts = std::make_shared<std::vector<std::optional<Contact>>>();
  return {
      one_by_one("plain tree, textbook",
                 [plain](const auto& cast) { return yardstick::sweep(cast, *plain).time; }),
      one_by_one("plain tree", [plain](const auto& cast) { return time_of(sweep(cast, *plain)); }),
      one_by_one("fast tree", [fast](const auto& cast) { return time_of(sweep(cast, *fast)); }),
      one_by_one("fast tree, portable",
                 [fast, plainest = bvh::all_walkers().back()](const auto& cast) {
                   return time_of(bvh::sweep(cast, fast->parts(), *plainest));
                 }),
      {"fast tree, batch", [fast, contacts](std::span<const Moving<Sphere>> casts, std::span<double> times) {
         contacts->resize(casts.size());
         sweep(casts, *fast, *contacts);
         for (std::size_t i = 0; i < casts.size(); ++i) times[i] = time_of((*contacts)[i]);
       }}};
}

}  // namespace peers
