package rasterlab.exercises.line;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.LineRasterizer;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.TopicGrading.TimingInputs;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.score.SpeedPoints;
import rasterlab.exercises.topic.TopicGradings;

/** One mistake is named as what it is, costs about one mistake, and leaves the speed its points. */
@Tag("slow")
class OneMistakeTest {
    private static final Exercise EXERCISE = Catalogue.builtIn().named("line-bresenham");
    private static final long[] SEEDS = {0, 1, 42, -7, Long.MAX_VALUE};

    static List<OneMistake> mistakes() {
        return OneMistake.ALL;
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("mistakes")
    void costsItsPointsAndIsNamed(OneMistake mistake) {
        for (long seed : SEEDS) {
            MarkedMethod marked =
                    MarkedMethod.of(EXERCISE, mistake.method(), CaseSelection.all(seed));
            String shared = marked.shared();
            assertTrue(shared.contains(mistake.message()), () -> shared + ", seed " + seed);
            assertEquals(
                    mistake.points(),
                    marked.points() + speed(marked, mistake.method()),
                    () -> "seed " + seed + " fails " + marked.failed());
        }
    }

    /** All points for speed, as they are for a method that is quick, or none. */
    private static int speed(MarkedMethod marked, LineRasterizer method) {
        boolean floor =
                marked.accuracy() >= SpeedPoints.ACCURACY_FLOOR * EXERCISE.points().accuracy();
        return floor && isTimed(marked, method) ? EXERCISE.points().speed() : 0;
    }

    private static boolean isTimed(MarkedMethod marked, LineRasterizer method) {
        return TimedHere.isPaid(EXERCISE, marked.marking(), method);
    }

    @Test
    @DisplayName("a mistake on the long lines alone is timed as if it were paid for")
    void aMistakeThatNoCaseMetIsNotTimed() {
        LineRasterizer right = new PlainBresenham();
        MarkedMethod marked = MarkedMethod.of(EXERCISE, right, CaseSelection.all(1));
        for (OneMistake mistake : OneMistake.ALL)
            if (!mistake.name().startsWith("ties") && !mistake.name().startsWith("backwards"))
                assertTrue(!isTimed(marked, mistake.method()), mistake::name);
        assertTrue(isTimed(marked, right));
    }

    @Test
    @DisplayName("a method that is wrong in most octants is timed in the rest")
    void moreThanHalfOfTheOctantsMustBeLeft() {
        List<Set<String>> four =
                Stream.of("right down", "right up", "left down", "left up")
                        .<Set<String>>map(
                                way -> Set.of("steep", way.split(" ")[0], way.split(" ")[1]))
                        .toList();
        LineRasterizer onlyGentle =
                (x0, y0, x1, y1, out) -> {
                    if (Math.abs(x1 - x0) > Math.abs(y1 - y0))
                        new PlainBresenham().draw(x0, y0, x1, y1, out);
                };
        TimingInputs left =
                TopicGradings.named("line").timings(EXERCISE, new Random(5), four).next();
        assertEquals(left.count(), TimedHere.answers(left, onlyGentle).count());
        List<Set<String>> more =
                Stream.concat(four.stream(), Stream.of(Set.of("gentle", "left", "up"))).toList();
        TimingInputs all =
                TopicGradings.named("line").timings(EXERCISE, new Random(5), more).next();
        assertTrue(TimedHere.answers(all, onlyGentle).count() < all.count());
    }
}
