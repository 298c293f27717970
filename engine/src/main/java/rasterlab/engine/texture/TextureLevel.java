package rasterlab.engine.texture;

/** One level of a texture. */
public final class TextureLevel {
    private final int width;
    private final int height;
    private final int[] argb;

    /**
     * @param argb texels row by row, the bottom row first; kept, not copied
     */
    TextureLevel(int width, int height, int[] argb) {
        this.width = width;
        this.height = height;
        this.argb = argb;
    }

    public int width() {
        return width;
    }

    public int height() {
        return height;
    }

    /** Row by row, the bottom row first: not a copy. */
    int[] argb() {
        return argb;
    }

    /** The texel in column {@code i} from the left and row {@code j} from the bottom. */
    public int texel(int i, int j) {
        return argb[j * width + i];
    }
}
