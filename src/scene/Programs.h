#pragma once
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

} // namespace stromar
