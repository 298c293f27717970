package rasterlab.engine.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import rasterlab.engine.lanes.Lanes;
import rasterlab.engine.pipeline.triangle.DepthRaster;

/** What tests of both kinds of lanes share. */
public final class EightLanes {
    private EightLanes() {}

    /** Skips a test, by the reason's name, where there is no Vector API. */
    public static void assumeThere() {
        assumeTrue(Lanes.missing().isEmpty(), Lanes.missing());
    }

    /** Fails at the first pixel whose colour or depth differs by a bit. */
    public static void assertSame(DepthRaster one, DepthRaster eight, String what) {
        for (int i = 0; i < one.depth().length; i++) {
            String place = "%s: pixel (%d, %d)".formatted(what, i % one.width(), i / one.width());
            assertEquals(
                    Integer.toHexString(one.raster().argb()[i]),
                    Integer.toHexString(eight.raster().argb()[i]),
                    place);
            assertEquals(
                    Float.floatToRawIntBits(one.depth()[i]),
                    Float.floatToRawIntBits(eight.depth()[i]),
                    place + ", depth");
        }
    }
}
