#include "campaign/cli/cli.hpp"

int main(int argc, char** argv) { return eerie::cli::main(argc, argv); }
