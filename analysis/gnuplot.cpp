#include "analysis/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "solver/base/error.hpp"
#include "solver/base/file.hpp"

namespace eerie {

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// A nameless file that is gone when closed; it cannot fill up and block as a pipe does.
File nameless() {
  File file(std::tmpfile(), std::fclose);
  if (!file)
    throw EnvironmentError(fmt::format("cannot make a temporary file: {}", std::strerror(errno)));
  return file;
}

std::string content(std::FILE* file) {
  std::rewind(file);
  std::string text;
  std::array<char, 4096> buffer;
  for (std::size_t n; (n = std::fread(buffer.data(), 1, buffer.size(), file)) > 0;)
    text.append(buffer.data(), n);
  return text;
}

/// Exit status of gnuplot with these three files for stdin, stdout and stderr.
int spawn_and_wait(int in, int out, int err) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err, STDERR_FILENO);
  // -d: the user's own ~/.gnuplot must not change our figures.
  std::array<char*, 4> arguments = {const_cast<char*>("gnuplot"), const_cast<char*>("-d"),
                                    const_cast<char*>("-"), nullptr};
  pid_t pid = 0;
  const int error = ::posix_spawnp(&pid, "gnuplot", &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT)
    throw EnvironmentError(
        "gnuplot is not installed and draws the maps; install it: apt-get install gnuplot-nox");
  if (error != 0)
    throw EnvironmentError(fmt::format("cannot start gnuplot: {}", std::strerror(error)));
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0)
    if (errno != EINTR)
      throw EnvironmentError(fmt::format("cannot wait for gnuplot: {}", std::strerror(errno)));
  return status;
}

}  // namespace

std::string gnuplot_terminal(const std::filesystem::path& path, double width_pt, double height_pt) {
  const std::string extension = path.extension().string();
  const char* font = "font 'DejaVu Sans,7' enhanced";
  // The scales make type and lines as large in print as the script asks for.
  if (extension == ".pdf")
    return fmt::format("set terminal pdfcairo size {}in,{}in fontscale 0.75 linewidth 2 {}\n",
                       width_pt / 72, height_pt / 72, font);
  if (extension == ".svg")
    return fmt::format("set terminal svg size {},{} dynamic background '#ffffff' {}\n", width_pt,
                       height_pt, font);
  constexpr double zoom = 5;  // pixels per point
  if (extension == ".png")
    return fmt::format("set terminal pngcairo size {:.0f},{:.0f} fontscale {} linewidth {} {}\n",
                       zoom * width_pt, zoom * height_pt, 0.75 * zoom, zoom, font);
  throw InputError(fmt::format("{}: a figure can be .png, .svg or .pdf", path.string()));
}

void run_gnuplot(const std::string& script, const std::filesystem::path& path) {
  install_file(path, [&](const std::filesystem::path& temporary) {
    const File in = nameless(), err = nameless();
    if (std::fwrite(script.data(), 1, script.size(), in.get()) != script.size() ||
        std::fflush(in.get()) != 0)
      throw EnvironmentError(
          fmt::format("cannot write gnuplot's script: {}", std::strerror(errno)));
    std::rewind(in.get());
    const File out(std::fopen(temporary.c_str(), "w+e"), std::fclose);
    if (!out)
      throw EnvironmentError(
          fmt::format("cannot create {}: {}", temporary.string(), std::strerror(errno)));
    const int status = spawn_and_wait(::fileno(in.get()), ::fileno(out.get()), ::fileno(err.get()));
    if (status != 0 || std::filesystem::file_size(temporary) == 0)
      throw EnvironmentError(
          fmt::format("gnuplot could not draw {}: {}", path.string(), content(err.get())));
  });
}

}  // namespace eerie
