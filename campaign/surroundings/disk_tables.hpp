#pragma once

#include <string>
#include <vector>

#include "campaign/surroundings/disk_answer.hpp"
#include "campaign/text/table.hpp"

namespace eerie::surroundings {

/// The nebula at one distance, in a line.
std::string nebula_line(const disk::Nebula& nebula);
/// For programs: a row for each law of drag.
text::Table table_of_places(const std::vector<disk::Place>& places);
/// For people: a column for each law of drag.
text::Table turned_table_of_places(const DiskQuestion& question,
                                   const std::vector<disk::Place>& places);
/// The numbers of the paper beside those of its formulas.
text::Table table_of_published(const std::vector<disk::PublishedNumber>& numbers);

}  // namespace eerie::surroundings
