#pragma once
#include "stromar/model/ExportModel.h"
#include "stromar/util/FileSet.h"
#include <filesystem>

namespace stromar {

/// OpenSceneGraph's own formats, through osgDB: `.osg` (old text), `.osgt` (text), `.osgb` (binary), by the ending of
/// `path`. Metres, z up. Pictures are referred to, not embedded. The caller commits.
void writeOsg(const ExportModel& model, const std::filesystem::path& path, CFileSet& files);

} // namespace stromar
