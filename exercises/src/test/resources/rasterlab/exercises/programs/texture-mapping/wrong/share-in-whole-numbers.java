import rasterlab.contract.*;

public class MyMethod implements TextureMapper {

    public double[] coordinates(TexturedSpan s) {
        int n = s.pixels();
        double[] r = new double[2 * n];
        for (int i = 0; i < n; i++) {
            double f = n == 1 ? 0 : i / (n - 1);
            double w = (1 - f) / s.fromDepth() + f / s.toDepth();
            r[2 * i] = ((1 - f) * s.fromS() / s.fromDepth() + f * s.toS() / s.toDepth()) / w;
            r[2 * i + 1] = ((1 - f) * s.fromT() / s.fromDepth() + f * s.toT() / s.toDepth()) / w;
        }
        return r;
    }
}
