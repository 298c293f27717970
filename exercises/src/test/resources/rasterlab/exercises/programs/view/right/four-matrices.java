import rasterlab.contract.*;

public class MyMethod implements EyeView {

    static double[][] mul(double[][] a, double[][] b) {
        double[][] c = new double[4][4];
        for (int i = 0; i < 4; i++)
            for (int j = 0; j < 4; j++) for (int k = 0; k < 4; k++) c[i][j] += a[i][k] * b[k][j];
        return c;
    }

    public void view(double theta, double phi, double rho, double[] p) {
        double a = Math.toRadians(90 - theta % 360), b = Math.toRadians(phi % 360 - 180);
        double[][]
                rz =
                        {
                            {Math.cos(a), -Math.sin(a), 0, 0},
                            {Math.sin(a), Math.cos(a), 0, 0},
                            {0, 0, 1, 0},
                            {0, 0, 0, 1}
                        },
                rx =
                        {
                            {1, 0, 0, 0},
                            {0, Math.cos(b), -Math.sin(b), 0},
                            {0, Math.sin(b), Math.cos(b), 0},
                            {0, 0, 0, 1}
                        },
                flip = {{-1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}},
                t = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, rho}, {0, 0, 0, 1}};
        double[][] m = mul(t, mul(flip, mul(rx, rz)));
        for (int i = 0; i < p.length; i += 3) {
            double[] v = {p[i], p[i + 1], p[i + 2], 1};
            for (int r = 0; r < 3; r++) {
                p[i + r] = 0;
                for (int k = 0; k < 4; k++) p[i + r] += m[r][k] * v[k];
            }
        }
    }
}
