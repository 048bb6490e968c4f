// SPDX-License-Identifier: BSD-3-Clause
// The files that a command writes: all of them when everything has succeeded, or none.

#ifndef Outputs_h
#define Outputs_h

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

class vtkImageData;

/**
 * No input is ever written to, nor what standard output goes to. Each file is planned before the work starts, which finds out what would keep it from being written;
 * staged under a temporary name beside its place; and put into its place by Commit. What was staged
 * and not committed is removed, also where the user interrupts the command.
 */
class Outputs
{
public:
  /** The inputs: what the command reads. */
  explicit Outputs(std::vector<std::string> inputs);
  ~Outputs();
  Outputs(const Outputs&) = delete;
  void operator=(const Outputs&) = delete;

  ///@{
  /**
   * Find out whether a file can be written: throw Failure if not, and WrongUsage if it was planned
   * before or is an input. A picture's format follows from its extension.
   */
  void PlanPicture(const std::string& path, int components);
  void PlanText(const std::string& path);
  /** A folder, which Commit makes if there is none. */
  void PlanFolder(const std::string& path);
  ///@}

  ///@{
  /** Write a file to disk under a temporary name; throw Failure if that cannot be done. */
  void StagePicture(const std::string& path, vtkImageData* image);
  void StageText(const std::string& path, const std::string& text);
  ///@}

  /** Put all that is staged into its place. */
  void Commit();

private:
  struct Staged
  {
    std::filesystem::path Temporary;
    std::filesystem::path Final;
    std::string Name; // as the user wrote it
  };
  class SignalGuard;

  std::filesystem::path GetPlace(const std::string& name) const;
  std::filesystem::path PlanFile(const std::string& path);
  std::filesystem::path GetTemporary(const std::filesystem::path& final);
  void WritePicture(
    const std::filesystem::path& temporary, const std::string& name, vtkImageData* image);
  void Guard();
  void MakeFolder(const std::filesystem::path& folder);

  std::vector<std::string> Inputs;
  std::vector<std::filesystem::path> Planned;
  std::vector<Staged> Files;
  std::vector<std::filesystem::path> MadeFolders; // the outer ones first
  std::unique_ptr<SignalGuard> Signals;
  int Counter = 0;
};

#endif
