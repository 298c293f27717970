package rasterlab.app.clip;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import rasterlab.app.clip.outcome.ClipRecord;
import rasterlab.app.clip.outcome.ClipStep;

/** Steps of methods that tell nothing but what they sent. */
class WrittenStepTest {
    @Test
    void aSegmentOfWhichNothingWasSentHasAStepToo() {
        var run = new ClipRecord("mine", false);
        run.sink().segment(1, 2, 3, 4);
        run.written(0);
        run.written(1);
        var steps = run.clipping(run.sink().captured(), ends -> null, 1).steps();
        assertEquals(2, steps.size());
        assertArrayEquals(new double[] {1, 2, 3, 4}, steps.get(0).left());
        assertArrayEquals(new double[0], steps.get(1).left());
        assertEquals(1, steps.get(1).item());
    }

    @Test
    void aPieceIsDrawnAllAroundAndHasItsOwnNumberOfCorners() {
        ClipStep step = ClipStep.writtenPiece(new double[] {0, 0, 4, 0, 0, 3});
        assertArrayEquals(new double[] {0, 0, 4, 0, 0, 3, 0, 0}, step.left());
        assertEquals(3, step.decision());
    }
}
