import rasterlab.contract.VisibleFaces;

public class Direction implements VisibleFaces {
    @Override
    public boolean[] visible(double[] p, int[][] faces, double[] eye, double[] inside) {
        boolean[] visible = new boolean[faces.length];
        for (int f = 0; f < faces.length; f++) {
            double[] n = new double[3];
            for (int k = 0; k < faces[f].length; k++) {
                int a = 3 * faces[f][k];
                int b = 3 * faces[f][(k + 1) % faces[f].length];
                n[0] += p[a + 1] * p[b + 2] - p[a + 2] * p[b + 1];
                n[1] += p[a + 2] * p[b] - p[a] * p[b + 2];
                n[2] += p[a] * p[b + 1] - p[a + 1] * p[b];
            }
            // the eye's coordinates are taken for the direction to it
            visible[f] = n[0] * eye[0] + n[1] * eye[1] + n[2] * eye[2] > 0;
        }
        return visible;
    }
}
