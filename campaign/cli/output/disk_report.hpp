#pragma once

#include <string>
#include <vector>

#include "analysis/disk/place.hpp"
#include "analysis/disk/published_numbers.hpp"
#include "campaign/cli/output/answer.hpp"

namespace eerie::cli {

// What `eerie disk` answers.

Value to_json(const disk::Nebula& nebula);
std::string nebula_line(const disk::Nebula& nebula);
/// For programs: a row for each law of drag.
Table table_of_places(const std::vector<disk::Place>& places);
/// For people: a column for each law of drag.
Table turned_table_of_places(double r_au, const disk::PlaceQuestion& question,
                             const std::vector<disk::Place>& places);
Table table_of_published(const std::vector<disk::PublishedNumber>& numbers);

}  // namespace eerie::cli
