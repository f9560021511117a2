#pragma once
#include "Shaders.h"
#include "stromar/scene/OsgGeometry.h"
#include <osg/Program>
#include <string>

namespace stromar {

inline osg::ref_ptr<osg::Program> makeProgram(const char* name, const std::string& vertex,
                                              const std::string& fragment) {
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName(name);
    program->addShader(new osg::Shader(osg::Shader::VERTEX, vertex));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, fragment));
    return program;
}

/// For the tree, whose leaves are instances.
inline osg::ref_ptr<osg::Program> makeTreeProgram(const char* name, const std::string& vertex,
                                                  const std::string& fragment) {
    osg::ref_ptr<osg::Program> program = makeProgram(name, kPlaceFunctions + vertex, fragment);
    program->addBindAttribLocation("look", kLookAttribute);
    program->addBindAttribLocation("instancePlace", kInstancePlaceAttribute);
    program->addBindAttribLocation("instanceTurn", kInstanceTurnAttribute);
    program->addBindAttribLocation("instanceWidth", kInstanceWidthAttribute);
    program->addBindAttribLocation("swayPlace", kSwayPlaceAttribute);
    return program;
}

} // namespace stromar
