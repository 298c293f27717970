import rasterlab.contract.FillRule;
import rasterlab.contract.PolygonFiller;
import rasterlab.contract.Spans;

/** Fills a polygon. So far it fills nothing. */
public class MyFill implements PolygonFiller {
    @Override
    public void fill(double[] x, double[] y, FillRule rule, int width, int height, Spans out) {}
}
