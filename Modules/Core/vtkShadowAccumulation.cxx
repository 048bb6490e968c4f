// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowAccumulation.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkShadowCasters.h"
#include "vtkShadowFrame.h"
#include "vtkShadowTags.h"
#include "vtkShadowTechnique.h"
#include "vtkTexture.h"
#include "vtkUniforms.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace
{
void Add(std::vector<double>& numbers, const glm::dmat4& matrix)
{
  const double* values = glm::value_ptr(matrix);
  numbers.insert(numbers.end(), values, values + 16);
}

/** When the shaders of a prop, or the uniforms that users set of them, last changed. */
vtkMTimeType GetShaderTime(vtkProp* prop)
{
  vtkShaderProperty* shaders = prop->GetShaderProperty();
  vtkMTimeType time = shaders ? shaders->GetMTime() : 0;
  if (shaders)
  {
    for (vtkUniforms* uniforms : { shaders->GetVertexCustomUniforms(),
           shaders->GetGeometryCustomUniforms(), shaders->GetFragmentCustomUniforms() })
    {
      time = std::max(time, uniforms->GetMTime());
    }
  }
  return time;
}

/** When the surfaces that a mapper draws last changed. */
vtkMTimeType GetTime(vtkMapper* mapper)
{
  vtkMTimeType time = mapper->GetMTime();
  if (mapper->GetNumberOfInputConnections(0) > 0)
  {
    mapper->GetInputAlgorithm()->Update();
  }
  if (vtkDataObject* input = mapper->GetInputDataObject(0, 0))
  {
    time = std::max(time, input->GetMTime());
  }
  if (vtkPlaneCollection* planes = mapper->GetClippingPlanes())
  {
    for (int i = 0; i < planes->GetNumberOfItems(); ++i)
    {
      time = std::max(time, planes->GetItem(i)->GetMTime());
    }
  }
  return time;
}

}

//------------------------------------------------------------------------------
bool vtkShadowAccumulation::Scenery::operator==(const Scenery& other) const
{
  const auto same = [](const vtkShadowLightPart& a, const vtkShadowLightPart& b)
  {
    return a.SameGeometry(b) && a.Share == b.Share && a.Light.Light == b.Light.Light &&
           a.Light.Slot == b.Light.Slot;
  };
  return this->Numbers == other.Numbers && this->Objects == other.Objects &&
         this->Times == other.Times &&
         std::equal(
           this->Parts.begin(), this->Parts.end(), other.Parts.begin(), other.Parts.end(), same);
}

//------------------------------------------------------------------------------
vtkShadowAccumulation::Scenery vtkShadowAccumulation::Describe(const vtkShadowFrame& frame,
  const std::vector<vtkSmartPointer<vtkProp>>& props, vtkMTimeType time)
{
  Scenery scenery;
  scenery.Parts = frame.Parts;
  scenery.Times = { time, frame.Casters->GetVersion(), frame.Casters->GetReceiverVersion() };
  scenery.Numbers = { static_cast<double>(frame.Size[0]), static_cast<double>(frame.Size[1]) };
  Add(scenery.Numbers, frame.VCToSWC);
  Add(scenery.Numbers, frame.VCToClip);
  for (const auto& prop : props)
  {
    const double tags = (vtkShadowTags::GetReceiving(prop) ? 1.0 : 0.0) +
                        (vtkShadowTags::GetShadowCatcher(prop) ? 2.0 : 0.0);
    scenery.Numbers.push_back(tags);
    vtkShadowTags::ForEachPart(prop,
      [&scenery](vtkProp* part, vtkMatrix4x4* matrix)
      {
        scenery.Objects.push_back(part);
        scenery.Times.push_back(GetShaderTime(part));
        auto* actor = vtkActor::SafeDownCast(part);
        if (actor && actor->GetMapper())
        {
          // Not the actor's own time: drawing it gives it keys, and an assembly lends it others.
          vtkTexture* texture = actor->GetTexture();
          scenery.Objects.insert(
            scenery.Objects.end(), { actor->GetProperty(), actor->GetMapper(), texture });
          scenery.Times.insert(
            scenery.Times.end(), { actor->GetProperty()->GetMTime(), GetTime(actor->GetMapper()),
                                   texture ? texture->GetMTime() : 0 });
        }
        else
        {
          scenery.Times.push_back(part->GetRedrawMTime());
        }
        Add(scenery.Numbers, glm::make_mat4(matrix->GetData()));
      });
  }
  return scenery;
}

//------------------------------------------------------------------------------
void vtkShadowAccumulation::Begin(vtkShadowFrame& frame,
  const std::vector<vtkSmartPointer<vtkProp>>& props, vtkShadowTechnique& technique,
  vtkMTimeType time)
{
  if (frame.Hard || technique.GetWantedSamples() == 0)
  {
    this->Forget();
    technique.BeginFrame(false);
    return;
  }
  Scenery scenery = Describe(frame, props, time);
  const bool still = scenery == this->Known;
  this->Known = std::move(scenery);
  technique.BeginFrame(still);
  this->Samples = technique.GetSamples();
  this->On = this->Samples > 0;
  if (!still || !this->On)
  {
    this->Frames = 0;
  }
  // One that does not add up yet, but wants to, is not finished.
  this->Wanted = this->On ? (technique.GetWantedSamples() + this->Samples - 1) / this->Samples : 1;
  if (!this->On)
  {
    return;
  }
  // The last frame's again where there is nothing to be added.
  const int first = std::min(this->Frames, this->Wanted - 1) * this->Samples;
  for (auto& light : frame.Lights)
  {
    light.FirstSample = first;
  }
  for (auto& part : frame.Parts)
  {
    part.Light.FirstSample = first;
  }
}

//------------------------------------------------------------------------------
void vtkShadowAccumulation::Count()
{
  ++this->Frames;
}

//------------------------------------------------------------------------------
void vtkShadowAccumulation::Forget()
{
  this->Known = {};
  this->Frames = 0;
  this->Wanted = 0;
}

//------------------------------------------------------------------------------
void vtkShadowAccumulation::End(vtkShadowFrame& frame, bool active)
{
  if (this->On && active)
  {
    frame.Counts["accumulatedFrames"] = this->Frames;
    frame.Counts["accumulatedSamples"] = static_cast<double>(this->Frames) * this->Samples;
  }
  if (!active)
  {
    this->Forget();
  }
  this->On = false;
}
