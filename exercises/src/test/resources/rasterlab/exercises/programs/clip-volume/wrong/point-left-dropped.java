import rasterlab.contract.*;

public class Clip implements VolumeClipper {
    @Override
    public void clip(double zmin, double x0, double y0, double z0, double x1, double y1, double z1, SpaceSegmentSink out) {
        
        double[] from = {z0 - x0, z0 + x0, z0 - y0, z0 + y0, z0 - zmin, 1 - z0};
        double[] to = {z1 - x1, z1 + x1, z1 - y1, z1 + y1, z1 - zmin, 1 - z1};
        double in = 0;
        double on = 1;
        for (int i = 0; i < 6; i++) {
            if (from[i] < 0 && to[i] < 0) return;
            if (from[i] < 0) in = Math.max(in, from[i] / (from[i] - to[i]));
            if (to[i] < 0) on = Math.min(on, from[i] / (from[i] - to[i]));
        }
        if (in >= on) return;
        out.segment(x0 + in * (x1 - x0), y0 + in * (y1 - y0), z0 + in * (z1 - z0),
                x0 + on * (x1 - x0), y0 + on * (y1 - y0), z0 + on * (z1 - z0));
    }
}
