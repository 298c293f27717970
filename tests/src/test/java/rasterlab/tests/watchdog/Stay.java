package rasterlab.tests.watchdog;

import java.awt.AWTEvent;
import java.awt.Component;
import java.awt.event.InvocationEvent;
import java.awt.event.WindowEvent;
import java.lang.management.ThreadInfo;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * How long one event keeps the event thread, and what the thread is seen to do meanwhile. A dialog
 * that an event opens ends its stay: while the dialog's own loop runs, the thread is free.
 */
final class Stay {
    /**
     * The number of times, at intervals of 10 ms, that the same must be seen in one event: once may
     * be bad luck of a busy machine.
     */
    private static final int SEEN = 5;

    /** The newest frames that a fault shows. */
    private static final int FRAMES = 30;

    private final AWTEvent event;
    private final Optional<Watch> watch;
    private final Thread thread = Thread.currentThread();
    private final long begunNanos = System.nanoTime();
    private final Map<Blame, Integer> blamed = new EnumMap<>(Blame.class);
    private final Map<String, Integer> frames = new HashMap<>();
    private long nanos;

    /**
     * A stay in an event, made on the event thread when it begins.
     *
     * @param watch told of it
     */
    Stay(AWTEvent event, Optional<Watch> watch) {
        this.event = event;
        this.watch = watch;
    }

    AWTEvent event() {
        return event;
    }

    /** The watch at its beginning; a later one knows too little of it. */
    Optional<Watch> watch() {
        return watch;
    }

    long threadId() {
        return thread.getId();
    }

    /** Nanoseconds until now. */
    long age() {
        return System.nanoTime() - begunNanos;
    }

    synchronized void end() {
        nanos = age();
    }

    /** Nanoseconds from begin to end. */
    synchronized long nanos() {
        return nanos;
    }

    /** Notes what the thread does now; the answer tells a fault, once. */
    synchronized Optional<String> see(ThreadInfo thread) {
        StackTraceElement[] stack = sinceDispatch(thread.getStackTrace());
        frames.merge(own(stack), 1, Integer::sum);
        Optional<Blame> blame = Blame.of(thread.getThreadState(), stack);
        // A window that is closed may wait for the last that it has to write.
        if (blame.isEmpty() || event.getID() == WindowEvent.WINDOW_CLOSED) return Optional.empty();
        int seen = blamed.merge(blame.get(), 1, Integer::sum);
        return seen == SEEN ? Optional.of(fault(blame.get(), stack)) : Optional.empty();
    }

    private static StackTraceElement[] sinceDispatch(StackTraceElement[] stack) {
        return Arrays.stream(stack)
                .takeWhile(frame -> !frame.getClassName().equals(WatchedQueue.class.getName()))
                .toArray(StackTraceElement[]::new);
    }

    private String fault(Blame blame, StackTraceElement[] stack) {
        return "the event thread "
                + blame.text()
                + " in "
                + name()
                + Arrays.stream(stack)
                        .limit(FRAMES)
                        .map(frame -> "\n    at " + frameText(frame))
                        .collect(Collectors.joining());
    }

    /** The frame's text without the names of loader and module. */
    private static String frameText(StackTraceElement frame) {
        return "%s.%s(%s:%d)"
                .formatted(
                        frame.getClassName(),
                        frame.getMethodName(),
                        frame.getFileName(),
                        frame.getLineNumber());
    }

    /** The newest frame of the project's, best of what is shipped. */
    private static String own(StackTraceElement[] stack) {
        String found = stack.length == 0 ? "nothing" : frameText(stack[0]);
        boolean ofTests = false;
        for (StackTraceElement frame : stack) {
            String name = frame.getClassName();
            if (!name.startsWith("rasterlab.")) continue;
            if (!name.startsWith("rasterlab.tests.")) return frameText(frame);
            if (!ofTests) found = frameText(frame);
            ofTests = true;
        }
        return found;
    }

    /** Where it was seen most often. */
    synchronized String place() {
        return frames.entrySet().stream()
                .max(Map.Entry.comparingByValue())
                .map(Map.Entry::getKey)
                .orElse("not seen");
    }

    /** The event's kind and whose it is, or what it runs. */
    String name() {
        String kind = event.getClass().getSimpleName();
        String said = event.paramString();
        if (event instanceof InvocationEvent) {
            String runs = said.replaceFirst(".*runnable=", "").replaceFirst("[,@].*", "");
            return kind + " " + runs.replaceFirst("\\$\\$Lambda.*", " (lambda)");
        }
        String of = event.getSource().getClass().getSimpleName();
        boolean named = event.getSource() instanceof Component part && part.getName() != null;
        return kind
                + " "
                + said.replaceFirst("[, ].*", "")
                + " on "
                + (named ? ((Component) event.getSource()).getName() : of);
    }
}
