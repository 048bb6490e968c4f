// SPDX-License-Identifier: BSD-3-Clause
// softshadows list: the techniques with their parameters, and the built-in scenes.

#ifndef List_h
#define List_h

namespace CLI
{
class App;
}

void DeclareList(CLI::App& app);

#endif
