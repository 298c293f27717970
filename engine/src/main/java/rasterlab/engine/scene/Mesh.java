package rasterlab.engine.scene;

import java.util.Arrays;

/**
 * Vertices and flat convex faces, valid by construction and unchangeable.
 *
 * <p>Coordinates are world units. A face lists its corners counter-clockwise seen from outside.
 */
public final class Mesh {
    private final double[] xyz;
    private final int[][] faces;
    private final double[] normals;

    /**
     * @param xyz x, y, z of vertex 0, then of vertex 1, …; all finite
     * @param faces the corners of each face as vertex numbers from 0, at least three of them
     *     different; a face is flat, convex and has an area
     * @throws IllegalArgumentException naming the vertex or face that breaks a rule
     */
    public Mesh(double[] xyz, int[][] faces) {
        this.xyz = xyz.clone();
        this.faces = Arrays.stream(faces).map(int[]::clone).toArray(int[][]::new);
        normals = MeshCheck.normals(this.xyz, this.faces);
    }

    public int vertexCount() {
        return xyz.length / 3;
    }

    public int faceCount() {
        return faces.length;
    }

    public double x(int vertex) {
        return xyz[3 * vertex];
    }

    public double y(int vertex) {
        return xyz[3 * vertex + 1];
    }

    public double z(int vertex) {
        return xyz[3 * vertex + 2];
    }

    /** Number of corners of a face. */
    public int cornerCount(int face) {
        return faces[face].length;
    }

    /** The vertex number of a corner. */
    public int corner(int face, int corner) {
        return faces[face][corner];
    }

    /** The largest number of corners that a face has. */
    public int mostCorners() {
        return Arrays.stream(faces).mapToInt(face -> face.length).max().orElse(0);
    }

    /** x of the outward normal, of length 1. */
    public double normalX(int face) {
        return normals[3 * face];
    }

    /** y of the outward normal, of length 1. */
    public double normalY(int face) {
        return normals[3 * face + 1];
    }

    /** z of the outward normal, of length 1. */
    public double normalZ(int face) {
        return normals[3 * face + 2];
    }
}
