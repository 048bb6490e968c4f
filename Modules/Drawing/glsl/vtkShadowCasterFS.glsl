//VTK::System::Dec

// Depth alone is wanted.

//VTK::ShadowHoles::Dec

void main()
{
  //VTK::ShadowHoles::Impl
}
