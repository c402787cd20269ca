// Finding the closest hit by walking a tree of boxes. The tree is built already; bvh_interface.h describes its nodes.
//
// To read: Pharr, Jakob and Humphreys, "Physically Based Rendering" (4th edition), 6.1.2 "Ray-Bounds Intersections"
// and 7.3 "Bounding Volume Hierarchies"; Ericson 2005, "Real-Time Collision Detection", 5.3.3 "Intersecting Ray or
// Segment Against Box"; Kay and Kajiya 1986, "Ray Tracing Complex Scenes".
#include "bvh.h"
#include "draw.h"
#include "interpolate.h"
#include "intersect.h"
#include "not_written_yet.h"

// Whether the ray meets a triangle or a sphere at a distance in [0, ray.t]. If so, ray.t becomes the closest such
// distance and hitInfo is filled: material, barycentric and texture coordinates, and the normal, unit, on the side
// the ray came from (interpolated from the corners if state.features.enableNormalInterp). If not, both stay as they
// were.
//
// A way to get there:
// 1. Test all of m_primitives with intersectRayWithTriangle, then all of state.scene.spheres: slow, but right, and
//    what the rest can be compared with. The material of a triangle is that of state.scene.meshes[primitive.meshID].
// 2. Start at m_nodes[RootIndex] and keep the nodes still to visit on a stack. Skip a node whose box the ray misses;
//    test the triangles of a leaf; push the children of any other.
// 3. Visit the nearer child first: then ray.t is short early on, and whole subtrees lie beyond it.
//
// - intersectRayWithShape(box, ray) shortens ray.t like every intersection: the ray you go on with must not be the
//   one that was tested. A box that holds the origin is hit too, and one that lies beyond ray.t is not.
// - If you write the box test yourself: a direction along an axis has zeros in it, and 0 * infinity is NaN.
// - std::numeric_limits<float>::min() is the smallest positive float; the most negative one is lowest().
// - Remember the closest triangle, not the last one tested, and fill hitInfo once, when the walk is over. A sphere
//   may be closer still: it fills hitInfo by itself.
// - An interpolated normal can point to the other side: turn it once more.
// - A ray may come with any t, a shadow ray say: nothing beyond it counts.
// - A scene without triangles has one leaf, which is empty.
//
// Debug drawing: the boxes of the visited nodes by drawAABB(box, DrawMode::Wireframe, color), from yellow (visited
// first) to red (last), and the normal at the hit in yellow. The colours need the number of visited nodes, which is
// known only at the end: collect them, but only while state.features.enableDebugDraw is on, for this is the innermost
// loop of the renderer.
bool BVH::intersect(RenderState& state, Ray& ray, HitInfo& hitInfo) const
{
    notWrittenYet("BVH::intersect"); // delete this line when the function is written
    return intersectRayWithBVH(state, *this, ray, hitInfo); // the framework's own: yours does not call it
}
