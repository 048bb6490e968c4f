// SPDX-License-Identifier: BSD-3-Clause
// softshadows bench: error against run time.

#ifndef Bench_h
#define Bench_h

#include <string>

namespace CLI
{
class App;
}

/** `commandLine` is what the user wrote, for the record. */
void DeclareBench(CLI::App& app, const std::string& commandLine);

#endif
