package rasterlab.engine.texture;

/**
 * A sphere with a map of the world around it: s runs eastward about z from x, t from the south pole
 * to the north pole.
 *
 * <p>A map has two edges where the globe has one line, and a whole edge where it has one point. So
 * the first meridian stands twice, with s = 0 and s = 1, or the strip before it would run through
 * the whole map backwards; and each face at a pole has a pole of its own, with s in the middle of
 * the face, or the map would be sheared there.
 *
 * @param xyz vertices on a sphere of radius 1 about the origin, which are their own normals
 * @param st texture coordinates of each vertex
 * @param triangles three vertex numbers each, counter-clockwise seen from outside
 */
public record SphereMapping(double[] xyz, double[] st, int[] triangles) {
    /** The most meridians and parallels. */
    public static final int MOST = 2048;

    /**
     * @param meridians columns of faces, 3 to {@link #MOST}
     * @param parallels rows of faces, 2 to {@link #MOST}
     */
    public static SphereMapping of(int meridians, int parallels) {
        require("meridians", meridians, 3);
        require("parallels", parallels, 2);
        int columns = meridians + 1;
        var xyz = new double[3 * columns * (parallels + 1)];
        var st = new double[2 * columns * (parallels + 1)];
        for (int row = 0, vertex = 0; row <= parallels; row++)
            for (int column = 0; column < columns; column++, vertex++) {
                boolean pole = row == 0 || row == parallels;
                // The last column is the first one again, to the last bit.
                double around = 2 * Math.PI * (column % meridians) / meridians;
                double up = Math.PI * row / parallels;
                double aside = pole ? 0 : Math.sin(up);
                xyz[3 * vertex] = aside * Math.cos(around);
                xyz[3 * vertex + 1] = aside * Math.sin(around);
                xyz[3 * vertex + 2] = -Math.cos(up);
                st[2 * vertex] = (column + (pole ? 0.5 : 0)) / meridians;
                st[2 * vertex + 1] = row / (double) parallels;
            }
        return new SphereMapping(xyz, st, triangles(meridians, parallels));
    }

    private static void require(String name, int value, int least) {
        if (value < least || value > MOST)
            throw new IllegalArgumentException(
                    "%s must be from %d to %d, got %d".formatted(name, least, MOST, value));
    }

    private static int[] triangles(int meridians, int parallels) {
        var triangles = new int[6 * meridians * (parallels - 1)];
        int at = 0;
        for (int row = 0; row < parallels; row++)
            for (int column = 0; column < meridians; column++) {
                int here = row * (meridians + 1) + column;
                int above = here + meridians + 1;
                if (row > 0) {
                    triangles[at++] = here;
                    triangles[at++] = here + 1;
                    triangles[at++] = row == parallels - 1 ? above : above + 1;
                }
                if (row < parallels - 1) {
                    triangles[at++] = here;
                    triangles[at++] = above + 1;
                    triangles[at++] = above;
                }
            }
        return triangles;
    }
}
