package rasterlab.engine.light.normals;

import rasterlab.contract.VertexNormals;

/** Normals of vertices found by adding up those of faces, one corner of a face after the other. */
public interface SteppedNormals extends VertexNormals {
    /**
     * @throws IllegalArgumentException as {@link #normals} does
     */
    NormalsWalk walk(double[] vertices, int[] triangles);

    /** The meaning of {@link NormalsWalk#weight}. */
    String weightFormula();

    @Override
    default double[] normals(double[] vertices, int[] triangles) {
        NormalsWalk walk = walk(vertices, triangles);
        boolean more = true;
        while (more) more = walk.advance();
        return walk.normals();
    }
}
