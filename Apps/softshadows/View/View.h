// SPDX-License-Identifier: BSD-3-Clause
// softshadows view: an interactive window.

#ifndef View_h
#define View_h

namespace CLI
{
class App;
}

void DeclareView(CLI::App& app);

#endif
