import rasterlab.contract.*;

public class MyMethod implements VolumeClipper {

    public void clip(
            double zmin,
            double x0,
            double y0,
            double z0,
            double x1,
            double y1,
            double z1,
            SpaceSegmentSink out) {
        double[] a = {1 - x0, 1 + x0, 1 - y0, 1 + y0, z0 - zmin, 1 - z0},
                b = {1 - x1, 1 + x1, 1 - y1, 1 + y1, z1 - zmin, 1 - z1};
        double in = 0, go = 1;
        for (int i = 0; i < 6; i++) {
            if (a[i] < 0 && b[i] < 0) return;
            if (a[i] < 0) in = Math.max(in, a[i] / (a[i] - b[i]));
            else if (b[i] < 0) go = Math.min(go, a[i] / (a[i] - b[i]));
        }
        if (in > go) return;
        double dx = x1 - x0, dy = y1 - y0, dz = z1 - z0;
        out.segment(
                x0 + in * dx,
                y0 + in * dy,
                z0 + in * dz,
                go == 1 ? x1 : x0 + go * dx,
                go == 1 ? y1 : y0 + go * dy,
                go == 1 ? z1 : z0 + go * dz);
    }
}
