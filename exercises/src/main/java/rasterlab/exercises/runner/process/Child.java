package rasterlab.exercises.runner.process;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.security.SecureRandom;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import rasterlab.exercises.child.Frames;
import rasterlab.exercises.child.Wire;
import rasterlab.exercises.score.Message;

/**
 * A started child process, asked one request at a time. Reading and writing happen on threads of
 * its own, so a child that neither reads nor writes holds nobody up.
 */
public final class Child implements AutoCloseable {
    private static final byte[] END = new byte[0];
    private static final int MOST_STDERR = 4096;

    /** How long a child that closed its pipe may take to end by itself. */
    private static final Duration GRACE = Duration.ofMillis(500);

    /**
     * A time longer than the system needs to end a killed process, unless it hangs in the kernel.
     */
    private static final Duration DEATH = Duration.ofSeconds(2);

    /** A system counts processor time in steps of about this. */
    private static final Duration LOOK = Duration.ofMillis(10);

    /** How often it is looked whether a process that is no child of ours has come or gone. */
    private static final Duration POLL = Duration.ofMillis(1);

    private final Process process;
    private final boolean boxed;
    private final Optional<ControlGroup> group;
    private final ExecutorService threads =
            Executors.newCachedThreadPool(Daemons.named("rasterlab-child"));
    private final BlockingQueue<byte[]> frames = new ArrayBlockingQueue<>(4);
    private final ProcessorTime processorTime;
    private final SecureRandom nonces = new SecureRandom();
    private volatile String complaint = "";
    private Optional<Duration> answered = Optional.empty();
    private long nonce;

    /**
     * @param boxed whether the process is a box, in which the child proper is another
     */
    public Child(Process process, boolean boxed) {
        this(process, boxed, Optional.empty());
    }

    /**
     * A child that has a control group to itself, which ends with it.
     *
     * @param boxed whether the process is a box, in which the child proper is another
     */
    public Child(Process process, boolean boxed, Optional<ControlGroup> group) {
        this.group = group;
        this.process = process;
        this.boxed = boxed;
        this.processorTime = new ProcessorTime(process, boxed);
        threads.execute(this::readFrames);
        threads.execute(this::drainStderr);
    }

    public boolean isAlive() {
        return process.isAlive();
    }

    /** Whether it is in the control group that it should have to itself; also where it has none. */
    public boolean isInItsGroup() {
        try {
            return group.isEmpty() || group.get().has(process.pid());
        } catch (IOException unread) {
            return false;
        }
    }

    public ProcessHandle handle() {
        return process.toHandle();
    }

    /** The first output of the process to stderr, for our own faults only. */
    public String complaint() {
        return complaint;
    }

    /**
     * Processor time used until the last answer, and until now where there was none yet; empty
     * where the system does not tell. What runs on beside an answer counts with the next one.
     */
    public Optional<Duration> used() {
        return answered.or(processorTime::used);
    }

    /** Asks the child with a limit of wall time alone. */
    public <T> T ask(Request request, Duration wall, PayloadReader<T> reading)
            throws ChildLost, InterruptedException {
        return ask(request, TimeLimit.wall(wall), reading);
    }

    /**
     * Sends a request and reads its answer.
     *
     * @throws ChildLost when there is no usable answer within the limit; the process is dead then
     */
    public <T> T ask(Request request, TimeLimit limit, PayloadReader<T> reading)
            throws ChildLost, InterruptedException {
        nonce = nonces.nextLong();
        byte[] frame = request.frame(nonce);
        Optional<Duration> before = used();
        try {
            threads.execute(() -> send(frame));
        } catch (RejectedExecutionException closed) {
            throw closedByOurselves();
        }
        return more(limit, before, reading);
    }

    /** Reads a further answer to the last request. */
    public <T> T more(TimeLimit limit, PayloadReader<T> reading)
            throws ChildLost, InterruptedException {
        return more(limit, used(), reading);
    }

    private <T> T more(TimeLimit limit, Optional<Duration> before, PayloadReader<T> reading)
            throws ChildLost, InterruptedException {
        byte[] frame = await(limit, before);
        if (frame == END) throw ended();
        try {
            DataInputStream payload = new DataInputStream(new ByteArrayInputStream(frame));
            if (payload.readLong() != nonce) throw new IOException("answer to another request");
            return reading.read(payload.readByte(), payload);
        } catch (IOException | RuntimeException e) {
            close();
            throw ChildLost.protocol(e);
        }
    }

