package rasterlab.exercises.runner;

import java.io.UncheckedIOException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.EnumMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import rasterlab.exercises.child.Wire;
import rasterlab.exercises.runner.process.Child;
import rasterlab.exercises.runner.process.ChildLost;
import rasterlab.exercises.runner.process.Launcher;
import rasterlab.exercises.runner.process.Request;
import rasterlab.exercises.runner.process.TimeLimit;
import rasterlab.exercises.score.Message;

/**
 * Starts children and keeps some unused ones in reserve. A child serves one submission and is never
 * taken back.
 */
final class Children implements AutoCloseable {
    private static final Map<ChildKind, Integer> RESERVE =
            reserve(Runtime.getRuntime().availableProcessors());

    private static final System.Logger LOG = System.getLogger(Children.class.getName());

    private Box box;
    private final Launcher launcher;
    private final boolean spares;
    private final Map<ChildKind, Deque<Child>> waiting = new EnumMap<>(ChildKind.class);
    private final Set<Child> started = new HashSet<>();
    private boolean closed;

    /**
     * How many wait of each kind: one for each core and one more, of which a submission takes one
     * to compile and the others to run.
     */
    static Map<ChildKind, Integer> reserve(int cores) {
        int compiling = Math.max(1, (cores + 1) / 3);
        return Map.of(
                ChildKind.COMPILE, compiling, ChildKind.RUN, Math.max(1, cores + 1 - compiling));
    }

    Children(Box box, Launcher launcher, boolean spares) {
        this.box = box;
        this.launcher = launcher;
        this.spares = spares;
        for (ChildKind kind : ChildKind.values()) waiting.put(kind, new ArrayDeque<>());
    }

    /**
     * A child that nobody used, to be closed by the caller.
     *
     * @throws ChildLost when this was closed, as for the children that were in use then
     */
    synchronized Child take(ChildKind kind) throws ChildLost {
        if (closed) throw new ChildLost(ChildLost.LossReason.KILLED, Message.of("child.no-judge"));
        Deque<Child> reserve = waiting.get(kind);
        while (!reserve.isEmpty()) {
            Child child = reserve.remove();
            if (child.isAlive()) return child;
            child.close();
        }
        return start(kind, false);
    }

    /**
     * A child that nobody used, and that has answered. What ends it from now on is what it is
     * asked: that one could not start says nothing about a student's method.
     *
     * @param limit for its start
     * @throws ChildLost when it does not answer, as for one that was killed from outside
     */
    Child takeReady(ChildKind kind, TimeLimit limit) throws ChildLost, InterruptedException {
        Child child = take(kind);
        try {
            child.ask(new Request(Wire.PING, out -> {}), limit, (status, in) -> status);
            return child;
        } catch (ChildLost lost) {
            child.close();
            throw new ChildLost(ChildLost.LossReason.KILLED, lost.message());
        } catch (InterruptedException stopped) {
            child.close();
            throw stopped;
        }
    }

    /** Starts what is missing in the reserve; does not wait until it is ready. */
    void refill() {
        for (ChildKind kind : ChildKind.values()) refill(kind);
    }

    /** Starts what is missing of one kind. */
    private synchronized void refill(ChildKind kind) {
        if (!spares || closed) return;
        Deque<Child> reserve = waiting.get(kind);
        while (reserve.size() < RESERVE.get(kind)) reserve.add(start(kind, true));
    }

    /** Starts children in that box from now on; those in use go on as they are. */
    void moveTo(Box other) {
        List<Child> unused;
        synchronized (this) {
            box = other;
            unused = waiting.values().stream().flatMap(Deque::stream).toList();
            waiting.values().forEach(Deque::clear);
        }
        unused.forEach(Child::close);
        topUp(ChildKind.values());
    }

    /** Refills what gradings need next; that it fails must not take anybody's report away. */
    void topUp(ChildKind... kinds) {
        try {
            for (ChildKind kind : kinds) refill(kind);
        } catch (UncheckedIOException cannotStart) {
            LOG.log(System.Logger.Level.WARNING, "no child can be kept in reserve", cannotStart);
        }
    }

    synchronized int living() {
        return (int) started.stream().filter(Child::isAlive).count();
    }

    private Child start(ChildKind kind, boolean warm) {
        started.removeIf(child -> !child.isAlive());
        Child child = box.start(launcher, kind, warm);
        started.add(child);
        return child;
    }

    /** Kills all children, also those in use: their gradings end with an internal fault. */
    @Override
    public void close() {
        List<Child> running;
        synchronized (this) {
            closed = true;
            running = List.copyOf(started);
        }
        running.forEach(Child::close);
    }
}
