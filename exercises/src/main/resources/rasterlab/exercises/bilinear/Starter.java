import rasterlab.contract.TextureFilter;

/** Finds the colours of pixels. So far all of them are transparent black. */
public class MyTexture implements TextureFilter {
    @Override
    public int[] colors(int width, int height, int[] argb, double[] footprints) {
        return new int[footprints.length / 6];
    }
}
