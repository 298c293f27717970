import rasterlab.contract.TextureMapper;
import rasterlab.contract.TexturedSpan;

/** Wrong: takes i/n for the share, so the last pixel is not reached (divided-by-n). */
public class WrongShare implements TextureMapper {
    @Override
    public double[] coordinates(TexturedSpan span) {
        int n = span.pixels();
        double[] st = new double[2 * n];
        for (int i = 0; i < n; i++) {
            double f = (double) i / n;
            double a = (1 - f) / span.fromDepth();
            double b = f / span.toDepth();
            st[2 * i] = (a * span.fromS() + b * span.toS()) / (a + b);
            st[2 * i + 1] = (a * span.fromT() + b * span.toT()) / (a + b);
        }
        return st;
    }
}
