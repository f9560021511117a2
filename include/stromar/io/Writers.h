#pragma once
#include "stromar/model/ExportModel.h"
#include "stromar/util/FileSet.h"
#include <filesystem>

namespace stromar {

// Each writes a model to `path` (and files beside it) into `files`; the caller commits. They throw what CFileSet
// throws.

/// Wavefront OBJ and its material library. Metres, y up. Normals, texture coordinates, one object per mesh.
void writeObj(const ExportModel& model, const std::filesystem::path& path, CFileSet& files);

/// 3D Studio. Metres, z up; meshes cut below 65,536 vertices and faces. The format has no normals.
void write3ds(const ExportModel& model, const std::filesystem::path& path, CFileSet& files);

/// LightWave object, LWO2. Metres, y up, left-handed. The format has no normals.
void writeLwo(const ExportModel& model, const std::filesystem::path& path, CFileSet& files);

/// POV-Ray scene: the tree as an object `Tree`, a camera and lights that see all of it. Metres, y up, left-handed.
void writePov(const ExportModel& model, const std::filesystem::path& path, CFileSet& files);

/// glTF 2.0 in one file, or with its buffer beside it. Metres, y up. Normals, tangents, the channels of
/// the model, levels of detail by MSFT_lod. Pictures are embedded where `Material::texture` is empty.
void writeGlb(const ExportModel& model, const std::filesystem::path& path, CFileSet& files);
void writeGltf(const ExportModel& model, const std::filesystem::path& path, CFileSet& files);

/// FBX 7.4, binary. Centimetres, y up. Normals, tangents, colours, a second UV, levels of detail as an LOD group; pictures are embedded
/// where `Material::texture` is empty.
void writeFbx(const ExportModel& model, const std::filesystem::path& path, CFileSet& files);

/// USD as text, and as a package with its pictures. Metres, y up. Normals, texture coordinates, UsdPreviewSurface.
void writeUsda(const ExportModel& model, const std::filesystem::path& path, CFileSet& files);
void writeUsdz(const ExportModel& model, const std::filesystem::path& path, CFileSet& files);

/// COLLADA 1.4.1. Metres, y up. Normals, texture coordinates, normal maps as an extension that several programs read.
void writeDae(const ExportModel& model, const std::filesystem::path& path, CFileSet& files);

/// STL and PLY, binary. Metres, z up. Through assimp, which needs a copy of the model in memory.
void writeStl(const ExportModel& model, const std::filesystem::path& path, CFileSet& files);
void writePly(const ExportModel& model, const std::filesystem::path& path, CFileSet& files);

} // namespace stromar
