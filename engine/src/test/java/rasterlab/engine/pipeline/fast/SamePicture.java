package rasterlab.engine.pipeline.fast;

import static org.junit.jupiter.api.Assertions.fail;

/** Compares two pictures bit for bit. */
final class SamePicture {
    private SamePicture() {}

    /** Fails at the first pixel whose colour or depth differs by a bit. */
    static void assertSame(DepthRaster expected, DepthRaster actual, String what) {
        for (int i = 0; i < expected.depth().length; i++) {
            if (expected.raster().argb()[i] == actual.raster().argb()[i]
                    && Float.floatToRawIntBits(expected.depth()[i])
                            == Float.floatToRawIntBits(actual.depth()[i])) continue;
            fail(
                    "%s: pixel (%d, %d): expected %08x at depth %s, got %08x at depth %s"
                            .formatted(
                                    what,
                                    i % expected.raster().width(),
                                    i / expected.raster().width(),
                                    expected.raster().argb()[i],
                                    expected.depth()[i],
                                    actual.raster().argb()[i],
                                    actual.depth()[i]));
        }
    }
}
