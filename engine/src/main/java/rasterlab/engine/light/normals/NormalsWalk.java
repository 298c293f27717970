package rasterlab.engine.light.normals;

/** Adds the normal of each face to the sum of each of its corners. */
public interface NormalsWalk {
    /** Adds one; false when there are no more. */
    boolean advance();

    /** The face that was added last, from 0. */
    int face();

    /** The vertex to whose sum it was added. */
    int vertex();

    /** The factor of its normal of length 1. */
    double weight();

    /** x, y, z of that vertex's sum with it. */
    double[] sum();

    /** How many faces were passed over so far because they have no area. */
    int leftOut();

    /** The normals from the sums; to be asked once, when all are added. */
    double[] normals();
}
