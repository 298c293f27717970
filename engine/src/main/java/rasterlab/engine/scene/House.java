package rasterlab.engine.scene;

import rasterlab.engine.transform.SphericalView;

/**
 * The house: a box of 8×6×5 with a ridge roof of height 4, ten vertices, seven faces.
 *
 * <p>The scene shows it 16 times as large with the middle of its bounding box at the origin, where
 * a spherical view looks; {@link HouseStages} has the textbook's own stages.
 *
 * <p>Source: V. V. Ponomarev, Computer graphics (Mashinnaya grafika), Ozyorsk, 2006, "forming the
 * picture" (the vertices and the scale; colours and faces are ours).
 */
public final class House {
    public static final double SCALE = 16;

    public static final SphericalView CAMERA =
            new SphericalView(Math.PI / 6, Math.PI * 7 / 18, 400);
    private static final int WALL_RGB = 0xE8D8B8;
    private static final int GABLE_RGB = 0xC9D8C0;
    private static final int ROOF_RGB = 0xC0574A;
    private static final int FLOOR_RGB = 0x8A7A68;

    private House() {}

    /** x, y, z of the vertices 1 to 10 in their order, in metres. */
    public static double[] vertices() {
        return new double[] {
            0, 0, 0, 8, 0, 0, 8, 6, 0, 0, 6, 0, //
            0, 0, 5, 8, 0, 5, 8, 6, 5, 0, 6, 5, //
            4, 0, 9, 4, 6, 9
        };
    }

    /** The faces about the middle of the bounding box, {@link #SCALE} times as large. */
    public static Mesh mesh() {
        double[] center = {4, 3, 4.5};
        double[] xyz = vertices();
        for (int i = 0; i < xyz.length; i++) xyz[i] = SCALE * (xyz[i] - center[i % 3]);
        int[][] faces = {
            {0, 3, 2, 1},
            {1, 2, 6, 5},
            {3, 0, 4, 7}, //
            {0, 1, 5, 8, 4},
            {2, 3, 7, 9, 6},
            {5, 6, 9, 8},
            {7, 4, 8, 9}
        };
        return new Mesh(xyz, faces);
    }

    /** The colour 0xRRGGBB of each face: floor, two walls, two gables, two halves of the roof. */
    public static int[] faceRgb() {
        return new int[] {FLOOR_RGB, WALL_RGB, WALL_RGB, GABLE_RGB, GABLE_RGB, ROOF_RGB, ROOF_RGB};
    }
}
