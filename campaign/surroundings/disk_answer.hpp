#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "analysis/disk/place.hpp"
#include "analysis/disk/published_numbers.hpp"

namespace eerie::surroundings {

/// A question about the protoplanetary disk around the impacts.
struct DiskQuestion {
  double r_au = 5;               ///< distance from the star
  double alpha = 1e-4;           ///< strength of turbulence
  double stirrer_radius_km = 2;  ///< of the large planetesimals that stir the small ones
  double solid_fraction = disk::Stirrers().solid_fraction;  ///< of all solids, in stirrers
  disk::Body body;                                          ///< a small body
  std::optional<disk::DragLaw> drag;         ///< nothing: the published law where it knows the body
  double phi_d_deg = 40;                     ///< friction angle of the material
  double b_over_a = 0.24;                    ///< of a remnant
  double nearest_au = 1, farthest_au = 100;  ///< the distances of the figures

  disk::PlaceQuestion place() const {
    return {body, {solid_fraction, body.density}, alpha, 1000 * stirrer_radius_km};
  }
};

struct DiskAnswer {
  disk::Nebula nebula;
  std::vector<disk::Place> places;  ///< by each law that knows the body
  double mu_d = 0;                  ///< friction coefficient
  double displacement_over_radius = 0, displacement_over_radius_of_sphere = 0;
  double roche_distance = 0;  ///< within which tides deform the remnant, in radii
  std::vector<disk::PublishedNumber> published;
};

/// Throws InputError where the law of drag does not know the body.
DiskAnswer disk_answer(const DiskQuestion& question);

/// {"nebula", "places", "mu_d", "displacement_over_radius", "displacement_over_radius_of_sphere",
///  "roche_distance_in_radii", "paper"}
nlohmann::json to_json(const DiskAnswer& answer);

/// Sentences about places where the formulas do not hold.
std::vector<std::string> warnings(const DiskAnswer& answer);

/// Writes the published numbers and both figures, in each format and as CSV, into a folder that
/// exists. Returns the files.
std::vector<std::filesystem::path> write_disk(const DiskQuestion& question,
                                              const DiskAnswer& answer,
                                              const std::filesystem::path& folder,
                                              const std::vector<std::string>& formats);

}  // namespace eerie::surroundings
