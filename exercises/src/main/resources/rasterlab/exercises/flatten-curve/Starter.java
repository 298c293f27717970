import rasterlab.contract.Curve;
import rasterlab.contract.CurveFlattener;
import rasterlab.contract.CurvePoints;

/** Draws a curve by a polyline. So far it is one segment from the start to the end. */
public class MyPolyline implements CurveFlattener {
    @Override
    public void flatten(Curve curve, double flatness, CurvePoints out) {
        int last = curve.x().length - 1;
        out.point(curve.x()[0], curve.y()[0]);
        out.point(curve.x()[last], curve.y()[last]);
    }
}
