package rasterlab.engine.scene;

import rasterlab.engine.transform.SphericalView;

/**
 * The vase: 30 meridians × 10 parallels and the centre of the bottom, open at the top.
 *
 * <p>Vertex 30·B + L has x = R[B] sin l, y = R[B] cos l, z = 25·B − 125, l = L·12°; vertex 300 is
 * (0, 0, −125). 270 side quadrilaterals come first, then 30 bottom triangles. A face starts with
 * the three corners of which the coursework averages z, listed so that it runs counter-clockwise
 * from outside (the coursework lists them clockwise).
 *
 * <p>Source: student's coursework "three-dimensional model of a vase", program listing.
 */
public final class Vase {
    public static final int MERIDIANS = 30;
    public static final int PARALLELS = 10;
    public static final int SIDE_RGB = 0xFFFFCC;
    public static final int BOTTOM_RGB = 0xD19A41;

    /** θ = π/9, φ = 4π/3, ρ = 500. */
    public static final SphericalView CAMERA = new SphericalView(Math.PI / 9, 4 * Math.PI / 3, 500);

    /** One press of a key turns φ by this, in radians. */
    public static final double PHI_STEP = 0.05 * Math.PI;

    /** One press of a key turns θ by this, in radians. */
    public static final double THETA_STEP = 0.03 * Math.PI;

    private static final double HEIGHT = 250;
    private static final int CENTER = MERIDIANS * PARALLELS;

    private Vase() {}

    /** 270 side faces, then 30 of the bottom. */
    public static Mesh mesh() {
        return new Mesh(vertices(), faces());
    }

    /** The colour 0xRRGGBB of each face. */
    public static int[] faceRgb() {
        int sides = MERIDIANS * (PARALLELS - 1);
        int[] rgb = new int[sides + MERIDIANS];
        for (int f = 0; f < rgb.length; f++) rgb[f] = f < sides ? SIDE_RGB : BOTTOM_RGB;
        return rgb;
    }

    /** Radii of the parallels from the bottom up, in world units. */
    public static int[] radii() {
        return new int[] {50, 75, 90, 94, 88, 74, 54, 42, 40, 46};
    }

    /** Heights of the parallels from the bottom up, in world units. */
    public static double[] heights() {
        var z = new double[PARALLELS];
        for (int b = 0; b < PARALLELS; b++) z[b] = HEIGHT / PARALLELS * b - HEIGHT / 2;
        return z;
    }

    private static double[] vertices() {
        int[] radii = radii();
        double[] heights = heights();
        double[] xyz = new double[3 * (CENTER + 1)];
        for (int b = 0; b < PARALLELS; b++)
            for (int l = 0; l < MERIDIANS; l++) {
                double longitude = 2 * Math.PI * l / MERIDIANS;
                int at = 3 * (b * MERIDIANS + l);
                xyz[at] = radii[b] * Math.sin(longitude);
                xyz[at + 1] = radii[b] * Math.cos(longitude);
                xyz[at + 2] = heights[b];
            }
        xyz[3 * CENTER + 2] = -HEIGHT / 2;
        return xyz;
    }

    private static int[][] faces() {
        int sides = MERIDIANS * (PARALLELS - 1);
        int[][] faces = new int[sides + MERIDIANS][];
        for (int b = 0; b < PARALLELS - 1; b++)
            for (int l = 0; l < MERIDIANS; l++) {
                int next = (l + 1) % MERIDIANS;
                int low = b * MERIDIANS;
                int high = low + MERIDIANS;
                faces[low + l] = new int[] {high + next, low + next, low + l, high + l};
            }
        for (int l = 0; l < MERIDIANS; l++)
            faces[sides + l] = new int[] {CENTER, l, (l + 1) % MERIDIANS};
        return faces;
    }
}
