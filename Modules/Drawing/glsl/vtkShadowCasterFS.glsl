// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// Depth alone is wanted.

//VTK::ShadowHoles::Dec

void main()
{
  //VTK::ShadowHoles::Impl
}
