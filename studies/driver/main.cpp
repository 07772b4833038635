#include "studies/driver/command.hpp"

int main(int argc, char** argv) { return g27::run_program(argc, argv); }
