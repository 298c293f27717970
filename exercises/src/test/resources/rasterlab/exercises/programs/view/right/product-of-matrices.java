import java.util.stream.IntStream;
import java.util.stream.Stream;
import rasterlab.contract.EyeView;

public class Matrices implements EyeView {
    @Override
    public void view(double theta, double phi, double rho, double[] points) {
        double a = Math.toRadians(90 - theta % 360);
        double b = Math.toRadians(phi % 360 - 180);
        double[][] aboutZ = {
            {Math.cos(a), -Math.sin(a), 0, 0}, {Math.sin(a), Math.cos(a), 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}
        };
        double[][] aboutX = {
            {1, 0, 0, 0}, {0, Math.cos(b), -Math.sin(b), 0}, {0, Math.sin(b), Math.cos(b), 0}, {0, 0, 0, 1}
        };
        double[][] mirror = {{-1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, rho}, {0, 0, 0, 1}};
        double[][] all = Stream.of(aboutX, aboutZ).reduce(mirror, Matrices::times);
        for (int i = 0; i < points.length; i += 3) {
            double[][] point = {{points[i]}, {points[i + 1]}, {points[i + 2]}, {1}};
            double[][] image = times(all, point);
            for (int k = 0; k < 3; k++) points[i + k] = image[k][0];
        }
    }

    private static double[][] times(double[][] a, double[][] b) {
        double[][] c = new double[a.length][b[0].length];
        for (int i = 0; i < a.length; i++)
            for (int j = 0; j < b[0].length; j++) {
                int row = i;
                int column = j;
                c[i][j] = IntStream.range(0, b.length).mapToDouble(k -> a[row][k] * b[k][column]).sum();
            }
        return c;
    }
}
