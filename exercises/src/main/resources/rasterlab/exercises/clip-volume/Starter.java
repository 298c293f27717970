import rasterlab.contract.SpaceSegmentSink;
import rasterlab.contract.VolumeClipper;

/** Clips a segment by the view volume. So far it leaves nothing of any segment. */
public class MyVolumeClip implements VolumeClipper {
    @Override
    public void clip(
            double zmin,
            double x0,
            double y0,
            double z0,
            double x1,
            double y1,
            double z1,
            SpaceSegmentSink out) {}
}
