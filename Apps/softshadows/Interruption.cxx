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
  sigaction(SIGINT, &action, &this->Interrupt);
  sigaction(SIGTERM, &action, &this->Terminate);
}

//------------------------------------------------------------------------------
Interruption::~Interruption()
{
  sigaction(SIGINT, &this->Interrupt, nullptr);
  sigaction(SIGTERM, &this->Terminate, nullptr);
}

//------------------------------------------------------------------------------
bool Interruption::IsAsked()
{
  return asked != 0;
}
