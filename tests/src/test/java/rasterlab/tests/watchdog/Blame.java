package rasterlab.tests.watchdog;

import java.util.Arrays;
import java.util.Optional;
import java.util.Set;

/**
 * The calls that the event thread must never make, told from its stack alone: no clock is asked, so
 * a slow machine changes nothing.
 */
enum Blame {
    WAITS("waits for another thread, a process or the clock"),
    READS("reads or writes files or sockets"),
    WORKS("makes pictures, measures, grades or reads the exercises");

    /** How Java waits; who waits is the frame below. */
    private static final String[] WAYS_TO_WAIT = {
        "java.lang.Object", "java.lang.Thread", "java.util.concurrent.", "jdk.internal.misc.Unsafe"
    };

    /**
     * Who has locks of its own, which the program neither takes nor can avoid; a button that is
     * pressed by a key shows it for a moment, asleep.
     */
    private static final String[] TOOLKIT = {
        "java.awt.",
        "javax.swing.AbstractButton",
        "javax.swing.text.",
        "sun.awt.",
        "sun.font.",
        "sun.java2d."
    };

    private static final String[] FILES = {
        "java.io.File",
        "java.io.RandomAccessFile",
        "java.io.UnixFileSystem",
        "java.io.WinNTFileSystem",
        "java.lang.Process",
        "java.net.DatagramSocket",
        "java.net.InetAddress",
        "java.net.Socket",
        "java.net.http.",
        "java.nio.file.Files",
        "sun.net.",
        "sun.nio.ch.",
        "sun.nio.fs."
    };

    /** Classes, resources, fonts and libraries, words for the console, Swing's list of a folder. */
    private static final String[] ALLOWED_FILES = {
        "java.io.PrintStream",
        "java.lang.ClassLoader",
        "java.lang.Runtime",
        "java.lang.invoke.",
        "java.util.ResourceBundle",
        "java.util.ServiceLoader",
        "java.util.jar.",
        "java.util.zip.",
        "javax.swing.JFileChooser",
        "javax.swing.filechooser.",
        "javax.swing.plaf.basic.BasicDirectoryModel",
        "javax.swing.plaf.basic.BasicFileChooserUI",
        "jdk.internal.loader.",
        "org.lwjgl.system.",
        "sun.awt.",
        "sun.font."
    };

    /** Whole packages; what only describes methods and scenes is in others. */
    private static final Set<String> WORK_PACKAGES =
            Set.of(
                    "rasterlab.app.opengl.software",
                    "rasterlab.engine.pipeline",
                    "rasterlab.engine.pipeline.direct",
                    "rasterlab.engine.pipeline.paint",
                    "rasterlab.engine.pipeline.plain",
                    "rasterlab.engine.pipeline.surface",
                    "rasterlab.engine.pipeline.fast",
                    "rasterlab.engine.pipeline.wire",
                    "rasterlab.engine.visibility",
                    "rasterlab.exercises.child",
                    "rasterlab.exercises.runner");

    private static final String[] WORK = {
        "rasterlab.app.row.RowAnswers",
        "rasterlab.engine.raster.PictureDifference",
        "rasterlab.engine.study.HazardTrial",
        "rasterlab.engine.study.MethodTrial",
        "rasterlab.engine.study.StudyRunner",
        "rasterlab.exercises.catalogue.Catalogue"
    };

    private final String said;

    Blame(String said) {
        this.said = said;
    }

    String text() {
        return said;
    }

    /**
     * @param stack of the event thread above the call that dispatched the event, newest frame first
     */
    static Optional<Blame> of(Thread.State state, StackTraceElement[] stack) {
        boolean loading = has(stack, ALLOWED_FILES);
        if (!loading && has(stack, FILES)) return Optional.of(READS);
        if (!loading && state != Thread.State.RUNNABLE && waitsByItself(stack))
            return Optional.of(WAITS);
        return !loading && works(stack) ? Optional.of(WORKS) : Optional.empty();
    }

    private static boolean works(StackTraceElement[] stack) {
        return has(stack, WORK)
                || Arrays.stream(stack)
                        .map(StackTraceElement::getClassName)
                        .anyMatch(name -> WORK_PACKAGES.contains(packageOf(name)));
    }

    private static String packageOf(String className) {
        return className.substring(0, Math.max(0, className.lastIndexOf('.')));
    }

    private static boolean waitsByItself(StackTraceElement[] stack) {
        return Arrays.stream(stack)
                .filter(frame -> !begins(frame, WAYS_TO_WAIT))
                .findFirst()
                .filter(waiter -> !begins(waiter, TOOLKIT))
                .isPresent();
    }

    private static boolean has(StackTraceElement[] stack, String[] names) {
        return Arrays.stream(stack).anyMatch(frame -> begins(frame, names));
    }

    private static boolean begins(StackTraceElement frame, String[] names) {
        return Arrays.stream(names).anyMatch(frame.getClassName()::startsWith);
    }
}
