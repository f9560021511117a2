#pragma once
#include "stromar/mesh/Mesh.h"
#include <cstring>
#include <memory>
#include <osg/Array>
#include <osg/PrimitiveSet>
#include <osg/State>

namespace stromar {

/// An array for OpenSceneGraph whose values lie elsewhere. It can be drawn and walked over, not written to files.
class CForeignArray : public osg::Array {
public:
    CForeignArray(Type type, int size, GLenum kind, std::size_t count, unsigned elementSize)
        : Array(type, size, kind), m_count(static_cast<unsigned>(count)), m_elementSize(elementSize) {}

    osg::Object* cloneType() const override { return nullptr; }
    osg::Object* clone(const osg::CopyOp&) const override { return nullptr; }
    void accept(osg::ArrayVisitor&) override {}
    void accept(osg::ConstArrayVisitor&) const override {}
    void accept(unsigned, osg::ValueVisitor&) override {}
    void accept(unsigned, osg::ConstValueVisitor&) const override {}
    int compare(unsigned a, unsigned b) const override {
        return std::memcmp(getDataPointer(a), getDataPointer(b), m_elementSize);
    }
    unsigned getElementSize() const override { return m_elementSize; }
    const GLvoid* getDataPointer() const override { return m_count > 0 ? data() : nullptr; }
    const GLvoid* getDataPointer(unsigned i) const override { return data() + std::size_t{i} * m_elementSize; }
    unsigned getTotalDataSize() const override { return m_count * m_elementSize; }
    unsigned getNumElements() const override { return m_count; }
    void reserveArray(unsigned) override {}
    void resizeArray(unsigned) override {}

private:
    virtual const char* data() const = 0;

    unsigned m_count, m_elementSize;
};

/// An array that lies in something else, a mesh for instance; not copied.
class CBorrowedArray : public CForeignArray {
public:
    template <typename Values>
    CBorrowedArray(std::shared_ptr<const void> owner, const Values& values, Type type, int size, GLenum kind)
        : CForeignArray(type, size, kind, values.size(), sizeof(values[0])), m_owner(std::move(owner)),
          m_data(reinterpret_cast<const char*>(values.data())) {}

private:
    const char* data() const override { return m_data; }

    std::shared_ptr<const void> m_owner;
    const char* m_data;
};

/// The triangles of a mesh, likewise.
class CBorrowedTriangles : public osg::DrawElements {
public:
    explicit CBorrowedTriangles(std::shared_ptr<const CMesh> mesh)
        : DrawElements(DrawElementsUIntPrimitiveType, GL_TRIANGLES), m_mesh(std::move(mesh)) {
        setBufferObject(new osg::ElementBufferObject);
    }

    osg::Object* cloneType() const override { return nullptr; }
    osg::Object* clone(const osg::CopyOp&) const override { return nullptr; }
    const GLvoid* getDataPointer() const override { return count() > 0 ? m_mesh->indices.data() : nullptr; }
    unsigned getTotalDataSize() const override { return count() * unsigned{sizeof(std::uint32_t)}; }
    bool supportsBufferObject() const override { return true; }
    void draw(osg::State& state, bool useBuffers) const override {
        const osg::GLBufferObject* buffer = useBuffers ? getOrCreateGLBufferObject(state.getContextID()) : nullptr;
        if (buffer) state.bindElementBufferObject(const_cast<osg::GLBufferObject*>(buffer));
        const GLvoid* first =
            buffer ? reinterpret_cast<const GLvoid*>(buffer->getOffset(getBufferIndex())) : getDataPointer();
        glDrawElements(getMode(), static_cast<GLsizei>(count()), GL_UNSIGNED_INT, first);
    }
    void accept(osg::PrimitiveFunctor& functor) const override {
        functor.drawElements(getMode(), static_cast<GLsizei>(count()), m_mesh->indices.data());
    }
    void accept(osg::PrimitiveIndexFunctor& functor) const override {
        functor.drawElements(getMode(), static_cast<GLsizei>(count()), m_mesh->indices.data());
    }
    unsigned index(unsigned at) const override { return m_mesh->indices[at]; }
    unsigned getNumIndices() const override { return count(); }
    void offsetIndices(int) override {}
    GLenum getDataType() override { return GL_UNSIGNED_INT; }
    void resizeElements(unsigned) override {}
    void reserveElements(unsigned) override {}
    void setElement(unsigned, unsigned) override {}
    unsigned getElement(unsigned at) override { return m_mesh->indices[at]; }
    void addElement(unsigned) override {}

private:
    unsigned count() const { return static_cast<unsigned>(m_mesh->indices.size()); }

    std::shared_ptr<const CMesh> m_mesh;
};

} // namespace stromar
