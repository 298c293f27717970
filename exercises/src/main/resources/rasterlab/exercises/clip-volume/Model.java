import rasterlab.contract.SpaceSegmentSink;
import rasterlab.contract.VolumeClipper;

/** Six inequalities for the parameter, without any division by z. */
public class Model implements VolumeClipper {
    @Override
    public void clip(
            double zmin,
            double x0,
            double y0,
            double z0,
            double x1,
            double y1,
            double z1,
            SpaceSegmentSink out) {
        double[] from = {z0 - x0, z0 + x0, z0 - y0, z0 + y0, z0 - zmin, 1 - z0};
        double[] to = {z1 - x1, z1 + x1, z1 - y1, z1 + y1, z1 - zmin, 1 - z1};
        double enter = 0;
        double leave = 1;
        for (int i = 0; i < 6; i++) {
            if (from[i] < 0 && to[i] < 0) return;
            if (from[i] < 0) enter = Math.max(enter, from[i] / (from[i] - to[i]));
            if (to[i] < 0) leave = Math.min(leave, from[i] / (from[i] - to[i]));
        }
        if (enter > leave) return;
        out.segment(
                at(x0, x1, enter),
                at(y0, y1, enter),
                at(z0, z1, enter),
                at(x0, x1, leave),
                at(y0, y1, leave),
                at(z0, z1, leave));
    }

    private static double at(double start, double end, double t) {
        return t == 1 ? end : start + t * (end - start);
    }
}
