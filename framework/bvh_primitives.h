#pragma once
#include "bvh_interface.h"
#include <atomic>
#include <memory>
#include <vector>

namespace accel {
class SceneTriangles;
}

// A tree's primitives: to whoever looks at them, a vector. Each has a hundred bytes, and the library's own traversal
// looks at none but those that are hit: where the library's builder has put them in order, all are made when somebody
// first looks. Until then the scene's meshes must stay. Any number of threads may look at once.
class BVHPrimitives {
public:
    using Primitive = BVHInterface::Primitive;
    using Vector = std::vector<Primitive>;
    using value_type = Primitive;
    using size_type = Vector::size_type;
    using reference = Primitive&;
    using const_reference = const Primitive&;
    using iterator = Vector::iterator;
    using const_iterator = Vector::const_iterator;

    BVHPrimitives(); // none, until somebody adds their own
    BVHPrimitives(accel::SceneTriangles triangles, std::vector<uint32_t> order);
    BVHPrimitives(BVHPrimitives&& other) noexcept;
    BVHPrimitives& operator=(BVHPrimitives&& other) noexcept;
    ~BVHPrimitives();

    [[nodiscard]] size_type size() const { return m_isMade ? m_made.size() : numUnmade(); }
    [[nodiscard]] bool empty() const { return size() == 0; }
    // One alone, without making all: put into the room where it is not made yet.
    [[nodiscard]] const Primitive& at(size_type i, Primitive& room) const
    {
        return m_isMade ? m_made[i] : room = makeOne(i);
    }

    [[nodiscard]] const Vector& all() const
    {
        if (!m_isMade)
            makeAll();
        return m_made;
    }
    [[nodiscard]] Vector& all()
    {
        if (!m_isMade)
            makeAll();
        return m_made;
    }

    // Of a vector.
    operator const Vector&() const { return all(); }
    operator Vector&() { return all(); }
    [[nodiscard]] const_iterator begin() const { return all().begin(); }
    [[nodiscard]] const_iterator end() const { return all().end(); }
    [[nodiscard]] const Primitive* data() const { return all().data(); }
    [[nodiscard]] const Primitive& operator[](size_type i) const { return all()[i]; }
    [[nodiscard]] iterator begin() { return all().begin(); }
    [[nodiscard]] iterator end() { return all().end(); }
    [[nodiscard]] Primitive* data() { return all().data(); }
    [[nodiscard]] Primitive& operator[](size_type i) { return all()[i]; }
    [[nodiscard]] Primitive& back() { return all().back(); }
    void reserve(size_type count) { all().reserve(count); }
    void resize(size_type count) { all().resize(count); }
    void clear() { all().clear(); }
    void push_back(const Primitive& primitive) { all().push_back(primitive); }
    template <typename... Arguments> Primitive& emplace_back(Arguments&&... arguments)
    {
        return all().emplace_back(std::forward<Arguments>(arguments)...);
    }

private:
    struct Order;

    [[nodiscard]] size_type numUnmade() const;
    [[nodiscard]] Primitive makeOne(size_type i) const;
    void makeAll() const;

    std::unique_ptr<const Order> m_order; // null: they are somebody's own
    mutable Vector m_made;
    mutable std::atomic<bool> m_isMade = true;
};
