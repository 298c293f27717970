package rasterlab.engine.pipeline;

import static org.junit.jupiter.api.Assertions.fail;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import rasterlab.engine.lanes.Lanes;
import rasterlab.engine.pipeline.fast.DepthRaster;

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
            if (one.raster().argb()[i] == eight.raster().argb()[i]
                    && Float.floatToRawIntBits(one.depth()[i])
                            == Float.floatToRawIntBits(eight.depth()[i])) continue;
            fail(
                    "%s: pixel (%d, %d): expected %08x at depth %s, got %08x at depth %s"
                            .formatted(
                                    what,
                                    i % one.width(),
                                    i / one.width(),
                                    one.raster().argb()[i],
                                    one.depth()[i],
                                    eight.raster().argb()[i],
                                    eight.depth()[i]));
        }
    }
}
