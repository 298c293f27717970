import rasterlab.contract.PlaneRotation;

/** Three multiplications a turn; half turns only change the signs. */
public class Model implements PlaneRotation {
    @Override
    public void rotate(double degrees, int times, double[] points) {
        double within = Math.IEEEremainder(degrees, 360);
        double rest = Math.IEEEremainder(within, 180);
        double t = Math.tan(Math.toRadians(rest) / 2);
        double sin = Math.sin(Math.toRadians(rest));
        boolean half = Math.abs(within - rest) > 90 && times % 2 == 1;
        for (int at = 0; at < points.length; at += 2) {
            double x = points[at];
            double y = points[at + 1];
            for (int i = 0; i < times; i++) {
                double shifted = y + x * t;
                x -= shifted * sin;
                y = x * t + shifted;
            }
            points[at] = half ? -x : x;
            points[at + 1] = half ? -y : y;
        }
    }
}
