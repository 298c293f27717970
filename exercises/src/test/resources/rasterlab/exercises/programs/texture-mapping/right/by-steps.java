import rasterlab.contract.TextureMapper;
import rasterlab.contract.TexturedSpan;

/** Right: goes from pixel to pixel by multiples of equal steps of s/d, t/d and 1/d. */
public class RightBySteps implements TextureMapper {
    @Override
    public double[] coordinates(TexturedSpan span) {
        double[] first = {
            span.fromS() / span.fromDepth(), span.fromT() / span.fromDepth(), 1 / span.fromDepth()
        };
        double[] last = {
            span.toS() / span.toDepth(), span.toT() / span.toDepth(), 1 / span.toDepth()
        };
        double[] out = new double[span.pixels() * 2];
        int steps = Math.max(1, span.pixels() - 1);
        for (int i = 0, at = 0; i < span.pixels(); i++) {
            double[] now = new double[3];
            for (int k = 0; k < 3; k++) now[k] = (first[k] * (steps - i) + last[k] * i) / steps;
            out[at++] = now[0] / now[2];
            out[at++] = now[1] / now[2];
        }
        return out;
    }
}
