#include "campaign/cli/options/particle_pictures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "analysis/drawing/gnuplot.hpp"
#include "analysis/pictures/movie.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/run_pictures/run_pictures.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;

namespace {

struct ColourName {
  const char* name;
  pictures::ParticleColour colour;
};
constexpr std::array<ColourName, 3> colour_names = {{{"body", pictures::ParticleColour::body},
                                                     {"depth", pictures::ParticleColour::depth},
                                                     {"speed", pictures::ParticleColour::speed}}};

pictures::ParticleColour colour_named(const std::string& name) {
  return std::ranges::find_if(colour_names, [&](const ColourName& c) { return c.name == name; })
      ->colour;
}

/// "0, 5e3,1e4" in s.
std::vector<double> parse_times(const std::string& text) {
  constexpr std::size_t most = 50;
  std::vector<double> times;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    std::size_t used = 0;
    double time = -1;
    try {
      time = std::stod(word, &used);
    } catch (const std::logic_error&) {
    }
    if (used == 0 || used != word.size() || !(time >= 0) || !std::isfinite(time))
      throw InputError(fmt::format(
          "--panels {}: must be times in s with commas between them; for example --panels "
          "0,5000,10000",
          text));
    times.push_back(time);
  }
  if (times.size() > most)
    throw InputError(fmt::format("--panels: {} panels are too many for a page, {} are the most",
                                 times.size(), most));
  return times;
}

/// The panels, taken and asked for, and what they leave out.
Table table_of_panels(const std::vector<double>& times, const std::vector<std::size_t>& chosen,
                      const run_pictures::RunPictures& pictures) {
  Table table{
      {shown("panel"), both("requested_s", "asked s", "{:g}"), both("time_s", "taken s", "{:g}"),
       data("file"), shown("snapshot"), data("remnants_outside")},
      {}};
  for (std::size_t p = 0; p < chosen.size(); ++p) {
    const job_folder::SnapshotFile& snapshot = pictures.series()[chosen[p]];
    table.rows.push_back({p + 1, times.empty() ? Value() : Value(times[p]), snapshot.time,
                          snapshot.path.string(), snapshot.path.filename().string(),
                          pictures::remnants_outside(pictures.frame(), pictures.layout(p))});
  }
  return table;
}

Table draw_picture(const PictureArguments& a, const std::vector<double>& times,
                   run_pictures::RunPictures& pictures) {
  const auto& series = pictures.series();
  const std::vector<std::size_t> chosen =
      times.empty() ? job_folder::telling(series) : job_folder::nearest(series, times);
  pictures.choose_frame(chosen, a.width, 1);
  text::require_folder_of(a.picture);
  pictures::draw_panels(a.picture, pictures.figure(chosen));
  return table_of_panels(times, chosen, pictures);
}

void draw_film(const PictureArguments& a, run_pictures::RunPictures& pictures) {
  std::vector<std::size_t> all(pictures.series().size());
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = k;
  pictures.choose_frame(all, a.width, 0.9);
  text::require_folder_of(a.film);
  pictures::make_movie(a.film, all.size(), a.frames_per_s,
                       [&](std::size_t k) { return pictures.figure({k}, k); });
}

const char* centre_of(const pictures::Frame& frame) {
  return frame.on_largest ? "largest remnant" : "centre of mass";
}

}  // namespace

void add_pictures(CLI::App& app, PictureArguments& a) {
  app.add_option("-o,--output", a.picture,
                 "draw panels of the particles, seen along the axis of the orbit, into this file "
                 "(.svg, .png, .pdf)");
  app.add_option("--panels", a.panels,
                 "times of the panels, s, with commas; the nearest snapshots are taken (default: "
                 "five of those that there are)");
  app.add_option("--movie", a.film, "make every snapshot a frame of this film (.mp4, .gif)");
  app.add_option("--frames-per-second", a.frames_per_s, "of the film")
      ->check(CLI::Range(0.1, 120.0))
      ->capture_default_str();
  std::vector<std::string> names;
  for (const ColourName& c : colour_names) names.emplace_back(c.name);
  app.add_option("--colour,--color", a.colour,
                 "of the particles: body (target, impactor), depth (at the start, below the "
                 "surface of the own body) or speed (in the own clump)")
      ->check(CLI::IsMember(names))
      ->capture_default_str();
  app.add_flag("--cut", a.cut,
               "leave out the half before the plane of the orbit: the inside is seen");
  app.add_option("--width", a.width,
                 "width of what a panel shows, m (default: all remnants, up to three times both "
                 "bodies' diameters)")
      ->check(CLI::Range(1e-3, 1e9));
}

Answer draw_pictures(const PictureArguments& a, const fs::path& folder) {
  // What cannot come to anything is refused before anything is read or written.
  if (a.picture.empty() && !a.panels.empty())
    throw InputError("--panels needs the file to draw into; for example -o panels.svg");
  if (!a.picture.empty()) drawing::gnuplot_terminal(a.picture, 1, 1);
  if (!a.film.empty()) pictures::require_movie(a.film);
  const std::vector<double> times = parse_times(a.panels);
  run_pictures::RunPictures pictures(folder, colour_named(a.colour), a.cut);
  Table panels;
  std::vector<fs::path> files;
  if (!a.picture.empty()) panels = draw_picture(a, times, pictures), files.push_back(a.picture);
  const pictures::Frame of_panels = pictures.frame();
  if (!a.film.empty()) draw_film(a, pictures), files.push_back(a.film);
  const pictures::Frame& frame = a.picture.empty() ? pictures.frame() : of_panels;
  const std::size_t frames = a.film.empty() ? 0 : pictures.series().size();
  Answer answer;
  answer.data = {{"panels", records(panels)},
                 {"frames", frames},
                 {"frame_width_m", frame.width},
                 {"centred_on", centre_of(frame)},
                 {"pictures", names_of(files)}};
  answer.add(std::move(panels));
  if (frames > 0) answer.say("{} frames\n", frames);
  answer.say("{:.4g} m wide, about the {}\n", frame.width, centre_of(frame));
  answer.add_files(files);
  return answer;
}

}  // namespace eerie::cli
