// SPDX-License-Identifier: BSD-3-Clause
#include "ViewOverlay.h"

#include "vtkCellArray.h"
#include "vtkCoordinate.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRenderWindow.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <sstream>

namespace
{
constexpr int LargestText = 14; // pixels
constexpr int Margin = 6;

void SetUp(vtkTextActor* actor)
{
  vtkTextProperty* property = actor->GetTextProperty();
  property->SetFontFamilyToCourier();
  property->SetFontSize(LargestText);
  property->SetColor(1.0, 1.0, 1.0);
  property->SetBackgroundColor(0.1, 0.1, 0.12);
  property->SetBackgroundOpacity(0.7);
  actor->SetVisibility(false);
}

void Anchor(vtkTextActor* actor, double x, double y)
{
  actor->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  actor->SetPosition(x, y);
}
}

//------------------------------------------------------------------------------
ViewOverlay::ViewOverlay()
{
  this->Renderer->SetLayer(1);
  this->Renderer->InteractiveOff();
  this->Renderer->AutomaticLightCreationOff();

  this->PictureMapper->SetColorWindow(255.0);
  this->PictureMapper->SetColorLevel(127.5);
  this->Picture->SetMapper(this->PictureMapper);
  this->Picture->SetVisibility(false);
  this->Picture->SetLayerNumber(0);
  this->Renderer->AddViewProp(this->Picture);

  this->Ends->SetNumberOfPoints(2);
  vtkNew<vtkCellArray> line;
  line->InsertNextCell({ 0, 1 });
  vtkNew<vtkPolyData> data;
  data->SetPoints(this->Ends);
  data->SetLines(line);
  vtkNew<vtkCoordinate> shares;
  shares->SetCoordinateSystemToNormalizedViewport();
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  mapper->SetTransformCoordinate(shares);
  this->Divider->SetMapper(mapper);
  this->Divider->GetProperty()->SetColor(1.0, 1.0, 1.0);
  this->Divider->GetProperty()->SetLineWidth(2.0f);
  this->Divider->SetVisibility(false);
  this->Divider->SetLayerNumber(1);
  this->Renderer->AddViewProp(this->Divider);

  for (vtkTextActor* actor : { this->Info.Get(), this->Status.Get(), this->Help.Get() })
  {
    SetUp(actor);
    actor->SetLayerNumber(2);
    this->Renderer->AddViewProp(actor);
  }
  Anchor(this->Info, 0.01, 0.99);
  this->Info->GetTextProperty()->SetVerticalJustificationToTop();
  Anchor(this->Status, 0.01, 0.01);
  Anchor(this->Help, 0.5, 0.5);
  this->Help->GetTextProperty()->SetBackgroundOpacity(0.95);
  this->Help->GetTextProperty()->SetVerticalJustificationToCentered();
  this->Help->GetTextProperty()->SetJustificationToCentered();
}

//------------------------------------------------------------------------------
void ViewOverlay::PutOn(vtkRenderWindow* window)
{
  window->SetNumberOfLayers(2);
  window->AddRenderer(this->Renderer);
}

//------------------------------------------------------------------------------
void ViewOverlay::SetShown(bool shown)
{
  this->Renderer->SetDraw(shown);
}

//------------------------------------------------------------------------------
// As large as the window allows.
void ViewOverlay::Fill(vtkTextActor* actor, const std::string& text)
{
  actor->SetVisibility(!text.empty());
  if (text.empty())
  {
    return;
  }
  const auto lines = static_cast<int>(std::count(text.begin(), text.end(), '\n')) + 1;
  std::size_t longest = 1;
  for (std::size_t start = 0; start <= text.size();)
  {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    longest = std::max(longest, end - start);
    start = end + 1;
  }
  const int* size = this->Renderer->GetRenderWindow()->GetSize();
  // A line of Courier is 1.2 times its size high, a letter 0.6 times wide.
  const double height = (size[1] - 2 * Margin) / (1.2 * lines);
  const double width = (size[0] - 2 * Margin) / (0.62 * static_cast<double>(longest));
  actor->GetTextProperty()->SetFontSize(
    std::clamp(static_cast<int>(std::min(height, width)), 5, LargestText));
  actor->SetInput(text.c_str());
}

