import rasterlab.contract.TextureMapper;
import rasterlab.contract.TexturedSpan;

/** Finds the texture coordinates along a row. So far all of them are 0. */
public class MyTexture implements TextureMapper {
    @Override
    public double[] coordinates(TexturedSpan span) {
        return new double[2 * span.pixels()];
    }
}
