//VTK::System::Dec

// Depth alone is wanted.

void main()
{
}
