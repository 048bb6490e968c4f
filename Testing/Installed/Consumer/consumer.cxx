// SPDX-License-Identifier: BSD-3-Clause
// consumer TECHNIQUE...: whether just these techniques are there, and can be made.

#include <vtkShadowPass.h>
#include <vtkShadowTechniques.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

int main(int argc, char* argv[])
{
  std::vector<std::string> expected(argv + 1, argv + argc);
  std::sort(expected.begin(), expected.end());
  std::vector<std::string> known;
  for (int i = 0; i < vtkShadowTechniques::GetNumberOfTechniques(); ++i)
  {
    known.emplace_back(vtkShadowTechniques::GetName(i));
    auto pass = vtkSmartPointer<vtkShadowPass>::Take(vtkShadowTechniques::Create(known.back()));
    if (!pass || pass->GetTechnique() != known.back())
    {
      std::cerr << known.back() << " cannot be made\n";
      return 1;
    }
    std::cout << known.back() << ": " << pass->GetClassName() << "\n";
  }
  if (known != expected)
  {
    std::cerr << "these are " << known.size() << " techniques, not the " << expected.size()
              << " that were built\n";
    return 1;
  }
  return 0;
}
