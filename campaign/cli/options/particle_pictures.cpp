#include "campaign/cli/options/particle_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "analysis/drawing/gnuplot.hpp"
#include "analysis/pictures/movie.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/cli/output/text_table.hpp"
#include "campaign/job_folder/job_directory.hpp"
#include "campaign/job_folder/snapshot_files.hpp"
#include "solver/base/error.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;
using nlohmann::json;

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

/// The scale that `part` of the panels do not exceed.
pictures::ColourScale common_scale(std::vector<pictures::ColourScale> scales, double part) {
  std::ranges::sort(scales, {}, &pictures::ColourScale::top);
  pictures::ColourScale scale =
      scales[static_cast<std::size_t>(part * static_cast<double>(scales.size() - 1))];
  for (const pictures::ColourScale& s : scales) scale.highest = std::max(scale.highest, s.highest);
  return scale;
}

/// What pictures of one run share.
class Pictures {
 public:
  Pictures(const fs::path& folder, pictures::ParticleColour colour, bool cut)
      : series_(job_folder::snapshot_series(folder)), scale_{colour, 0, 0}, cut_(cut) {
    if (colour != pictures::ParticleColour::depth) return;
    const fs::path first = job_folder::JobDirectory{folder}.first_snapshot();
    if (!fs::exists(first))
      throw InputError(fmt::format(
          "{}: has no snapshot_0000.hdf5, which says how deep particles lay; give another --colour",
          folder.string()));
    depths_ = remnants::initial_depths(io::read_snapshot(first));
  }

  const std::vector<job_folder::SnapshotFile>& series() const { return series_; }
  const pictures::Frame& frame() const { return frame_; }
  const pictures::Layout& layout(std::size_t panel) const { return layouts_[panel]; }

  /// Looks at all snapshots once, for a frame that serves them all and a scale that serves `part`
  /// of them: the instant of the impact must not darken the rest of a film.
  void choose_frame(const std::vector<std::size_t>& chosen, std::optional<double> width,
                    double part) {
    layouts_.clear();
    std::vector<pictures::ColourScale> scales;
    for (const std::size_t k : chosen) {
      const io::Snapshot snapshot = io::read_snapshot(series_[k].path);
      layouts_.push_back(pictures::layout_of(snapshot));
      scales.push_back(pictures::colour_scale(scale_.colour, view(snapshot)));
    }
    scale_ = common_scale(std::move(scales), part);
    frame_ = pictures::frame_of(layouts_, width);
  }

  pictures::PanelsFigure figure(const std::vector<std::size_t>& chosen,
                                std::size_t first_layout = 0) const {
    pictures::PanelsFigure figure{{}, frame_.width, scale_};
    for (std::size_t p = 0; p < chosen.size(); ++p) {
      const io::Snapshot snapshot = io::read_snapshot(series_[chosen[p]].path);
      const pictures::Layout& layout = layouts_[first_layout + p];
      figure.panels.push_back(
          {snapshot.state.time,
           pictures::panel_image(view(snapshot), frame_, pictures::frame_centre(frame_, layout),
                                 scale_, pictures::panel_pixels(chosen.size())),
           pictures::remnants_outside(frame_, layout)});
    }
    return figure;
  }

 private:
  pictures::ParticleView view(const io::Snapshot& snapshot) const {
    return pictures::particle_view(snapshot, scale_.colour, depths_, cut_);
  }

  std::vector<job_folder::SnapshotFile> series_;
  std::vector<double> depths_;
  std::vector<pictures::Layout> layouts_;
  pictures::ColourScale scale_;
  bool cut_;
  pictures::Frame frame_;
};

void note_frame(json& report, const pictures::Frame& frame) {
  report["frame_width_m"] = frame.width;
  report["centred_on"] = frame.on_largest ? "largest remnant" : "centre of mass";
}

void draw_picture(const PictureArguments& a, const std::vector<double>& times, Pictures& pictures,
                  json& report) {
  const auto& series = pictures.series();
  const std::vector<std::size_t> chosen =
      times.empty() ? job_folder::telling(series) : job_folder::nearest(series, times);
  pictures.choose_frame(chosen, a.width, 1);
  make_folder_of(a.picture);
  pictures::draw_panels(a.picture, pictures.figure(chosen));
  for (std::size_t p = 0; p < chosen.size(); ++p)
    report["panels"].push_back(
        {{"requested_s", times.empty() ? json() : json(times[p])},
         {"time_s", series[chosen[p]].time},
         {"file", series[chosen[p]].path.string()},
         {"remnants_outside", pictures::remnants_outside(pictures.frame(), pictures.layout(p))}});
  note_frame(report, pictures.frame());
  report["pictures"].push_back(a.picture.string());
}

void draw_film(const PictureArguments& a, Pictures& pictures, json& report) {
  std::vector<std::size_t> all(pictures.series().size());
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = k;
  pictures.choose_frame(all, a.width, 0.9);
  make_folder_of(a.film);
  pictures::make_movie(a.film, all.size(), a.frames_per_s,
                       [&](std::size_t k) { return pictures.figure({k}, k); });
  report["frames"] = all.size();
  if (a.picture.empty()) note_frame(report, pictures.frame());
  report["pictures"].push_back(a.film.string());
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

json draw_pictures(const PictureArguments& a, const fs::path& folder) {
  // What cannot come to anything is refused before anything is read or written.
  if (a.picture.empty() && !a.panels.empty())
    throw InputError("--panels needs the file to draw into; for example -o panels.svg");
  if (!a.picture.empty()) drawing::gnuplot_terminal(a.picture, 1, 1);
  if (!a.film.empty()) pictures::require_movie(a.film);
  const std::vector<double> times = parse_times(a.panels);
  Pictures pictures(folder, colour_named(a.colour), a.cut);
  json report = {{"panels", json::array()}, {"frames", 0}, {"pictures", json::array()}};
  if (!a.picture.empty()) draw_picture(a, times, pictures, report);
  if (!a.film.empty()) draw_film(a, pictures, report);
  return report;
}

std::string pictures_text(const json& r) {
  std::string text;
  std::vector<std::vector<std::string>> rows = {{"panel", "asked s", "taken s", "snapshot"}};
  for (const json& p : r.at("panels"))
    rows.push_back({fmt::format("{}", rows.size()),
                    p.at("requested_s").is_null()
                        ? "-"
                        : fmt::format("{:g}", p.at("requested_s").get<double>()),
                    fmt::format("{:g}", p.at("time_s").get<double>()),
                    fs::path(p.at("file").get<std::string>()).filename().string()});
  if (rows.size() > 1) text += text_table(rows);
  if (r.at("frames") != 0) text += fmt::format("{} frames\n", r.at("frames").dump());
  text += fmt::format("{:.4g} m wide, about the {}\n", r.at("frame_width_m").get<double>(),
                      r.at("centred_on").get<std::string>());
  for (const json& picture : r.at("pictures")) text += picture.get<std::string>() + "\n";
  return text;
}

}  // namespace eerie::cli