//------------------------------------------------------------------------------
void ViewOverlay::SetInfo(const std::string& text)
{
  this->Fill(this->Info, text);
}

//------------------------------------------------------------------------------
void ViewOverlay::SetStatus(const std::string& text)
{
  this->Fill(this->Status, text);
}

//------------------------------------------------------------------------------
void ViewOverlay::SetHelp(const std::string& text)
{
  // Lines of one length, which stand in columns though the whole is in the middle.
  std::vector<std::string> lines;
  std::size_t longest = 0;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
  {
    longest = std::max(longest, line.size());
    lines.push_back(line);
  }
  std::string whole;
  for (std::string& line : lines)
  {
    line.resize(longest, ' ');
    whole += (whole.empty() ? "" : "\n") + line;
  }
  this->Fill(this->Help, whole);
}

//------------------------------------------------------------------------------
void ViewOverlay::SetDivider(bool shown, double share)
{
  this->Divider->SetVisibility(shown);
  this->Ends->SetPoint(0, share, 0.0, 0.0);
  this->Ends->SetPoint(1, share, 1.0, 0.0);
  this->Ends->Modified();
}

//------------------------------------------------------------------------------
void ViewOverlay::SetPicture(vtkImageData* picture)
{
  this->Picture->SetVisibility(picture != nullptr);
  if (picture)
  {
    this->PictureMapper->SetInputData(picture);
  }
}

//------------------------------------------------------------------------------
int ViewOverlay::GetLineHeight() const
{
  const int* size = this->Renderer->GetRenderWindow()->GetSize();
  const int lines = std::max(static_cast<int>(this->Lines.size()), 1);
  return std::clamp((size[1] - 2 * Margin) / lines, 6, LargestText + 6);
}

//------------------------------------------------------------------------------
void ViewOverlay::OpenMenu(const std::vector<std::string>& lines, const int place[2])
{
  this->CloseMenu();
  this->Lines = lines;
  const int height = this->GetLineHeight();
  const int* size = this->Renderer->GetRenderWindow()->GetSize();
  std::size_t longest = 1;
  for (const std::string& line : lines)
  {
    longest = std::max(longest, line.size());
  }
  const int font = std::clamp(static_cast<int>(height / 1.4), 5, LargestText);
  const int width = static_cast<int>(0.62 * font * static_cast<double>(longest));
  const int whole = height * static_cast<int>(lines.size());
  this->Top[0] = std::clamp(place[0], 0, std::max(size[0] - width, 0));
  this->Top[1] = std::clamp(place[1], std::min(whole, size[1]), size[1]);
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    auto actor = vtkSmartPointer<vtkTextActor>::New();
    SetUp(actor);
    std::string text = lines[i];
    text.resize(longest, ' ');
    actor->SetInput(text.c_str());
    actor->GetTextProperty()->SetFontSize(font);
    actor->GetTextProperty()->SetBackgroundOpacity(0.9);
    actor->SetPosition(this->Top[0], this->Top[1] - height * (static_cast<int>(i) + 1) + 2);
    actor->SetLayerNumber(3);
    actor->SetVisibility(true);
    this->Renderer->AddViewProp(actor);
    this->Menu.push_back(actor);
  }
}

//------------------------------------------------------------------------------
void ViewOverlay::CloseMenu()
{
  for (const auto& actor : this->Menu)
  {
    this->Renderer->RemoveViewProp(actor);
  }
  this->Menu.clear();
  this->Lines.clear();
}

//------------------------------------------------------------------------------
int ViewOverlay::Point(const int place[2])
{
  const int below = this->Top[1] - place[1];
  const int line = below < 0 ? -1 : below / this->GetLineHeight();
  const bool beside =
    line < 0 || line >= static_cast<int>(this->Lines.size()) || place[0] < this->Top[0];
  for (std::size_t i = 0; i < this->Menu.size(); ++i)
  {
    const bool chosen = !beside && static_cast<int>(i) == line;
    this->Menu[i]->GetTextProperty()->SetColor(1.0, chosen ? 0.8 : 1.0, chosen ? 0.2 : 1.0);
  }
  return beside ? -1 : line;
}
