package rasterlab.engine.clip.segment;

import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * No segment is misjudged, among random ones and among those made to be. All 10⁷ and 10⁵ of them
 * are tried with {@code -Drasterlab.full=true}.
 */
class SegmentJudgementTest {
    private static final boolean FULL = Boolean.getBoolean("rasterlab.full");
    private static final int BLOCKS = FULL ? 10_000 : 20;
    private static final int BLOCK = 1_000;
    private static final int ADVERSARIES = FULL ? 100_000 : 10_000;

    @Test
    @Tag("slow")
    void noRandomSegmentIsMisjudged() {
        IntStream.range(0, BLOCKS)
                .parallel()
                .forEach(
                        seed -> {
                            var random = new Random(seed);
                            ClipWindow window = SegmentCases.randomWindow(random);
                            for (int i = 0; i < BLOCK; i++)
                                SegmentCases.assertRight(
                                        window, SegmentCases.randomSegment(random, window));
                        });
    }

    @Test
    @Tag("slow")
    void noSegmentThatTouchesOrJustMissesIsMisjudged() {
        IntStream.range(0, ADVERSARIES)
                .parallel()
                .forEach(
                        seed -> {
                            var random = new Random(seed);
                            ClipWindow window = SegmentCases.randomWindow(random);
                            SegmentCases.assertRight(
                                    window, SegmentCases.adversary(random, window));
                        });
    }

    /** Whole numbers meet corners and sides exactly, again and again. */
    @Test
    void everySegmentOfASmallGridIsRight() {
        var window = new ClipWindow(2, 2, 4, 5);
        IntStream.range(0, 7 * 7 * 7 * 7)
                .parallel()
                .forEach(
                        i ->
                                SegmentCases.assertRight(
                                        window, i % 7, i / 7 % 7, i / 49 % 7, i / 343));
    }

    /** A segment may be so steep that 1/(x1 − x0) does not fit in a double. */
    @Test
    void nextToVerticalAndHorizontalAreRight() {
        var window = new ClipWindow(0, 0, 1, 1);
        for (double small : new double[] {Double.MIN_VALUE, 0x1p-1000, 0x1p-500, 0x1p-54}) {
            SegmentCases.assertRight(window, -small, -1, small, 2);
            SegmentCases.assertRight(window, -small, -1, 2 * small, 0.5);
            SegmentCases.assertRight(window, -1, small, 2, -small);
            SegmentCases.assertRight(window, -1, -small, 2, -small);
        }
    }
}
