import rasterlab.contract.TextureFilter;

/** Mixes the four texels around each pixel's centre, channel by channel. */
public class Model implements TextureFilter {
    @Override
    public int[] colors(int width, int height, int[] argb, double[] footprints) {
        int[] colors = new int[footprints.length / 6];
        for (int k = 0; k < colors.length; k++) {
            double u = footprints[6 * k] * width - 0.5;
            double v = footprints[6 * k + 1] * height - 0.5;
            double left = Math.floor(u);
            double low = Math.floor(v);
            int i0 = Math.floorMod((long) left, width);
            int j0 = Math.floorMod((long) low, height);
            int i1 = (i0 + 1) % width;
            int j1 = (j0 + 1) % height;
            int below = mix(argb[j0 * width + i0], argb[j0 * width + i1], u - left);
            int above = mix(argb[j1 * width + i0], argb[j1 * width + i1], u - left);
            colors[k] = mix(below, above, v - low);
        }
        return colors;
    }

    private static int mix(int a, int b, double share) {
        int mixed = 0;
        for (int shift = 0; shift < 32; shift += 8) {
            int from = a >>> shift & 255;
            int to = b >>> shift & 255;
            mixed |= (int) (from + share * (to - from) + 0.5) << shift;
        }
        return mixed;
    }
}
