package rasterlab.engine.visibility.depth;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import rasterlab.contract.DepthRange;

/** Sums along a scan line, and what exact order makes of rows. */
class DepthDriftTest {
    private static final DepthBufferTopic TOPIC = new DepthBufferTopic();
    private static final int LONG = 8192;

    @Property(tries = 60)
    void fixedPointDriftsByHalfAUnitOfItsFractionPerPixel(@ForAll long seed) {
        assertTrue(worstDrift("incremental-z16", seed) <= (LONG + 1) * 0x1p-17, "seed " + seed);
        assertTrue(worstDrift("incremental-z24", seed) <= (LONG + 1) * 0x1p-9, "seed " + seed);
    }

    @Property(tries = 60)
    void floatsDriftByHalfAStepBelowOnePerPixel(@ForAll long seed) {
        double worst = worstDrift("incremental-float", seed);
        assertTrue(worst <= LONG, worst + ", seed " + seed);
    }

    private static double worstDrift(String method, long seed) {
        var random = new Random(seed);
        double from = 1 / random.nextDouble(1, 1000);
        double to = 1 / random.nextDouble(1, 1000);
        DepthWalk walk =
                stepped(method).walk(new DepthRange(1, 1000), from, (to - from) / (LONG - 1), LONG);
        double worst = 0;
        do worst = Math.max(worst, Math.abs(walk.decision()));
        while (walk.advance());
        assertEquals(LONG - 1, walk.pixel());
        return worst;
    }

    @Test
    void driftIsThatOfTheSum() {
        var range = new DepthRange(1, 2);
        DepthWalk walk = stepped("incremental-z24").walk(range, 1, -1e-9, 3);
        assertEquals(0, walk.sum());
        assertEquals(0, walk.decision());
        assertTrue(walk.advance());
        double right = 1e-9 * ((1 << 24) - 1) / 0.5;
        assertEquals(Math.rint(right * 256) / 256, walk.sum());
        assertEquals(walk.sum() - right, walk.decision(), 1e-9);
        assertTrue(walk.advance());
        assertEquals(2, walk.pixel());
        assertTrue(!walk.advance(), "a row of 3 pixels has a 4th");
    }

    @Test
    void rowIsItsWalk() {
        var range = new DepthRange(1, 1000);
        var row = new int[LONG];
        for (String method :
                new String[] {"incremental-z16", "incremental-z24", "incremental-float"}) {
            SteppedDepth format = stepped(method);
            DepthCoding.RangeCodes codes = format.over(range);
            codes.row(0.9, -1.2e-4, 0, LONG, row);
            DepthWalk walk = format.walk(range, 0.9, -1.2e-4, LONG);
            do assertEquals(walk.code(), row[walk.pixel()], method);
            while (walk.advance());
            assertEquals(codes.code(0), row[LONG - 1], "beyond the far plane codes stay");
        }
    }

    @Test
    void sumsOfFloatsFallFarBehind() {
        assertTrue(worstDrift("incremental-float", 1) > 100, "drift of a long row");
    }

    private static SteppedDepth stepped(String method) {
        return (SteppedDepth) TOPIC.method(method).implementation();
    }

    @Property(tries = 60)
    void exactOrderIsThatOfDoublesWhereTheyAreFarApart(@ForAll long seed) {
        var random = new Random(seed);
        var range = new DepthRange(1, 100);
        double[] from = random.doubles(4, 1, 100).toArray();
        double[] to = random.doubles(4, 1, 100).toArray();
        var rows = new DepthRows(range, from, to, 9);
        StoredDepths exact = ExactDepths.of(rows);
        for (int i = 0; i < 9; i++)
            for (int s = 0; s < 4; s++) {
                double z = 1 / (rows.nearness(s) + i * rows.perPixel(s));
                assertEquals(z, exact.depths()[s * 9 + i], 1e-12 * z, "seed " + seed);
                int nearer = 0;
                for (int other = 0; other < 4; other++)
                    if (exact.depths()[other * 9 + i] < exact.depths()[s * 9 + i]) nearer++;
                assertEquals(nearer, exact.codes()[s * 9 + i], "seed " + seed);
            }
    }

    @Test
    void equalDepthsHaveEqualRanks() {
        StoredDepths exact = ExactDepths.of(DepthRows.pixel(new DepthRange(1, 9), 3, 2, 3, 5));
        assertEquals(1, exact.codes()[0]);
        assertEquals(0, exact.codes()[1]);
        assertEquals(1, exact.codes()[2]);
        assertEquals(2, exact.codes()[3]);
    }

    @Test
    void formulaOfAFormatIsWhatTheSearchFinds() {
        for (DepthPrecision.PrecisionSample sample : DepthPrecision.samples(3))
            assertEquals(1, sample.measured() / sample.predicted(), 1e-6, sample::toString);
    }
}
