// SPDX-License-Identifier: BSD-3-Clause
#include "Interruption.h"

namespace
{
volatile std::sig_atomic_t asked = 0;

void Note(int)
{
  asked = 1;
}
}

//------------------------------------------------------------------------------
Interruption::Interruption()
{
  struct sigaction action = {};
  action.sa_handler = Note;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  for (std::size_t i = 0; i < Signals.size(); ++i)
  {
    sigaction(Signals[i], nullptr, &this->Old[i]);
    if (this->Old[i].sa_handler != SIG_IGN)
    {
      sigaction(Signals[i], &action, nullptr);
    }
  }
}

//------------------------------------------------------------------------------
Interruption::~Interruption()
{
  for (std::size_t i = 0; i < Signals.size(); ++i)
  {
    sigaction(Signals[i], &this->Old[i], nullptr);
  }
}

//------------------------------------------------------------------------------
bool Interruption::IsAsked()
{
  return asked != 0;
}
