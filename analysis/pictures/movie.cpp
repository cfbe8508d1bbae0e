#include "analysis/pictures/movie.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include "analysis/drawing/tool.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"

namespace eerie::pictures {
namespace fs = std::filesystem;

namespace {

const drawing::Tool ffmpeg{"ffmpeg", "makes the films", "ffmpeg"};

/// Removed with all that is in it.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string pattern = (fs::temp_directory_path() / "eerie-film-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr)
      throw EnvironmentError("cannot make a temporary folder " + pattern);
    path = pattern;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  fs::path path;
};

/// What turns numbered frames into a film of the format. Players want sides that are even.
std::vector<std::string> encoding(const fs::path& path) {
  if (path.extension() == ".gif")
    return {"-vf",
            "scale=640:-1:flags=lanczos,split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=none",
            "-f", "gif"};
  return {"-vf",       "scale=trunc(iw/2)*2:trunc(ih/2)*2",
          "-c:v",      "libx264",
          "-crf",      "20",
          "-pix_fmt",  "yuv420p",
          "-movflags", "+faststart",
          "-f",        "mp4"};
}

}  // namespace

void require_movie(const fs::path& path) {
  if (path.extension() != ".mp4" && path.extension() != ".gif")
    throw InputError(fmt::format("{}: a film can be .mp4 or .gif", path.string()));
  drawing::require_tool(ffmpeg);
}

void make_movie(const fs::path& path, std::size_t frames, double frames_per_s,
                const std::function<PanelsFigure(std::size_t)>& figure) {
  require_movie(path);
  if (frames == 0) throw InputError(path.string() + ": there are no frames");
  const ScratchFolder scratch;
  for (std::size_t k = 0; k < frames; ++k)
    draw_panels(scratch.path / fmt::format("frame_{:06d}.png", k), figure(k));
  install_file(path, [&](const fs::path& temporary) {
    std::vector<std::string> words = {"-nostdin",   "-y",
                                      "-loglevel",  "error",
                                      "-framerate", fmt::format("{:g}", frames_per_s),
                                      "-i",         (scratch.path / "frame_%06d.png").string()};
    for (const std::string& word : encoding(path)) words.push_back(word);
    words.push_back(temporary.string());
    const drawing::ToolEnd end = drawing::run_tool(ffmpeg, words);
    if (!end.well || fs::file_size(temporary) == 0)
      throw EnvironmentError(fmt::format("ffmpeg could not make {}: {}", path.string(), end.words));
  });
}

}  // namespace eerie::pictures
