package rasterlab.engine.visibility.order;

import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import rasterlab.contract.DepthOrder;
import rasterlab.engine.study.Deviation;

/** Very many scenes against the reference: all of them with {@code -Drasterlab.full=true}. */
@Tag("slow")
class DepthOrderFullTest {
    private static final boolean FULL = Boolean.getBoolean("rasterlab.full");
    private static final int SCENES = FULL ? 5_000 : 50;
    private static final long SEED = 1972;

    @Test
    void noSceneOfManyIsPaintedWrong() {
        var topic = new DepthOrderTopic();
        var random = new Random(SEED);
        for (int scene = 0; scene < SCENES; scene++) {
            Sight sight = triangles(2 + scene % 12, random);
            if (!inRange(sight)) continue;
            for (String name : List.of("newell", "bsp")) {
                Painting painting =
                        topic.record(topic.method(name).implementation(), sight, 1_000_000);
                Deviation deviation = PaintingComparison.compare(sight, painting);
                assertTrue(
                        topic.correct(deviation),
                        name + ", seed " + SEED + ", scene " + scene + ": " + deviation);
            }
        }
    }

    /** A thousand at the limits that people meet, otherwise fewer at lower limits. */
    @Test
    void theMoreThatAllCutEachOtherAreRefused() {
        Sight sight = triangles(FULL ? 1_000 : 200, new Random(SEED));
        List<DepthOrder> methods =
                FULL
                        ? List.of(new Newell(), new Bsp())
                        : List.of(new Newell(10_000, 50_000_000), new Bsp(10_000));
        for (DepthOrder method : methods) {
            var refusal =
                    assertThrows(
                            IllegalArgumentException.class,
                            () ->
                                    method.order(
                                            sight.polygons(),
                                            sight.eye(),
                                            (polygon, corners) -> {}));
            assertTrue(refusal.getMessage().contains(" pieces, got "), refusal.getMessage());
        }
    }

    /** Whether the methods are not to refuse it, as they do one in thousands of random ones. */
    static boolean inRange(Sight sight) {
        try {
            SightRange.require(sight);
            return true;
        } catch (IllegalArgumentException e) {
            return false;
        }
    }

    /** Triangles that run through each other from wall to wall. */
    private static Sight triangles(int count, Random random) {
        var triangles = new double[count][];
        for (int k = 0; k < count; k++) triangles[k] = random.doubles(9, -100, 100).toArray();
        return new Sight(
                triangles,
                new double[] {
                    random.nextDouble(300, 500),
                    random.nextDouble(-250, 250),
                    random.nextDouble(-250, 250)
                });
    }
}
