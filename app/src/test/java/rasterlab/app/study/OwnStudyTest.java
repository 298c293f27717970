package rasterlab.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.mine.OwnProgram;
import rasterlab.engine.Topics;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.HazardTrial.VerdictCell;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.StudySettings;
import rasterlab.engine.study.Verdict;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;

/** The user's own program among the methods of a study. */
@Tag("slow")
class OwnStudyTest {
    private static final Exercise LINE = Catalogue.builtIn().named("line-bresenham");

    /** A source that is right on every segment of 32-bit numbers. */
    private static final String RIGHT =
            """
            long dx = Math.abs((long) x1 - x0), dy = Math.abs((long) y1 - y0);
            int sx = x1 < x0 ? -1 : 1, sy = y1 < y0 ? -1 : 1;
            boolean steep = dy > dx;
            long n = steep ? dy : dx, b = steep ? dx : dy;
            long d = 2 * b - n - ((steep ? sx : sy) > 0 ? 1 : 0);
            int x = x0, y = y0;
            for (long k = 0; k <= n; k++) {
                out.plot(x, y);
                if (d >= 0) {
                    if (steep) x += sx; else y += sy;
                    d -= 2 * n;
                }
                if (steep) y += sy; else x += sx;
                d += 2 * b;
            }
            """;

    private final OwnMethods own = new OwnMethods();
    private final LineTopic topic = new LineTopic();

    @AfterEach
    void close() {
        own.close();
    }

    private void bring(String body) {
        own.bring(
                LINE,
                "import rasterlab.contract.*;\n"
                        + "public class Mine implements LineRasterizer {\n"
                        + "public void draw(int x0, int y0, int x1, int y1, Pixels out) {\n"
                        + body
                        + "\n}\n}\n");
    }

    private Study measured(String body) throws InterruptedException {
        bring(body);
        return new OwnStudy<>(topic, own.of("line").orElseThrow(), own)
                .measure(StudySettings.shortest(), news -> {}, () -> false);
    }

    private static List<Measurement> mine(Study study) {
        return study.measurements().stream()
                .filter(one -> one.method().equals(OwnMethods.NAME))
                .toList();
    }

    @Test
    void aRightProgramHasAPointOnEachWorkloadAndTheReferenceNone() throws InterruptedException {
        Study study = measured(RIGHT);
        assertEquals(topic.workloads().size(), mine(study).size());
        for (Measurement one : mine(study)) {
            assertEquals(Verdict.Kind.EXACT, one.kind(), one.detail());
            assertTrue(one.cost().timed(), one.workload());
        }
        List<String> methods =
                study.measurements().stream().map(Measurement::method).distinct().toList();
        assertEquals(topic.methods().size() + 1, methods.size());
        assertEquals(OwnMethods.NAME, methods.get(methods.size() - 1));
    }

    @Test
    void anEndlessProgramHasAVerdictAndNoCost() throws InterruptedException {
        for (Measurement one : mine(measured("while (x0 <= x1 || x1 <= x0) y0++;"))) {
            assertEquals(Verdict.Kind.ENDLESS, one.kind(), one.detail());
            assertFalse(one.cost().timed());
        }
    }

    @Test
    @DisplayName("what was measured before a study is cancelled is lost")
    void aCancelledStudyKeepsWhatWasMeasured() throws InterruptedException {
        bring(RIGHT);
        var steps = new AtomicInteger();
        Study study =
                new OwnStudy<>(topic, own.of("line").orElseThrow(), own)
                        .measure(
                                StudySettings.shortest(),
                                news -> steps.incrementAndGet(),
                                () -> steps.get() >= 3);
        assertEquals(3, study.measurements().size());
        assertEquals(List.of(), mine(study));
    }

    @Test
    void hazardsAreJudgedAsThoseOfEveryMethod() {
        bring(RIGHT.replace("n - ((steep ? sx : sy) > 0 ? 1 : 0)", "n"));
        List<VerdictCell> cells =
                new OwnStudy<>(topic, own.of("line").orElseThrow(), own)
                        .hazards(cell -> {}, () -> false);
        assertEquals(topic.hazards().size(), cells.size());
        assertTrue(cells.stream().anyMatch(one -> one.verdict().kind() == Verdict.Kind.EXACT));
        assertTrue(cells.stream().anyMatch(one -> one.verdict().kind() != Verdict.Kind.EXACT));
    }

    /** The first hazard is given its whole time however long compiling takes. */
    @Test
    void itIsCompiledBeforeTheFirstHazardIsTried() {
        bring(RIGHT);
        OwnProgram program = own.of("line").orElseThrow();
        var study = new OwnStudy<>(topic, program, own);
        assertThrows(CancellationException.class, () -> study.hazards(cell -> {}, () -> true));
        Thread.currentThread().interrupt();
        try {
            assertEquals(Optional.empty(), program.obstacle(), "it is compiled only now");
        } finally {
            Thread.interrupted();
        }
    }

    @Test
    void aRightProgramIsExactOnWhateverIsNotTooLong() {
        bring(RIGHT);
        List<VerdictCell> cells =
                new OwnStudy<>(topic, own.of("line").orElseThrow(), own)
                        .hazards(cell -> {}, () -> false);
        for (VerdictCell one : cells)
            assertTrue(
                    one.verdict().kind() == Verdict.Kind.EXACT
                            || one.verdict().detail().endsWith("items and was stopped"),
                    one.hazard() + one.verdict());
        assertEquals(Verdict.Kind.EXACT, cells.get(0).verdict().kind());
    }

    @Test
    void aProgramThatThrowsHasCrashed() {
        bring("out.plot(x0 / (y0 - y0), 0);");
        own.of("line").orElseThrow().prepare();
        Verdict verdict =
                HazardTrial.judge(
                        own.in(topic),
                        own.method(topic, OwnMethods.NAME),
                        topic.hazards().get(0),
                        HazardTrial.WALL_LIMIT);
        assertEquals(Verdict.Kind.CRASHED, verdict.kind());
        assertEquals(
                "your program threw java.lang.ArithmeticException: / by zero, in line 4",
                verdict.detail());
    }

    @Test
    void theTableHasItsColumnAsSoonAsThereIsAProgram() {
        List<Throwable> failures = new CopyOnWriteArrayList<>();
        try (var model = new StudyLabModel(Topics.all(), own, Runnable::run, failures::add)) {
            model.choose("line");
            assertFalse(listsMine(model));
            bring(RIGHT);
            assertTrue(listsMine(model));
            model.choose("circle");
            assertFalse(listsMine(model));
        }
        assertEquals(List.of(), failures);
    }

    private static boolean listsMine(StudyLabModel model) {
        return model.state().topic().methods().stream()
                .map(Method::name)
                .anyMatch(OwnMethods.NAME::equals);
    }
}
