import rasterlab.contract.SegmentClipper;
import rasterlab.contract.SegmentSink;

/** Clips a segment by a window. So far it leaves nothing of any segment. */
public class MyClip implements SegmentClipper {
    @Override
    public void clip(
            double xmin,
            double ymin,
            double xmax,
            double ymax,
            double x0,
            double y0,
            double x1,
            double y1,
            SegmentSink out) {}
}
