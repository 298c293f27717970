package rasterlab.engine.pipeline;

import static java.util.stream.Collectors.counting;
import static java.util.stream.Collectors.groupingBy;
import static java.util.stream.Collectors.joining;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import jdk.jfr.Recording;
import jdk.jfr.consumer.RecordedEvent;
import jdk.jfr.consumer.RecordingFile;

/** Counts what the threads of a pipeline allocate; one pipeline at a time. */
public final class FrameBytes {
    private static final int ROUNDS = 3;

    private FrameBytes() {}

    /** Fails where frames allocate once thirty of them are drawn. */
    public static void assertNoneInLaterFrames(Runnable frame) {
        for (int k = 0; k < 30; k++) frame.run();
        long[] team = team();
        long least = Long.MAX_VALUE;
        // The counter and the first calls of the test itself allocate; frames must not.
        for (int round = 0; round < ROUNDS && least != 0; round++) {
            long before = allocated(team);
            long counting = allocated(team) - before;
            before = allocated(team);
            for (int k = 0; k < 20; k++) frame.run();
            long bytes = allocated(team) - before - counting;
            if (bytes >= 0) least = Math.min(least, bytes);
        }
        if (least != 0) fail(least + " bytes in 20 frames, at" + allocating(frame));
    }

    /** Where most of the allocations of many more frames come from, the most frequent first. */
    private static String allocating(Runnable frame) {
        try (var recording = new Recording()) {
            recording.enable("jdk.ObjectAllocationInNewTLAB").withStackTrace();
            recording.start();
            for (int k = 0; k < 3000; k++) frame.run();
            recording.stop();
            Path file = Files.createTempFile("frames", ".jfr");
            try {
                recording.dump(file);
                return RecordingFile.readAllEvents(file).stream()
                        .filter(event -> event.getStackTrace() != null)
                        .collect(groupingBy(FrameBytes::place, counting()))
                        .entrySet()
                        .stream()
                        .sorted(Map.Entry.<String, Long>comparingByValue().reversed())
                        .limit(5)
                        .map(place -> "\n" + place.getValue() + " × " + place.getKey())
                        .collect(joining());
            } finally {
                Files.delete(file);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String place(RecordedEvent event) {
        return event.getClass("objectClass").getName()
                + event.getStackTrace().getFrames().stream()
                        .limit(12)
                        .map(
                                at ->
                                        " < "
                                                + at.getMethod().getType().getName()
                                                + "."
                                                + at.getMethod().getName()
                                                + ":"
                                                + at.getLineNumber()
                                                + " "
                                                + at.getType())
                        .collect(joining());
    }

    private static long[] team() {
        return Thread.getAllStackTraces().keySet().stream()
                .filter(
                        thread ->
                                thread == Thread.currentThread()
                                        || thread.getName().startsWith("rasterlab-pipeline"))
                .mapToLong(Thread::getId)
                .toArray();
    }

    private static long allocated(long[] threads) {
        var counter = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        long sum = 0;
        for (long thread : threads) sum += counter.getThreadAllocatedBytes(thread);
        return sum;
    }
}
