// SPDX-License-Identifier: BSD-3-Clause
// softshadows render: draw models or a scene with one technique, into a picture.

#ifndef Render_h
#define Render_h

namespace CLI
{
class App;
}

void DeclareRender(CLI::App& app);

#endif
