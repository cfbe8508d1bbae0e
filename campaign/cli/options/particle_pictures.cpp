#include "campaign/cli/options/particle_pictures.hpp"

#include "campaign/cli/output/complain.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/cli/output/status_line.hpp"
#include "campaign/queries/numbers.hpp"
#include "db/store/bind.hpp"

namespace eerie::cli {

void add_pictures(CLI::App& app, PictureArguments& a) {
  run_pictures::PictureRequest& r = a.request;
  app.add_option("-o,--output", r.panels,
                 "draw panels of the particles, seen along the axis of the orbit, into this file "
                 "(.svg, .png, .pdf)");
  app.add_option("--panels", a.times,
                 "times of the panels, s, with commas; the nearest snapshots are taken (default: "
                 "contact, longest, first separation, fall-back, end)");
  app.add_option("--movie", r.film, "make every snapshot a frame of this film (.mp4, .gif)");
  app.add_option("--frames-per-second", r.frames_per_s, "of the film")
      ->check(CLI::Range(0.1, 120.0))
      ->capture_default_str();
  app.add_option("--colour,--color", a.colour,
                 "of the particles: body (target, impactor), depth (at the start, below the "
                 "surface of the own body) or speed (in the own clump)")
      ->check(CLI::IsMember(std::vector<std::string>(pictures::particle_colour_names.begin(),
                                                     pictures::particle_colour_names.end())))
      ->capture_default_str();
  app.add_flag("--cut", r.cut,
               "leave out the half before the plane of the orbit: the inside is seen");
  app.add_option("--width", r.width,
                 "width of what a panel shows, m (default: all remnants, up to three times both "
                 "bodies' diameters)")
      ->check(CLI::Range(1e-3, 1e9));
}

Answer draw_pictures(const PictureArguments& a, const std::filesystem::path& folder,
                     Format format) {
  run_pictures::PictureRequest request = a.request;
  if (request.panels.empty() && !a.times.empty())
    throw InputError("--panels needs the file to draw into; for example -o panels.svg");
  constexpr std::size_t most_panels = 50;  // of a page
  request.times = queries::parse_times(a.times, "--panels", most_panels);
  request.colour =
      db::enumerator<pictures::ParticleColour>(pictures::particle_colour_names, a.colour);
  run_pictures::require_drawable(request);
  std::vector<std::filesystem::path> files;
  for (const auto& file : {request.panels, request.film})
    if (!file.empty()) text::require_folder_of(file), files.push_back(file);
  CountLine line("frames drawn:", format);
  run_pictures::DrawnPictures drawn = run_pictures::draw(
      request, folder, [&](std::size_t done, std::size_t all) { line.show(done, all); });
  const char* centre = drawn.frame.on_largest ? "largest remnant" : "centre of mass";
  Answer answer;
  answer.data = {{"panels", records(drawn.panels)},
                 {"frames", drawn.frames},
                 {"frame_width_m", drawn.frame.width},
                 {"centred_on", centre},
                 {"pictures", names_of(files)}};
  answer.add(std::move(drawn.panels));
  if (drawn.frames > 0) answer.say("{} frames\n", drawn.frames);
  constexpr std::size_t few_frames = 10;
  if (drawn.frames > 0 && drawn.frames < few_frames)
    print_warnings(
        {fmt::format("a film of {} frame{}, as the run wrote so many snapshots; a run with "
                     "output.snapshot_interval_s writes more",
                     drawn.frames, drawn.frames == 1 ? "" : "s")});
  answer.say("{:.0f} m wide, about the centre of mass{}\n", drawn.frame.width,
             drawn.frame.on_largest ? ", or the largest remnant where not all have room" : "");
  answer.add_files(files);
  return answer;
}

}  // namespace eerie::cli
