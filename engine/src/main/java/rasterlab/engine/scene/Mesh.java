package rasterlab.engine.scene;

import java.util.Arrays;

/**
 * Vertices and flat convex faces, valid by construction and unchangeable.
 *
 * <p>Coordinates are world units. A face lists its corners counter-clockwise seen from outside.
 * Corners may have normals, texture coordinates and colours of their own, all of them or none;
 * corners are counted through all faces, those of face f from {@link #firstCorner} on.
 */
public final class Mesh {
    /** How far a corner may lie off its face's plane or turn inwards, as a share of its size. */
    public static final double TOLERANCE = 1e-9;

    private static final double[] NONE = {};

    private final double[] xyz;
    private final int[][] faces;
    private final double[] normals;
    private final int[] firstCorner;
    private final double[] cornerNormals;
    private final double[] cornerTexture;
    private final double[] cornerColors;

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
        firstCorner = new int[faces.length + 1];
        for (int f = 0; f < faces.length; f++)
            firstCorner[f + 1] = firstCorner[f] + faces[f].length;
        cornerNormals = NONE;
        cornerTexture = NONE;
        cornerColors = NONE;
    }

    private Mesh(Mesh of, double[] cornerNormals, double[] cornerTexture, double[] cornerColors) {
        xyz = of.xyz;
        faces = of.faces;
        normals = of.normals;
        firstCorner = of.firstCorner;
        this.cornerNormals = cornerNormals;
        this.cornerTexture = cornerTexture;
        this.cornerColors = cornerColors;
    }

    /**
     * This mesh with a normal for each corner.
     *
     * @param xyz of length 1 within 10⁻⁹, pointing outwards
     */
    public Mesh withNormals(double[] xyz) {
        MeshCheck.cornerNormals(xyz, totalCorners());
        return new Mesh(this, xyz.clone(), cornerTexture, cornerColors);
    }

    /**
     * This mesh with texture coordinates for each corner.
     *
     * @param st s and t of each, finite
     */
    public Mesh withTexture(double[] st) {
        MeshCheck.cornerTexture(st, totalCorners());
        return new Mesh(this, cornerNormals, st.clone(), cornerColors);
    }

    /**
     * This mesh with a colour for each corner, by which the light is multiplied that the material
     * gives off there but for highlights.
     *
     * @param rgb red, green and blue of each, from 0 to 1
     */
    public Mesh withColors(double[] rgb) {
        MeshCheck.cornerColors(rgb, totalCorners());
        return new Mesh(this, cornerNormals, cornerTexture, rgb.clone());
    }

    /** The vertices as they were given: not a copy. */
    double[] coordinates() {
        return xyz;
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

    /** Number of corners of all faces together. */
    public int totalCorners() {
        return firstCorner[faces.length];
    }

    /** The number of a face's first corner, counted through all faces. */
    public int firstCorner(int face) {
        return firstCorner[face];
    }

    /** Whether corners have normals of their own; otherwise each has its face's. */
    public boolean hasNormals() {
        return cornerNormals.length > 0;
    }

    /** The outward normal at a corner, of length 1: axis 0 is x, 1 is y, 2 is z. */
    public double cornerNormal(int face, int corner, int axis) {
        return hasNormals()
                ? cornerNormals[3 * (firstCorner[face] + corner) + axis]
                : normals[3 * face + axis];
    }

    /** Whether corners have colours of their own. */
    public boolean hasColors() {
        return cornerColors.length > 0;
    }

    /** The share of a channel, 1 where corners have no colours: 0 is red, 1 green, 2 blue. */
    public double color(int face, int corner, int channel) {
        return hasColors() ? cornerColors[3 * (firstCorner[face] + corner) + channel] : 1;
    }

    /** The mean of a face's corners' colours. */
    public double color(int face, int channel) {
        if (!hasColors()) return 1;
        double sum = 0;
        for (int k = 0; k < cornerCount(face); k++) sum += color(face, k, channel);
        return sum / cornerCount(face);
    }

    /** Whether corners have texture coordinates. */
    public boolean hasTexture() {
        return cornerTexture.length > 0;
    }

    /** The place from left (0) to right (1) of the texture; 0 where the mesh has no coordinates. */
    public double textureS(int face, int corner) {
        return hasTexture() ? cornerTexture[2 * (firstCorner[face] + corner)] : 0;
    }

    /** The place from bottom (0) to top (1) of the texture; 0 where the mesh has no coordinates. */
    public double textureT(int face, int corner) {
        return hasTexture() ? cornerTexture[2 * (firstCorner[face] + corner) + 1] : 0;
    }
}
