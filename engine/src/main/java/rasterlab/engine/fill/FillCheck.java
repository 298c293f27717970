package rasterlab.engine.fill;

import rasterlab.contract.PixelGrid;

/** Refuses what no method can fill. */
final class FillCheck {
    private FillCheck() {}

    static void check(PixelGrid picture, int x, int y, int connectivity) {
        if (x < 0 || x >= picture.width() || y < 0 || y >= picture.height())
            throw new IllegalArgumentException(
                    "seed must be in columns 0..%d and rows 0..%d, got (%d, %d)"
                            .formatted(picture.width() - 1, picture.height() - 1, x, y));
        if (connectivity != 4 && connectivity != 8)
            throw new IllegalArgumentException("connectivity must be 4 or 8, got " + connectivity);
    }
}
