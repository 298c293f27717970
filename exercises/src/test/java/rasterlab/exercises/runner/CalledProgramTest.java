package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static rasterlab.exercises.Sources.method;

import java.lang.reflect.Proxy;
import java.time.Duration;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.NoAnswer;
import rasterlab.engine.study.Verdict;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Sources;
import rasterlab.exercises.catalogue.Catalogue;

/** A student's program is called from here as any other method, whatever it does. */
@Tag("slow")
class CalledProgramTest {
    private static final Exercise EXERCISE = Catalogue.builtIn().named("line-bresenham");

    /** Hangs on single points, ends the process on no input, draws all else rightly. */
    private static final String HANGS =
            Sources.RIGHT.replace("long dx", "while (x0 == x1 && y0 == y1);\nlong dx");

    private static Judge judge;

    @BeforeAll
    static void start() {
        judge =
                Judge.start(
                        OtherSettings.withCallLimit(
                                Duration.ofMillis(500),
                                JudgeSettings.once().withSpeed(JudgeSettings.Speed.OFF)));
    }

    @AfterAll
    static void end() {
        judge.close();
    }

    @Test
    void theItemsComeInTheProgramsOrder() throws Exception {
        try (CalledProgram program = judge.program(EXERCISE, Sources.RIGHT)) {
            var pixels = new PixelRecording(10);
            line(program).draw(3, 1, 0, 0, pixels);
            assertEquals(4, pixels.size());
            assertEquals("3 1", pixels.x(0) + " " + pixels.y(0));
            assertEquals("0 0", pixels.x(3) + " " + pixels.y(3));
        }
    }

    @Test
    void oneThatHangsIsStoppedAndAnswersTheNextInput() throws Exception {
        try (CalledProgram program = judge.program(EXERCISE, HANGS)) {
            var late =
                    assertThrows(
                            NoAnswer.class,
                            () -> line(program).draw(1, 1, 1, 1, new PixelRecording(9)));
            assertEquals(
                    "your program did not answer within 0.5 s and was stopped", late.getMessage());
            assertEquals(Verdict.Kind.ENDLESS, late.kind());
            var pixels = new PixelRecording(9);
            line(program).draw(0, 0, 2, 0, pixels);
            assertEquals(3, pixels.size());
        }
    }

    @Test
    void theChildIsKeptFromCallToCall() throws Exception {
        String counts =
                """
                import rasterlab.contract.*;

                public class Counts implements LineRasterizer {
                    private int calls;
                    public void draw(int x0, int y0, int x1, int y1, Pixels out) {
                        out.plot(calls++, 0);
                    }
                }
                """;
        try (CalledProgram program = judge.program(EXERCISE, counts)) {
            var pixels = new PixelRecording(9);
            for (int i = 0; i < 3; i++) line(program).draw(0, 0, 0, 0, pixels);
            assertEquals(2, pixels.x(2));
        }
    }

    @Test
    void aSinkThatIsFullStopsTheCaller() throws Exception {
        String onAndOn = method("while (true) out.plot(x0, y0);\n");
        try (CalledProgram program = judge.program(EXERCISE, onAndOn)) {
            assertThrows(
                    LimitReached.class,
                    () -> line(program).draw(0, 0, 1, 1, new PixelRecording(100)));
        }
    }

    @Test
    void whatItThrowsIsToldWithItsLine() throws Exception {
        String throwing = method("int[] none = new int[0];\nout.plot(none[x0], 0);\n");
        try (CalledProgram program = judge.program(EXERCISE, throwing)) {
            var thrown =
                    assertThrows(
                            NoAnswer.class,
                            () -> line(program).draw(7, 0, 1, 1, new PixelRecording(9)));
            assertEquals(Verdict.Kind.CRASHED, thrown.kind());
            assertTrue(
                    thrown.getMessage()
                            .matches(
                                    "your program threw java.lang.ArrayIndexOutOfBoundsException:"
                                            + " Index 7 out of bounds for length 0, in line \\d+"),
                    thrown.getMessage());
        }
    }

    @Test
    void itsOwnRefusalIsARefusal() throws Exception {
        String refusing = method("throw new IllegalArgumentException(\"no \" + x0);\n");
        try (CalledProgram program = judge.program(EXERCISE, refusing)) {
            var refused =
                    assertThrows(
                            IllegalArgumentException.class,
                            () -> line(program).draw(7, 0, 1, 1, new PixelRecording(9)));
            assertEquals(IllegalArgumentException.class, refused.getClass());
            assertEquals("no 7", refused.getMessage());
        }
    }

    @Test
    void oneThatWouldEndItsProcessIsNotRun() {
        var refused =
                assertThrows(
                        NoAnswer.class,
                        () -> judge.program(EXERCISE, method("System.exit(0);\n")).close());
        assertTrue(refused.getMessage().contains("because of line"), refused.getMessage());
    }

    @Test
    void oneWhoseChildIsKilledIsCalledAgain() throws Exception {
        try (CalledProgram program = judge.program(EXERCISE, Sources.RIGHT)) {
            line(program).draw(0, 0, 2, 0, new PixelRecording(9));
            ProcessHandle.current().children().forEach(ProcessHandle::destroyForcibly);
            var pixels = new PixelRecording(9);
            line(program).draw(0, 0, 2, 0, pixels);
            assertEquals(3, pixels.size());
        }
    }

    private static LineRasterizer line(CalledProgram program) {
        return (LineRasterizer)
                Proxy.newProxyInstance(
                        LineRasterizer.class.getClassLoader(),
                        new Class<?>[] {LineRasterizer.class},
                        (proxy, method, arguments) -> program.call(method, arguments));
    }
}
