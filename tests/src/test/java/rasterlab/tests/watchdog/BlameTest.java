package rasterlab.tests.watchdog;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.lang.Thread.State;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class BlameTest {
    private static final String OURS = "rasterlab.app.line.LinePanel";

    static Stream<Arguments> stacks() {
        return Stream.of(
                argumentSet(
                        "a lock of ours is waited for unseen",
                        State.BLOCKED,
                        new String[] {"rasterlab.app.canvas.work.LatestOnly", OURS},
                        Optional.of(Blame.WAITS)),
                argumentSet(
                        "an answer is waited for unseen",
                        State.WAITING,
                        new String[] {
                            "jdk.internal.misc.Unsafe",
                            "java.util.concurrent.locks.LockSupport",
                            "java.util.concurrent.FutureTask",
                            "javax.swing.SwingWorker",
                            OURS
                        },
                        Optional.of(Blame.WAITS)),
                argumentSet(
                        "sleep is taken for work",
                        State.TIMED_WAITING,
                        new String[] {"java.lang.Thread", OURS},
                        Optional.of(Blame.WAITS)),
                argumentSet(
                        "the toolkit's lock is blamed on us",
                        State.WAITING,
                        new String[] {
                            "jdk.internal.misc.Unsafe",
                            "java.util.concurrent.locks.ReentrantLock",
                            "sun.awt.SunToolkit",
                            OURS
                        },
                        Optional.empty()),
                argumentSet(
                        "a class that another thread loads is blamed on us",
                        State.BLOCKED,
                        new String[] {"java.lang.ClassLoader", OURS},
                        Optional.empty()),
                argumentSet(
                        "a file is read unseen",
                        State.RUNNABLE,
                        new String[] {"sun.nio.ch.FileDispatcherImpl", "java.nio.file.Files", OURS},
                        Optional.of(Blame.READS)),
                argumentSet(
                        "words from a process are waited for unseen",
                        State.RUNNABLE,
                        new String[] {"java.io.FileInputStream", "java.lang.ProcessImpl", OURS},
                        Optional.of(Blame.READS)),
                argumentSet(
                        "a class out of its archive is taken for a file of ours",
                        State.RUNNABLE,
                        new String[] {
                            "java.io.RandomAccessFile",
                            "java.util.zip.ZipFile",
                            "jdk.internal.loader.URLClassPath",
                            OURS
                        },
                        Optional.empty()),
                argumentSet(
                        "a picture is made unseen",
                        State.RUNNABLE,
                        new String[] {"rasterlab.engine.pipeline.fast.TrianglePipeline", OURS},
                        Optional.of(Blame.WORKS)),
                argumentSet(
                        "grading goes unseen",
                        State.RUNNABLE,
                        new String[] {"java.util.HashMap", "rasterlab.exercises.runner.GradingRun"},
                        Optional.of(Blame.WORKS)),
                argumentSet(
                        "the exercises are read unseen",
                        State.RUNNABLE,
                        new String[] {"rasterlab.exercises.catalogue.Catalogue", OURS},
                        Optional.of(Blame.WORKS)),
                argumentSet(
                        "a row's right answer is found unseen",
                        State.RUNNABLE,
                        new String[] {
                            "rasterlab.engine.texture.filter.FilterTopic",
                            "rasterlab.app.row.RowAnswers",
                            "rasterlab.app.row.RowKind",
                            OURS
                        },
                        Optional.of(Blame.WORKS)),
                argumentSet(
                        "a row that is shown is blamed",
                        State.RUNNABLE,
                        new String[] {"rasterlab.app.row.RowPainter", OURS},
                        Optional.empty()),
                argumentSet(
                        "a list of methods is blamed",
                        State.RUNNABLE,
                        new String[] {"rasterlab.engine.visibility.hidden.HiddenSurfacesTopic"},
                        Optional.empty()),
                argumentSet(
                        "painting is blamed",
                        State.RUNNABLE,
                        new String[] {"sun.java2d.loops.Blit", "javax.swing.JComponent", OURS},
                        Optional.empty()));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("stacks")
    void tells(State state, String[] classes, Optional<Blame> expected) {
        var stack =
                Stream.of(classes)
                        .map(name -> new StackTraceElement(name, "run", null, -1))
                        .toArray(StackTraceElement[]::new);
        assertEquals(expected, Blame.of(state, stack));
    }
}
