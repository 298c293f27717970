import java.util.List;
import java.util.function.ToDoubleFunction;
import rasterlab.contract.*;

public class Recursive implements VolumeClipper {
    record P(double x, double y, double z) {
        P to(P o, double t) {
            return new P(x + t * (o.x - x), y + t * (o.y - y), z + t * (o.z - z));
        }
    }

    @Override
    public void clip(double zmin, double x0, double y0, double z0, double x1, double y1, double z1, SpaceSegmentSink out) {
        P a = new P(x0, y0, z0);
        P b = new P(x1, y1, z1);
        List<ToDoubleFunction<P>> planes =
                List.of(p -> p.z - p.x, p -> p.z + p.x, p -> p.z - p.y, p -> p.z + p.y, p -> p.z - zmin, p -> 1 - p.z);
        cut(planes, a, b, 0, 1, out);
    }

    private void cut(List<ToDoubleFunction<P>> planes, P a, P b, double in, double on, SpaceSegmentSink out) {
        if (in > on) return;
        if (planes.isEmpty()) {
            P from = in == 0 ? a : a.to(b, in);
            P to = on == 1 ? b : a.to(b, on);
            out.segment(from.x, from.y, from.z, to.x, to.y, to.z);
            return;
        }
        double da = planes.get(0).applyAsDouble(a);
        double db = planes.get(0).applyAsDouble(b);
        List<ToDoubleFunction<P>> rest = planes.subList(1, planes.size());
        if (da >= 0 && db >= 0) cut(rest, a, b, in, on, out);
        
    }
}
