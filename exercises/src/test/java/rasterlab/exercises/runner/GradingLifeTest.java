package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.Sources;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.runner.process.ChildJars;
import rasterlab.exercises.runner.process.Launcher;
import rasterlab.exercises.runner.process.Programs;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.score.Report;

/** Children come and go as they should, whoever is killed or interrupted. */
@Tag("slow")
class GradingLifeTest {
    private static final Exercise EXERCISE = Catalogue.builtIn().named("line-bresenham");

    @Test
    void anInterruptedGradingLeavesNoProcess() throws Exception {
        ExecutorService threads = Executors.newSingleThreadExecutor();
        JudgeSettings patient =
                OtherSettings.withCallLimit(Duration.ofMinutes(5), JudgeSettings.once());
        Set<ProcessHandle> before = children();
        try (Judge judge = Judge.start(patient)) {
            CountDownLatch firstCaseDone = new CountDownLatch(1);
            String endlessLater =
                    Sources.RIGHT.replace("long dx", "while (x1 == 2 && y1 == 9); long dx");
            Future<Report> grading =
                    threads.submit(
                            () ->
                                    judge.grade(
                                            EXERCISE,
                                            endlessLater,
                                            CaseSelection.open(),
                                            one -> firstCaseDone.countDown()));
            assertTrue(firstCaseDone.await(2, TimeUnit.MINUTES), "first case not judged");
            threads.shutdownNow();
            ExecutionException ended =
                    assertThrows(ExecutionException.class, () -> grading.get(2, TimeUnit.MINUTES));
            assertEquals(InterruptedException.class, ended.getCause().getClass());
            assertEquals(before, children(), "processes left");
        }
    }

    @Test
    void aChildKilledFromOutsideIsTriedAgainWithoutTellingACaseTwice() throws Exception {
        List<String> told = new ArrayList<>();
        try (Judge judge = Judge.start(JudgeSettings.once())) {
            Report report =
                    judge.grade(
                            EXERCISE,
                            Sources.RIGHT,
                            CaseSelection.open(),
                            one -> {
                                if (told.isEmpty())
                                    children().forEach(ProcessHandle::destroyForcibly);
                                told.add(one.name());
                            });
            assertEquals(GradingVerdict.OK, report.verdict(), report.diagnostics()::toString);
            assertEquals(new HashSet<>(told).size(), told.size(), told::toString);
        }
    }

    @Test
    void aChildKilledAgainGivesNoResult() throws Exception {
        try (Judge judge = Judge.start(JudgeSettings.once())) {
            Report report =
                    judge.grade(
                            EXERCISE,
                            Sources.RIGHT,
                            CaseSelection.open(),
                            one -> children().forEach(ProcessHandle::destroyForcibly));
            assertEquals(GradingVerdict.NO_RESULT, report.verdict());
        }
    }

    @Test
    void aJudgeClosedInTheMiddleIsOurFaultAndNoMark() throws Exception {
        Judge judge = Judge.start(JudgeSettings.once());
        Report report =
                judge.grade(EXERCISE, Sources.RIGHT, CaseSelection.open(), first -> judge.close());
        assertEquals(GradingVerdict.INTERNAL, report.verdict());
    }

    @Test
    void twoGradingsAtOnceDoNotMix() throws Exception {
        ExecutorService threads = Executors.newFixedThreadPool(2);
        try (Judge judge = Judge.start(JudgeSettings.defaults())) {
            List<Callable<Report>> both =
                    List.of(
                            () -> grade(judge, Sources.RIGHT),
                            () -> grade(judge, Sources.NAIVE_TEXTBOOK));
            List<Future<Report>> done = threads.invokeAll(both);
            assertEquals(GradingVerdict.OK, done.get(0).get().verdict());
            assertEquals(GradingVerdict.WRONG, done.get(1).get().verdict());
        } finally {
            threads.shutdownNow();
        }
    }

    private static Report grade(Judge judge, String source) throws InterruptedException {
        return judge.grade(EXERCISE, source, CaseSelection.all(7), one -> {});
    }

