import rasterlab.contract.TextureMapper;
import rasterlab.contract.TexturedSpan;

/** s/d, t/d and 1/d are linear along the row; their quotients are the coordinates. */
public class Model implements TextureMapper {
    @Override
    public double[] coordinates(TexturedSpan span) {
        int n = span.pixels();
        double[] st = new double[2 * n];
        double near = 1 / span.fromDepth();
        double far = 1 / span.toDepth();
        for (int i = 0; i < n; i++) {
            double f = n == 1 ? 0 : i / (n - 1.0);
            double from = (1 - f) * near;
            double to = f * far;
            double sum = from + to;
            st[2 * i] = (from * span.fromS() + to * span.toS()) / sum;
            st[2 * i + 1] = (from * span.fromT() + to * span.toT()) / sum;
        }
        return st;
    }
}
