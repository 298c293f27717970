import rasterlab.contract.*;

public class MyMethod implements VisibleFaces {

    public boolean[] visible(double[] xyz, int[][] faces, double[] eye, double[] inside) {
        boolean[] r = new boolean[faces.length];
        for (int f = 0; f < faces.length; f++) {
            int[] c = faces[f];
            double nx = 0, ny = 0, nz = 0;
            int o = 3 * c[0];
            for (int k = 1; k + 1 < c.length; k++) {
                int a = 3 * c[k], b = 3 * c[k + 1];
                double ux = xyz[a] - xyz[o],
                        uy = xyz[a + 1] - xyz[o + 1],
                        uz = xyz[a + 2] - xyz[o + 2],
                        vx = xyz[b] - xyz[o],
                        vy = xyz[b + 1] - xyz[o + 1],
                        vz = xyz[b + 2] - xyz[o + 2];
                nx += uy * vz - uz * vy;
                ny += uz * vx - ux * vz;
                nz += ux * vy - uy * vx;
            }
            r[f] = nx * eye[0] + ny * eye[1] + nz * eye[2] > 0;
        }
        return r;
    }
}
