package rasterlab.engine.fill;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import java.util.Collections;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import rasterlab.contract.SeedFiller;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Verdict.Kind;

/** Regions of so many pixels that they are judged by a part. */
@Tag("slow")
class LargeFillTest {
    private static final FillTopic TOPIC = new FillTopic();
    private static final int SIDE = 1_500;
    private static final FillTask TASK =
            new FillTask(Collections.nCopies(SIDE, ".".repeat(SIDE)), 700, 1_000, '*', 4);

    @Test
    void methodsThatFillInDifferentOrdersAreExact() {
        assertEquals(Kind.EXACT, kind(new SpanFill()));
        assertEquals(Kind.EXACT, kind(new StackFill()));
    }

    @Test
    void aFillThatStopsAtItsSeedOrForgetsAColumnIsWrong() {
        SeedFiller one = (picture, x, y, with, connectivity) -> picture.write(x, y, with);
        SeedFiller narrow =
                (picture, x, y, with, connectivity) -> {
                    for (int row = 0; row < SIDE; row++)
                        for (int column = 1; column < SIDE; column++)
                            picture.write(column, row, with);
                };
        assertEquals(Kind.WRONG, kind(one));
        assertEquals(Kind.WRONG, kind(narrow));
    }

    private static Kind kind(SeedFiller method) {
        return HazardTrial.judge(
                        TOPIC,
                        Method.failing("made-up", method),
                        new Hazard<>("made-up", TASK, Map.of()),
                        Duration.ofMinutes(2))
                .kind();
    }
}
