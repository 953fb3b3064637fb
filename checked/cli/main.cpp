// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/program.hpp"

int main(int argc, char** argv) { return oplus::run(argc, argv); }
