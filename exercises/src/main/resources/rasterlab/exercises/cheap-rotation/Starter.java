import rasterlab.contract.PlaneRotation;

/** Turns points about the origin. So far every point stays where it is. */
public class MyRotation implements PlaneRotation {
    @Override
    public void rotate(double degrees, int times, double[] points) {}
}
