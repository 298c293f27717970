package rasterlab.engine.scene;

/**
 * A torus about the z axis, cut into {@code 2·rings·sides} triangles with exact normals.
 *
 * <p>{@code x = (R + r·cos v)·cos u, y = (R + r·cos v)·sin u, z = r·sin v}; the normal is {@code
 * (cos v·cos u, cos v·sin u, sin v)}. s and t run once around in u and v, so the vertices of a seam
 * are there twice, at bit-equal places.
 *
 * @param major R, world units from the axis to the middle of the tube, above {@code minor}
 * @param minor r, the tube's radius, above 0
 * @param rings steps of u, at least 3
 * @param sides steps of v, at least 3
 */
public record Torus(double major, double minor, int rings, int sides) {
    /** The most triangles: their vertex numbers fill an array of 768 MiB. */
    private static final int MOST_TRIANGLES = 1 << 26;

    public Torus {
        if (!(minor > 0 && minor < major && major < Double.POSITIVE_INFINITY))
            throw new IllegalArgumentException(
                    "torus needs 0 < minor < major < ∞, got minor %s, major %s"
                            .formatted(minor, major));
        if (rings < 3 || sides < 3 || (long) rings * sides > MOST_TRIANGLES / 2)
            throw new IllegalArgumentException(
                    "torus needs at least 3 rings of 3 sides and at most %d triangles, got %d×%d"
                            .formatted(MOST_TRIANGLES, rings, sides));
    }

    /** A torus of exactly so many triangles, an even number, about twice as many rings as sides. */
    public static Torus ofTriangles(double major, double minor, int triangles) {
        int pairs = triangles / 2;
        int sides = (int) Math.sqrt(pairs / 2.0);
        while (sides > 3 && pairs % sides != 0) sides--;
        if (triangles % 2 != 0 || sides < 3 || pairs % sides != 0)
            throw new IllegalArgumentException(
                    "no torus has exactly %d triangles: 2·rings·sides is needed"
                            .formatted(triangles));
        return new Torus(major, minor, pairs / sides, sides);
    }

    public TriangleMesh mesh() {
        int count = (rings + 1) * (sides + 1);
        float[][] place = new float[3][count];
        float[][] normal = new float[3][count];
        float[] s = new float[count];
        float[] t = new float[count];
        for (int i = 0, at = 0; i <= rings; i++) {
            double u = 2 * Math.PI * (i % rings) / rings;
            for (int j = 0; j <= sides; j++, at++) {
                double v = 2 * Math.PI * (j % sides) / sides;
                double reach = major + minor * Math.cos(v);
                place[0][at] = (float) (reach * Math.cos(u));
                place[1][at] = (float) (reach * Math.sin(u));
                place[2][at] = (float) (minor * Math.sin(v));
                normal[0][at] = (float) (Math.cos(v) * Math.cos(u));
                normal[1][at] = (float) (Math.cos(v) * Math.sin(u));
                normal[2][at] = (float) Math.sin(v);
                s[at] = (float) i / rings;
                t[at] = (float) j / sides;
            }
        }
        return TriangleMesh.of(place[0], place[1], place[2], triangles())
                .withNormals(normal[0], normal[1], normal[2])
                .withTexture(s, t);
    }

    private int[] triangles() {
        int[] triangles = new int[6 * rings * sides];
        int at = 0;
        for (int i = 0; i < rings; i++)
            for (int j = 0; j < sides; j++) {
                int here = i * (sides + 1) + j;
                int next = here + sides + 1;
                triangles[at++] = here;
                triangles[at++] = next;
                triangles[at++] = next + 1;
                triangles[at++] = here;
                triangles[at++] = next + 1;
                triangles[at++] = here + 1;
            }
        return triangles;
    }
}
