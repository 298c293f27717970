import rasterlab.contract.LitPoint;
import rasterlab.contract.PointShader;

/** Tells how bright a point is. So far all points are black. */
public class MyLight implements PointShader {
    @Override
    public double[] intensity(LitPoint point) {
        return new double[3];
    }
}
