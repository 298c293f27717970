package rasterlab.engine.scene.shape;

import java.util.List;
import rasterlab.engine.scene.Mesh;

/** A surface that knows its points, their normals and where it meets a ray. */
public interface SceneShape {
    /** The smallest length of a shape, in world units. */
    double SMALLEST = 1e-30;

    /** The largest length of a shape, in world units. */
    double LARGEST = 1e30;

    /** The pieces it is put together from, each with parameters of its own. */
    List<Patch> patches();

    /** Whether it encloses a convex body: nothing of it hides what faces the eye. */
    default boolean isConvexBody() {
        return false;
    }

    /**
     * Looks for the nearest point of this shape that {@code ray} meets, from either side; what is
     * beyond the nearest one that the ray has met before is left alone.
     */
    void meet(Ray ray);

    /**
     * Flat faces over shared vertices: quadrilaterals, and triangles about poles; corners have the
     * surface's normals and texture coordinates.
     *
     * @param uSteps steps of u on each patch, at least 3 where it goes once round
     * @param vSteps steps of v on each patch; discs take one
     */
    default Mesh faces(int uSteps, int vSteps) {
        return new Tessellation(this, uSteps, vSteps).faces();
    }

    /** Flat faces that are coarser where blocks of cells are joined. */
    default Mesh faces(int uSteps, int vSteps, JoinedBlocks joins) {
        return new Tessellation(this, uSteps, vSteps).faces(joins);
    }
}
