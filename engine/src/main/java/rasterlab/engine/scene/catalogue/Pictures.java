package rasterlab.engine.scene.catalogue;

import java.util.function.IntBinaryOperator;
import rasterlab.engine.texture.Texture;

/** Textures drawn by formulas. */
final class Pictures {
    private static final int OPAQUE = 0xFF000000;
    private static final int COLOR = 3;

    private Pictures() {}

    /** 8×8 squares, light and dark. */
    static Texture checker() {
        return of(64, 64, (x, y) -> (x / 8 + y / 8) % 2 == 0 ? 0x3B4654 : 0xE6E2D8);
    }

    /**
     * 4×4 squares, A1 at the lower left to D4 at the upper right; red grows to the right and green
     * upwards, so that each place tells its s and t.
     */
    static Texture letters() {
        int cell = 64;
        return of(
                4 * cell,
                4 * cell,
                (x, y) -> {
                    boolean ink = Glyphs.inked(x / cell, y / cell, x % cell, y % cell);
                    if (ink) return 0x1E2430;
                    int base = (x / cell + y / cell) % 2 == 0 ? 0x90 : 0xC0;
                    return 0x60 + 0x90 * x / (4 * cell) << 16
                            | 0x60 + 0x90 * y / (4 * cell) << 8
                            | base;
                });
    }

    /** 512×256: longitudes from left to right, latitudes from the south pole upwards. */
    static Texture earth() {
        int height = 256;
        return of(
                2 * height,
                height,
                (x, y) ->
                        EarthColors.rgb(
                                2 * Math.PI * (x + 0.5) / (2 * height),
                                Math.PI * ((y + 0.5) / height - 0.5)));
    }

    /**
     * @param rgb of column and row, the bottom row first
     */
    private static Texture of(int width, int height, IntBinaryOperator rgb) {
        int[] argb = new int[width * height];
        for (int y = 0; y < height; y++)
            for (int x = 0; x < width; x++) argb[y * width + x] = OPAQUE | rgb.applyAsInt(x, y);
        return Texture.of(width, height, COLOR, argb);
    }
}
