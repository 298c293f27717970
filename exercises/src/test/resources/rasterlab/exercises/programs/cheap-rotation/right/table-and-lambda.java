import java.util.function.IntToDoubleFunction;
import rasterlab.contract.PlaneRotation;

public class Table implements PlaneRotation {
    private static final double[] SINES = new double[360];

    static {
        for (int i = 0; i < 360; i++) SINES[i] = Math.sin(i * Math.PI / 180);
    }

    @Override
    public void rotate(double degrees, int times, double[] points) {
        IntToDoubleFunction sine = i -> SINES[Math.floorMod(i, 360)];
        double s;
        double c;
        if (degrees == Math.rint(degrees)) {
            int whole = (int) (degrees % 360);
            s = sine.applyAsDouble(whole);
            c = sine.applyAsDouble(whole + 90);
        } else {
            s = Math.sin(Math.toRadians(degrees));
            c = Math.cos(Math.toRadians(degrees));
        }
        // all points go one step, then all the next
        for (int step = 0; step < times; step++)
            for (int i = 0; i < points.length; i += 2) {
                double old = points[i];
                points[i] = old * c - points[i + 1] * s;
                points[i + 1] = old * s + points[i + 1] * c;
            }
    }
}