    /** The next frame, for which it is looked again as long as the child has time left. */
    private byte[] await(TimeLimit limit, Optional<Duration> before)
            throws ChildLost, InterruptedException {
        long start = System.nanoTime();
        Duration wait = limit.processor();
        while (true) {
            byte[] frame = frames.poll(wait.toNanos(), TimeUnit.NANOSECONDS);
            if (frame != null) {
                answered = processorTime.used();
                return frame;
            }
            if (threads.isShutdown()) throw closedByOurselves();
            Duration passed = Duration.ofNanos(System.nanoTime() - start);
            Duration used =
                    processorTime.used().map(now -> now.minus(before.orElse(now))).orElse(passed);
            Duration left = limit.processor().minus(used);
            Duration wallLeft = limit.wall().minus(passed);
            if (left.compareTo(LOOK) < 0 || wallLeft.isNegative() || wallLeft.isZero()) {
                close();
                throw ChildLost.late(limit, used);
            }
            wait = shorter(wallLeft, left.compareTo(LOOK) < 0 ? LOOK : left);
        }
    }

    private static Duration shorter(Duration one, Duration other) {
        return one.compareTo(other) < 0 ? one : other;
    }

    /** The judge ended while a grading went on: nothing that the student's method did. */
    private static ChildLost closedByOurselves() {
        return new ChildLost(ChildLost.LossReason.KILLED, Message.of("child.no-judge"));
    }

    public static String seconds(Duration limit) {
        return String.valueOf(limit.toMillis() / 1000.0);
    }

    private void send(byte[] frame) {
        try {
            Frames.write(process.getOutputStream(), frame);
        } catch (IOException childHasEnded) {
            // the reader sees the end of the pipe and tells
            process.destroyForcibly();
        }
    }

    private void readFrames() {
        try (InputStream in = process.getInputStream()) {
            while (true) frames.put(Frames.read(in, Wire.MOST_FRAME_BYTES));
        } catch (IOException endOrRubbish) {
            offerEnd();
        } catch (InterruptedException closed) {
            Thread.currentThread().interrupt();
        }
    }

    private void offerEnd() {
        try {
            frames.put(END);
        } catch (InterruptedException closed) {
            Thread.currentThread().interrupt();
        }
    }

    private void drainStderr() {
        try (InputStream in = process.getErrorStream()) {
            complaint = new String(in.readNBytes(MOST_STDERR), StandardCharsets.UTF_8).strip();
            in.transferTo(OutputStream.nullOutputStream());
        } catch (IOException closed) {
            complaint = complaint.isEmpty() ? closed.toString() : complaint;
        }
    }

    private ChildLost ended() {
        boolean byItself = waitFor(GRACE);
        boolean outOfMemory = group.map(ControlGroup::isOutOfMemory).orElse(false);
        close();
        if (outOfMemory)
            return new ChildLost(ChildLost.LossReason.MEMORY, Message.of("child.memory"));
        if (!byItself)
            return new ChildLost(ChildLost.LossReason.PROTOCOL, Message.of("child.closed"));
        int status = process.exitValue();
        return switch (status) {
            case Wire.EXIT_MEMORY ->
                    new ChildLost(ChildLost.LossReason.MEMORY, Message.of("child.memory"));
            case Wire.EXIT_OUTPUT ->
                    new ChildLost(ChildLost.LossReason.OUTPUT, Message.of("child.output"));
            default ->
                    new ChildLost(
                            status > 128 ? ChildLost.LossReason.SIGNAL : ChildLost.LossReason.ENDED,
                            Message.of("child.ended", status));
        };
    }

    private boolean waitFor(Duration limit) {
        try {
            process.onExit().copy().orTimeout(limit.toNanos(), TimeUnit.NANOSECONDS).join();
            return true;
        } catch (CompletionException late) {
            return false;
        }
    }

    /**
     * Kills the process and all below it, and waits for their end, though not beyond {@link
     * #DEATH}.
     */
    @Override
    public void close() {
        List<ProcessHandle> below = started();
        below.forEach(ProcessHandle::destroyForcibly);
        awaitEnd(below);
        process.destroyForcibly();
        waitFor(DEATH);
        group.ifPresent(ControlGroup::end);
        threads.shutdownNow();
        // The reader may have been stopped before it could tell one who waits for an answer.
        frames.clear();
        frames.offer(END);
    }

    /**
     * The processes below. A box starts exactly one, which then starts others, and that one is
     * waited for: without its box it would neither go on nor end.
     */
    private List<ProcessHandle> started() {
        long deadline = System.nanoTime() + DEATH.toNanos();
        while (true) {
            List<ProcessHandle> below = process.descendants().toList();
            boolean all = !boxed || !below.isEmpty() || !process.isAlive();
            if (all || System.nanoTime() > deadline) return below;
            LockSupport.parkNanos(POLL.toNanos());
        }
    }

    private static void awaitEnd(List<ProcessHandle> killed) {
        long deadline = System.nanoTime() + DEATH.toNanos();
        while (killed.stream().anyMatch(ProcessHandle::isAlive) && System.nanoTime() < deadline)
            LockSupport.parkNanos(POLL.toNanos());
    }
}
