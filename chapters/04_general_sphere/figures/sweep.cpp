#include "figures.hpp"
#include "parts.hpp"
#include "rounded.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

void draw_ray(const Studio& studio) {
  figure::Scene scene({64, 30});
  const Point a(-1.4, -0.9, 0), b(1.6, -0.7, 0), c(0.2, 1.3, 0.2);
  scene.polygon({a, b, c}, solid);
  const Point hit = 0.3 * a + 0.35 * b + 0.35 * c, seam = 0.45 * b + 0.55 * c;
  for (const Point& p : {hit, seam}) {
    const Vector down(0.25, 0.2, -1);
    scene.line({p, p + 0.75 * down}, {colour::red, 1.2, true}, -1);
    scene.arrow(p - 1.5 * down, p);
    scene.dot(p);
  }
  scene.label("{/:Italic a}", a, -0.9, -0.3);
  scene.label("{/:Italic b}", b, 0.9, -0.3);
  scene.label("{/:Italic c}", c, 0, 0.8);
  scene.label("{/:Italic C}", hit, 0.9, -0.5);
  finish(studio, "ray", scene);
}

void draw_sweep(const Studio& studio, const Environment& environment, const Moving<Sphere>& moving,
                const std::optional<Contact>& contact) {
  const View view{66, 32};
  const auto& [start, r] = moving.shape;
  const Point end = start + (contact ? contact->time : 1.0) * moving.displacement;
  figure::Scene scene(view);
  scene.mesh(environment.mesh(), {colour::sky, 1, true}, false);
  if (environment.mesh().size() < 200) draw_ridges(scene, environment, view, 1);
  scene.sphere({start, r}, colour::amber, 1, 2);
  scene.sphere({end, r}, colour::amber, 0.55, 2);
  scene.arrow(start, end, {colour::red, 2.4}, 3);
  scene.label("{/:Italic S}_0", start + r * view.up(), 0, 0.8);
  if (contact) {
    scene.arrow(contact->point(), contact->point() + 1.9 * r * contact->normal, {colour::ink, 2.0}, 3);
    scene.dot(contact->point());
    scene.label("{/:Italic C}", contact->point(), -1.0, 0.2);
    scene.label("{/:Bold N}", contact->point() + 1.9 * r * contact->normal, 0.9, -0.6);
  }
  scene.dot(start);
  finish(studio, "sweep", scene);
}
