#include "analysis/flight/spheres.hpp"

#include <gmock/gmock.h>

#include <random>

namespace eerie::flight {
namespace {

constexpr double contact = 1.5;

std::vector<RigidBody> scattered_bodies(std::size_t n) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-50, 50), radius(0, 6);
  std::vector<RigidBody> bodies(n);
  for (RigidBody& body : bodies)
    body.x = {place(random), place(random), place(random)}, body.radius = radius(random);
  return bodies;
}

std::vector<std::size_t> near_by_search(const std::vector<RigidBody>& bodies, std::size_t k) {
  std::vector<std::size_t> near;
  for (std::size_t b = k + 1; b < bodies.size(); ++b)
    if (norm(bodies[k].x - bodies[b].x) <= bodies[k].radius + bodies[b].radius + contact)
      near.push_back(b);
  return near;
}

std::vector<std::size_t> near_by_spheres(const Spheres& spheres, std::size_t k, std::size_t n) {
  std::vector<std::size_t> near;
  for (std::size_t b = k; (b = spheres.next_within(contact, k, b)) < n;) near.push_back(b);
  return near;
}

TEST(Spheres, FindAllThatComeNearInTheirOrder) {
  const std::vector<RigidBody> bodies = scattered_bodies(300);
  Spheres spheres;
  spheres.take(bodies);
  std::size_t found = 0;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    EXPECT_EQ(near_by_spheres(spheres, k, bodies.size()), near_by_search(bodies, k));
    found += near_by_search(bodies, k).size();
  }
  EXPECT_GT(found, 100U);
}

TEST(Spheres, FollowBodiesThatMoveAndGo) {
  std::vector<RigidBody> bodies = scattered_bodies(200);
  Spheres spheres;
  spheres.take(bodies);
  bodies[3].x = bodies[150].x, bodies[3].radius = 20;
  spheres.set(3, bodies[3]);
  bodies.erase(bodies.begin() + 70);
  spheres.erase(70);
  for (std::size_t k = 0; k < bodies.size(); ++k)
    EXPECT_EQ(near_by_spheres(spheres, k, bodies.size()), near_by_search(bodies, k));
}

}  // namespace
}  // namespace eerie::flight
