package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Caps;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Report;

/** A call is stopped where its exercise says. */
@Tag("slow")
class CapsTest {
    private static final String FACE =
            """
            import rasterlab.contract.*;

            public class Mine implements FaceShader {
                public double[] shade(LitFace face, double[] weights) {
                    %s
                }
            }
            """;

    private static final String CLIP =
            """
            import rasterlab.contract.*;

            public class Mine implements SegmentClipper {
                public void clip(double xmin, double ymin, double xmax, double ymax,
                        double x0, double y0, double x1, double y1, SegmentSink out) {
                    %s
                }
            }
            """;

    /** About 0.3 s of processor time, which no compiler leaves out. */
    private static final String BURN =
            "double waste = 1; for (int i = 0; i < 60_000_000; i++) waste = Math.sqrt(waste + i);"
                    + " if (waste == 0) out.segment(0, 0, 0, 0);";

    @RegisterExtension static final StartedJudge JUDGE = new StartedJudge();

    @Test
    @DisplayName("an answer of 80 bytes is taken where 60 are allowed, or one of 40 is not")
    void bytesAreLimited() throws Exception {
        Caps sixty = new Caps(OptionalInt.empty(), OptionalInt.of(60), Optional.empty());
        CaseReport more = first("shade-face", sixty, FACE.formatted("return new double[9];"));
        assertEquals(GradingVerdict.OUTPUT_LIMIT, more.verdict(), more.message());
        assertEquals("its answer is longer than what is taken", more.message());
        CaseReport taken = first("shade-face", sixty, FACE.formatted("return new double[3];"));
        assertEquals(GradingVerdict.WRONG, taken.verdict(), taken.message());
    }

    @Test
    @DisplayName("an answer of 24 MB is told as a want of memory")
    void aHugeAnswerIsToldByItsLength() throws Exception {
        CaseReport huge =
                first("shade-face", Caps.NONE, FACE.formatted("return new double[3_000_000];"));
        assertEquals(GradingVerdict.OUTPUT_LIMIT, huge.verdict(), huge.message());
        assertEquals("its answer is longer than what is taken", huge.message());
        assertEquals("ответ длиннее, чем принимается", huge.said().in("ru"));
    }

    @Test
    @DisplayName("a method that goes on for ever is stopped at the usual number of items")
    void itemsAreLimited() throws Exception {
        Caps thirty = new Caps(OptionalInt.of(30), OptionalInt.empty(), Optional.empty());
        String source = CLIP.formatted("while (true) out.segment(x0, y0, x1, y1);");
        CaseReport endless = first("clip-segment", thirty, source);
        assertEquals(GradingVerdict.OUTPUT_LIMIT, endless.verdict(), endless.message());
        assertEquals("it goes on beyond the most items that are taken", endless.message());
    }

    @Test
    @DisplayName("a call has the usual time, or names that")
    void timeIsLimited() throws Exception {
        Caps tenth = seconds(Duration.ofMillis(100));
        String source = FACE.formatted("while (true);");
        CaseReport endless = first("shade-face", tenth, source);
        assertEquals(GradingVerdict.TIME_LIMIT, endless.verdict(), endless.message());
        assertTrue(endless.message().contains("0.1 s"), endless.message());
    }

    @Test
    @DisplayName("six calls for one input have the time of six inputs")
    void allCallsForOneInputShareTheTime() throws Exception {
        Caps second = seconds(Duration.ofSeconds(1));
        Exercise clip = with(Catalogue.builtIn().named("clip-segment"), second);
        Report report = JUDGE.grade(clip, CLIP.formatted(BURN), CaseSelection.open());
        assertTrue(
                report.cases().stream().anyMatch(one -> one.verdict() == GradingVerdict.TIME_LIMIT),
                () -> report.cases().stream().map(CaseReport::message).toList().toString());
    }

    private static Caps seconds(Duration most) {
        return new Caps(OptionalInt.empty(), OptionalInt.empty(), Optional.of(most));
    }

    private static CaseReport first(String id, Caps caps, String source) throws Exception {
        return JUDGE.grade(with(Catalogue.builtIn().named(id), caps), source, CaseSelection.open())
                .cases()
                .get(0);
    }

    private static Exercise with(Exercise one, Caps caps) {
        return new Exercise(
                one.id(),
                one.topic(),
                one.title(),
                one.statement(),
                one.pictures(),
                one.starter(),
                one.revision(),
                one.tolerance(),
                one.points(),
                caps,
                one.timed(),
                one.groups(),
                one.cases(),
                one.breaking());
    }
}
