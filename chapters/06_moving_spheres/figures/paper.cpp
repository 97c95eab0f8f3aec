#include "figures.hpp"
#include "first_contact/figure/scene.hpp"
#include "scene.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace {

// The paper's two spheres move in one plane; seen at right angles to it, what touches also looks so.
const View front{90, 0};

Point at(const Moving<Sphere>& ball, double t) { return ball.shape.center + t * ball.displacement; }

// A sphere where it starts and, of glass, where it ends, with its velocity.
void add_motion(figure::Scene& scene, const Moving<Sphere>& ball, const Colour& colour) {
  scene.sphere({at(ball, 1), ball.shape.radius}, colour, 0.4, 0);
  scene.sphere(ball.shape, colour, 1, 1);
  scene.arrow(at(ball, 0), at(ball, 1));
  scene.dot(at(ball, 0));
  scene.dot(at(ball, 1));
}

}  // namespace

void draw_motions(const Studio& studio) {
  const ::Scene paper;
  const auto p = paper.p(), q = paper.q();
  figure::Scene scene(front, 0.04);
  add_motion(scene, p, colour::amber);
  add_motion(scene, q, colour::sky);
  scene.label("{/:Italic P}_1", at(p, 0), -1.2, 0.4);
  scene.label("{/:Italic P}_2", at(p, 1), 1.2, 0.4);
  scene.label("{/:Italic Q}_1", at(q, 0), 1.3, 0.4);
  scene.label("{/:Italic Q}_2", at(q, 1), -1.3, 0.4);
  scene.label("{/:Bold V}_{/:Italic p}", at(p, 0.32), 0, 0.9, colour::red);
  scene.label("{/:Bold V}_{/:Italic q}", at(q, 0.42), -1.5, 0.4, colour::red);
  Figure figure(studio, "figure-11", scene.size());
  scene.draw(figure);
  figure.draw();
}

void draw_contact(const Studio& studio) {
  const ::Scene paper;
  const Meeting meeting(paper.p(), paper.q(), paper.when());
  const Vector n = -meeting.contact->normal, across(n.z(), 0, -n.x());
  const Point c = meeting.contact->point();
  figure::Scene scene(front, 0.05);
  scene.sphere({meeting.p, paper.rp}, colour::amber, 0.55);
  scene.sphere({meeting.q, paper.rq}, colour::sky, 0.55);
  scene.line({c - 0.8 * across, c + 0.8 * across}, {colour::grey, 1.2, true});
  scene.line({meeting.p, meeting.q}, {colour::grey, 1.6});
  scene.arrow(meeting.p, meeting.p + 0.7 * n, {colour::ink, 2.4}, 3);
  for (const Point& dot : {meeting.p, meeting.q, c}) scene.dot(dot);
  scene.label("{/:Italic P}({/:Italic t})", meeting.p, -1.3, -0.9);
  scene.label("{/:Italic Q}({/:Italic t})", meeting.q, 1.8, 0.3);
  scene.label("{/:Italic C}", c, -0.2, 1.1);
  scene.label("{/:Bold N}", meeting.p + 0.45 * n, -1.2, 0.3);
  scene.label("{/:Italic r_P}", meeting.p + 0.5 * paper.rp * n, 1.4, -0.4);
  scene.label("{/:Italic r_Q}", c + 0.5 * paper.rq * n, 1.4, -0.4);
  Figure figure(studio, "figure-12", scene.size(480));
  scene.draw(figure);
  figure.draw();
}
