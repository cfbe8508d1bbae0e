#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/disk/place.hpp"
#include "analysis/disk/published_numbers.hpp"

namespace eerie::cli {

// What `eerie disk` prints.

nlohmann::json to_json(const disk::Nebula& nebula);
nlohmann::json to_json(const disk::Place& place);
nlohmann::json to_json(const disk::PublishedNumber& number);

std::string nebula_line(const disk::Nebula& nebula);
/// A column for each law of drag.
std::string place_table(double r_au, const disk::PlaceQuestion& question,
                        const std::vector<disk::Place>& places);
std::string published_table(const std::vector<disk::PublishedNumber>& numbers);

}  // namespace eerie::cli
