import rasterlab.contract.TextureMapper;
import rasterlab.contract.TexturedSpan;

/** Wrong: mixes the depth itself and divides by that (depth-linear). */
public class WrongDepth implements TextureMapper {
    @Override
    public double[] coordinates(TexturedSpan span) {
        int n = span.pixels();
        double[] st = new double[2 * n];
        for (int i = 0; i < n; i++) {
            double f = n == 1 ? 0 : (double) i / (n - 1);
            double d = span.fromDepth() + f * (span.toDepth() - span.fromDepth());
            st[2 * i] = d * ((1 - f) * span.fromS() / span.fromDepth() + f * span.toS() / span.toDepth());
            st[2 * i + 1] =
                    d * ((1 - f) * span.fromT() / span.fromDepth() + f * span.toT() / span.toDepth());
        }
        return st;
    }
}
