import rasterlab.contract.TextureMapper;
import rasterlab.contract.TexturedSpan;

/** Wrong: mixes s and t themselves (s-t-linear). */
public class WrongAffine implements TextureMapper {
    @Override
    public double[] coordinates(TexturedSpan span) {
        int n = span.pixels();
        double[] st = new double[2 * n];
        double ds = n > 1 ? (span.toS() - span.fromS()) / (n - 1) : 0;
        double dt = n > 1 ? (span.toT() - span.fromT()) / (n - 1) : 0;
        for (int i = 0; i < n; i++) {
            st[2 * i] = span.fromS() + i * ds;
            st[2 * i + 1] = span.fromT() + i * dt;
        }
        return st;
    }
}
