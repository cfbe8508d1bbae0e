#pragma once

namespace eerie::cli {

/// The program: reads the command line, runs one command, turns errors into exit codes.
int main(int argc, char** argv);

}  // namespace eerie::cli
