// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ShadowSceneMesh
 * @brief   Collects triangles with point normals: grids, spheres, tubes, boxes, beams.
 *
 * Every solid is closed and its triangles are counter-clockwise seen from outside. Faces that meet in
 * a sharp edge have points of their own there. All lengths are world units, all angles radians.
 */

#ifndef ShadowSceneMesh_h
#define ShadowSceneMesh_h

#include "vtkSmartPointer.h" // For the poly data
#include "vtkType.h"         // For vtkIdType
#include "vtkVector.h"       // For vtkVector3d

#include <functional>
#include <vector>

class vtkPolyData;

class ShadowSceneMesh
{
public:
  using Surface = std::function<void(double u, double v, vtkVector3d& point, vtkVector3d& normal)>;

  vtkIdType GetNumberOfTriangles() const;

  /**
   * 2 * nu * nv triangles over u, v in [0, 1]; a direction that wraps shares its first and last
   * points. The surface must be oriented so that (d/du) x (d/dv) points along the normal.
   */
  void AddGrid(int nu, int nv, bool wrapU, bool wrapV, const Surface& surface);

  /**
   * Ellipsoid with its axis along z: 2 * around * (rows - 1) triangles.
   */
  void AddSphere(const vtkVector3d& center, const vtkVector3d& radii, int around, int rows);
  void AddSphere(const vtkVector3d& center, double radius, int around, int rows);

  /**
   * Tube along a path with a radius at each of its points. An end with a radius is closed with a
   * flat cap (`sides` triangles), an end with radius 0 is a tip. Two equal path points with
   * different radii would have no direction: do not pass such.
   */
  void AddTube(const std::vector<vtkVector3d>& path, const std::vector<double>& radii, int sides);
  void AddTube(const std::vector<vtkVector3d>& path, double radius, int sides);

  /**
   * Vessel from one point to another: a cylinder of that radius with domed (elliptic) ends that lie
   * beyond the points by `dome`.
   */
  void AddVessel(
    const vtkVector3d& from, const vtkVector3d& to, double radius, double dome, int sides);

  /**
   * Parallelepiped with the three half axes (right-handed), each cut into as many pieces as told:
   * 4 * (nx * ny + ny * nz + nz * nx) triangles.
   */
  void AddBox(const vtkVector3d& center, const vtkVector3d& halfX, const vtkVector3d& halfY,
    const vtkVector3d& halfZ, int nx = 1, int ny = 1, int nz = 1);

  /**
   * Box upright on z, turned about z by an angle.
   */
  void AddBox(const vtkVector3d& center, const vtkVector3d& halfSize, double angle = 0.0);

  /**
   * Beam from one point to another: a box section, or an I section made of three boxes. The
   * section's height runs as close to `up` as it can.
   */
  void AddBeam(const vtkVector3d& from, const vtkVector3d& to, double width, double height,
    const vtkVector3d& up);
  void AddIBeam(const vtkVector3d& from, const vtkVector3d& to, double width, double height,
    const vtkVector3d& up);

  /**
   * The corners of a path replaced with arcs of that radius (less where a leg is short).
   */
  static std::vector<vtkVector3d> RoundPath(
    const std::vector<vtkVector3d>& corners, double radius, int segments);

  vtkSmartPointer<vtkPolyData> MakePolyData() const;

private:
  vtkIdType AddPoint(const vtkVector3d& point, const vtkVector3d& normal);
  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c);
  void AddCap(vtkIdType ring, int sides, const vtkVector3d& center, const vtkVector3d& normal);

  std::vector<float> Points;
  std::vector<float> Normals;
  std::vector<vtkIdType> Connectivity;
};

#endif