    @Test
    void theSameSeedGivesTheSameReport() throws Exception {
        try (Judge judge = Judge.start(JudgeSettings.defaults())) {
            Report first = grade(judge, Sources.BRESENHAM_TEXTBOOK);
            Report second = grade(judge, Sources.BRESENHAM_TEXTBOOK);
            assertEquals(
                    first.cases().stream().map(one -> one.name() + one.message()).toList(),
                    second.cases().stream().map(one -> one.name() + one.message()).toList());
        }
    }

    @Test
    void withoutBubblewrapItGradesAndSaysHonestlyWhatThatProtects() throws Exception {
        JudgeSettings plain = OtherSettings.onceInNoBox();
        try (Judge judge = Judge.start(plain)) {
            assertFalse(judge.isolation().exam());
            assertTrue(
                    judge.isolation().describe("en").contains("not against a determined attacker"),
                    () -> judge.isolation().describe("en"));
            Report report = grade(judge, Sources.RIGHT);
            assertEquals(GradingVerdict.OK, report.verdict(), report::toString);
            assertEquals("process limits only", report.isolation());
        }
    }

    @ParameterizedTest(name = "on {0} cores more or fewer children wait than cores and one")
    @CsvSource({"1, 1, 1", "2, 1, 2", "4, 1, 4", "8, 3, 6"})
    void oneMoreThanCoresWaits(int cores, int compiling, int running) {
        assertEquals(cores + 1, compiling + running);
        assertEquals(
                Map.of(ChildKind.COMPILE, compiling, ChildKind.RUN, running),
                Children.reserve(cores));
    }

    @Test
    void aReserveThatCannotBeFilledTakesNoReportAway() throws Exception {
        ChildJars jars = ChildJars.assemble();
        Launcher launcher = new Launcher(jars);
        Box withoutReserve =
                new WithoutReserve(new PlainBox(jars, ChildJava.running(), Message.NONE));
        try (Judge judge =
                new Judge(
                        JudgeSettings.defaults(),
                        jars,
                        launcher,
                        withoutReserve,
                        SpeedMemory.ofProcess(),
                        Compiling::inAChild)) {
            assertEquals(GradingVerdict.OK, grade(judge, Sources.RIGHT).verdict());
        }
    }

    @Test
    void aChildThatCannotStartIsNoFaultOfTheMethod() throws Exception {
        ChildJars jars = ChildJars.assemble();
        Launcher launcher = new Launcher(jars);
        Box failing =
                new FailingOnce(
                        new PlainBox(jars, ChildJava.running(), Message.NONE), new AtomicBoolean());
        try (Judge judge =
                new Judge(
                        JudgeSettings.once(),
                        jars,
                        launcher,
                        failing,
                        SpeedMemory.ofProcess(),
                        Compiling::inAChild)) {
            Report report = grade(judge, Sources.RIGHT);
            assertEquals(GradingVerdict.OK, report.verdict(), report::toString);
        }
    }

    /** The first child for a method ends before it says anything, as where the system is short. */
    private record FailingOnce(Box box, AtomicBoolean failed) implements Box {
        @Override
        public Isolation isolation() {
            return box.isolation();
        }

        @Override
        public boolean nested() {
            return box.nested();
        }

        @Override
        public List<String> command(ChildKind kind, boolean warm) {
            boolean fails = kind == ChildKind.RUN && !failed.getAndSet(true);
            return fails ? List.of(Programs.java(), "-version") : box.command(kind, warm);
        }
    }

    /** Starts a child that is needed now, and none to wait. */
    private record WithoutReserve(Box box) implements Box {
        @Override
        public Isolation isolation() {
            return box.isolation();
        }

        @Override
        public boolean nested() {
            return box.nested();
        }

        @Override
        public List<String> command(ChildKind kind, boolean warm) {
            return warm ? List.of("/no/such/program") : box.command(kind, warm);
        }
    }

    @Test
    void aClosedJudgeLeavesNoProcess() {
        Set<ProcessHandle> before = children();
        Judge.start(JudgeSettings.defaults()).close();
        assertEquals(before, children());
    }

    private static Set<ProcessHandle> children() {
        Set<ProcessHandle> alive = new HashSet<>();
        ProcessHandle.current().descendants().filter(ProcessHandle::isAlive).forEach(alive::add);
        return alive;
    }
}
