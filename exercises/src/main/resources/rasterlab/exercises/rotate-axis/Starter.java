import rasterlab.contract.AxisRotation;

/** Rotates points about an axis. So far every point stays where it is. */
public class MyAxisRotation implements AxisRotation {
    @Override
    public void rotate(double[] through, double[] direction, double degrees, double[] points) {}
}
