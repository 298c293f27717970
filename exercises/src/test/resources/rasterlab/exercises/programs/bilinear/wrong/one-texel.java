import rasterlab.contract.TextureFilter;

public class Nearest implements TextureFilter {
    @Override
    public int[] colors(int w, int h, int[] argb, double[] f) {
        int[] out = new int[f.length / 6];
        for (int k = 0; k < out.length; k++) {
            int i = Math.floorMod((int) Math.floor(f[6 * k] * w), w);
            int j = Math.floorMod((int) Math.floor(f[6 * k + 1] * h), h);
            out[k] = argb[j * w + i];
        }
        return out;
    }
}
