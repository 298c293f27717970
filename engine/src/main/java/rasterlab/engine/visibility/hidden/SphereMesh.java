package rasterlab.engine.visibility.hidden;

import rasterlab.engine.scene.Mesh;

/** A sphere cut in triangles between two poles and in flat quadrilaterals between its rings. */
final class SphereMesh {
    private SphereMesh() {}

    /**
     * @param rings parallels between the poles, at least 1; there are 2·(rings + 1) meridians
     * @param radius in world units
     */
    static Mesh of(int rings, double radius) {
        int around = 2 * (rings + 1);
        var xyz = new double[3 * (rings * around + 2)];
        for (int r = 0; r < rings; r++)
            for (int m = 0; m < around; m++) {
                double latitude = Math.PI * (r + 1) / (rings + 1);
                double longitude = 2 * Math.PI * m / around;
                int at = 3 * (r * around + m);
                xyz[at] = radius * Math.sin(latitude) * Math.cos(longitude);
                xyz[at + 1] = radius * Math.sin(latitude) * Math.sin(longitude);
                xyz[at + 2] = radius * Math.cos(latitude);
            }
        xyz[xyz.length - 4] = radius;
        xyz[xyz.length - 1] = -radius;
        return new Mesh(xyz, faces(rings, around));
    }

    private static int[][] faces(int rings, int around) {
        var faces = new int[(rings + 1) * around][];
        int top = rings * around;
        int at = 0;
        for (int m = 0; m < around; m++) {
            int next = (m + 1) % around;
            faces[at++] = new int[] {top, m, next};
            for (int r = 0; r < rings - 1; r++) {
                int high = r * around;
                int low = high + around;
                faces[at++] = new int[] {high + m, low + m, low + next, high + next};
            }
            int last = (rings - 1) * around;
            faces[at++] = new int[] {last + next, last + m, top + 1};
        }
        return faces;
    }
}
