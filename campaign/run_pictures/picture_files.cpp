#include "campaign/run_pictures/picture_files.hpp"

#include <numeric>

#include "analysis/drawing/gnuplot.hpp"
#include "analysis/pictures/movie.hpp"
#include "campaign/run_pictures/run_pictures.hpp"

namespace eerie::run_pictures {
using text::both, text::data, text::shown;
using text::Value;

namespace {

text::Table table_of_panels(const std::vector<double>& times,
                            const std::vector<TellingMoment>& moments,
                            const std::vector<std::size_t>& chosen, const RunPictures& pictures) {
  text::Table table{
      {shown("panel"), both("requested_s", "asked s", "{:g}"), both("time_s", "taken s", "{:g}"),
       both("moment", "moment"), data("file"), shown("snapshot"), data("remnants_outside")},
      {}};
  for (std::size_t p = 0; p < chosen.size(); ++p) {
    const job_folder::SnapshotFile& snapshot = pictures.snapshots()[chosen[p]];
    table.rows.push_back({p + 1, times.empty() ? Value() : Value(times[p]), snapshot.time,
                          moments.empty() ? Value() : Value(std::string(moments[p].name)),
                          snapshot.path.string(), snapshot.path.filename().string(),
                          pictures::remnants_outside(pictures.frame(), pictures.layout(p))});
  }
  return table;
}

text::Table draw_panels(const PictureRequest& request, RunPictures& pictures) {
  const bool asked = !request.times.empty();
  const std::vector<TellingMoment> moments =
      asked ? std::vector<TellingMoment>() : telling_moments(pictures.course());
  std::vector<std::size_t> chosen =
      asked ? job_folder::nearest(pictures.snapshots(), request.times) : std::vector<std::size_t>();
  for (const TellingMoment& moment : moments) chosen.push_back(moment.snapshot);
  pictures.choose_frame(chosen, request.width, 1);
  pictures::PanelsFigure figure = pictures.figure(chosen);
  for (std::size_t p = 0; p < moments.size(); ++p) figure.panels[p].name = moments[p].name;
  pictures::draw_panels(request.panels, figure);
  return table_of_panels(request.times, moments, chosen, pictures);
}

void draw_film(const PictureRequest& request, RunPictures& pictures, const OnFrame& on_frame) {
  std::vector<std::size_t> all(pictures.snapshots().size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  pictures.choose_frame(all, request.width, 0.9);
  pictures::make_movie(request.film, all.size(), request.frames_per_s, [&](std::size_t k) {
    if (on_frame) on_frame(k, all.size());
    return pictures.figure({k}, k);
  });
}

}  // namespace

void require_drawable(const PictureRequest& request) {
  if (!request.panels.empty()) drawing::require_figure_file(request.panels);
  if (!request.film.empty()) pictures::require_movie(request.film);
}

DrawnPictures draw(const PictureRequest& request, const std::filesystem::path& folder,
                   const OnFrame& on_frame) {
  RunPictures pictures(folder, request.colour, request.cut);
  DrawnPictures drawn;
  if (!request.panels.empty()) {
    drawn.panels = draw_panels(request, pictures);
    drawn.frame = pictures.frame();
  }
  if (request.film.empty()) return drawn;
  draw_film(request, pictures, on_frame);
  drawn.frames = pictures.snapshots().size();
  if (request.panels.empty()) drawn.frame = pictures.frame();
  return drawn;
}

}  // namespace eerie::run_pictures
