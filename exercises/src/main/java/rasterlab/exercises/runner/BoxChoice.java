package rasterlab.exercises.runner;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import rasterlab.exercises.child.Wire;
import rasterlab.exercises.runner.Isolation.ProcessLimit;
import rasterlab.exercises.runner.process.Child;
import rasterlab.exercises.runner.process.ChildJars;
import rasterlab.exercises.runner.process.ChildLost;
import rasterlab.exercises.runner.process.ControlGroups;
import rasterlab.exercises.runner.process.ControlGroups.FoundGroups;
import rasterlab.exercises.runner.process.Launcher;
import rasterlab.exercises.runner.process.LimitCheck;
import rasterlab.exercises.runner.process.Programs;
import rasterlab.exercises.runner.process.Request;
import rasterlab.exercises.runner.process.SystemAccount;
import rasterlab.exercises.runner.process.SystemCallFilter;
import rasterlab.exercises.runner.process.TimeLimit;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.Message;

/** Finds the strongest box that works on this machine by trying it once. */
final class BoxChoice {
    /** Long enough for a machine on which many programs start at once. */
    private static final Duration PATIENCE = Duration.ofMinutes(1);

    private final Launcher launcher;
    private final ChildJars jars;
    private final Duration limit;
    private ChildJava java;
    private FoundGroups groups;

    /**
     * @param limit how long the box's program may take for one answer
     */
    BoxChoice(Launcher launcher, ChildJars jars, ChildJava java, Duration limit) {
        this.launcher = launcher;
        this.jars = jars;
        this.java = java;
        this.groups = new FoundGroups(Optional.empty(), Message.NONE);
        this.limit = limit;
    }

    static BoxChoice on(Launcher launcher, ChildJars jars, ChildJava java) {
        return new BoxChoice(launcher, jars, java, PATIENCE);
    }

    Box choose(JudgeSettings.Protection wanted) {
        if (wanted == JudgeSettings.Protection.PROCESS_LIMITS_ONLY)
            return plain("isolation.not-asked");
        return Programs.onPath("bwrap")
                .map(this::inBubblewrap)
                .orElseGet(() -> plain("isolation.no-bwrap"));
    }

    /**
     * A box by that program, or a plain one that says why not.
     *
     * @param program path of bwrap
     */
    Box inBubblewrap(String program) {
        try {
            String help = output(program, "--help");
            if (!help.contains("--size")) return plain("isolation.old-bwrap");
            return tried(program, output(program, "--version"), help.contains("--disable-userns"));
        } catch (IOException e) {
            return plain("isolation.bwrap-fails", e.getMessage());
        }
    }

    /** One that answers, on an image of Java before on the running JDK. */
    private Box tried(String program, String version, boolean canDisable) {
        groups = ControlGroups.find();
        Tried found = onThisJava(program, version, canDisable);
        if (found.box().isEmpty() && java.isImage()) {
            java = java.without(found.fault());
            found = onThisJava(program, version, canDisable);
        }
        String fault = found.fault();
        return found.box().orElseGet(() -> plain("isolation.bwrap-fails", fault));
    }

    /** A box that answers, or why none does. */
    private record Tried(Optional<Box> box, String fault) {}

    /** The strongest that answers: without the filter before without any limit. */
    private Tried onThisJava(String program, String version, boolean canDisable) {
        Optional<String> fault = Optional.empty();
        for (boolean filtered : filters())
            for (ProcessLimit most : limits()) {
                List<Message> faults = new ArrayList<>();
                if (!canDisable) faults.add(Message.of("isolation.no-userns-off"));
                if (!filtered) faults.add(Message.of("isolation.no-filter"));
                fault = selfTest(box(program, version, canDisable, most, filtered, faults), faults);
                if (fault.isEmpty()) {
                    Box works = box(program, version, canDisable, most, filtered, faults);
                    return new Tried(Optional.of(works), "");
                }
            }
        return new Tried(Optional.empty(), fault.orElseThrow());
    }

    private BubblewrapBox box(
            String program,
            String version,
            boolean canDisable,
            ProcessLimit most,
            boolean filtered,
            List<Message> faults) {
        return new BubblewrapBox(
                program, version, canDisable, most, filtered, faults, jars, java, groups);
    }

    private static List<Boolean> filters() {
        return SystemCallFilter.program().isPresent() ? List.of(true, false) : List.of(false);
    }

    private static List<ProcessLimit> limits() {
        ProcessLimit expected = expectedLimit();
        return expected == ProcessLimit.HOLDS
                ? List.of(ProcessLimit.HOLDS, ProcessLimit.TOO_LOW)
                : List.of(expected);
    }

    private static ProcessLimit expectedLimit() {
        if (Programs.onPath("prlimit").isEmpty()) return ProcessLimit.NO_PRLIMIT;
        return SystemAccount.exceedsLimits() ? ProcessLimit.ROOT : ProcessLimit.HOLDS;
    }

    private Box plain(String reason, Object... arguments) {
        return new PlainBox(jars, java, Message.of(reason, arguments));
    }

    /**
     * Why a child in the box does not answer; empty when one of each kind does.
     *
     * @param faults takes up what does not hold for one that answers
     */
    private Optional<String> selfTest(BubblewrapBox box, List<Message> faults) {
        Optional<String> fault = selfTest(box, ChildKind.RUN, faults);
        if (fault.isPresent() || !java.isImage()) return fault;
        return selfTest(box, ChildKind.COMPILE, new ArrayList<>());
    }

    private Optional<String> selfTest(BubblewrapBox box, ChildKind kind, List<Message> faults) {
        try (Child child = box.start(launcher, kind, false)) {
            try {
                if (kind == ChildKind.COMPILE) return compileFault(child);
                child.ask(new Request(Wire.PING, out -> {}), limit, (status, payload) -> status);
                if (box.limit() != ProcessLimit.NO_PRLIMIT)
                    LimitCheck.fault(child.handle(), box.limit() != ProcessLimit.TOO_LOW)
                            .map(what -> Message.of("isolation.limit-fails", what))
                            .ifPresent(faults::add);
                if (!child.isInItsGroup())
                    faults.add(Message.of("isolation.groups-fail", "cgroup.procs"));
                if (box.isFiltered() && !SystemCallFilter.holdsBelow(child.handle()))
                    faults.add(Message.of("isolation.no-filter"));
                return Optional.empty();
            } catch (ChildLost lost) {
                return Optional.of(
                        child.complaint().isEmpty()
                                ? lost.getMessage()
                                : child.complaint().lines().findFirst().orElseThrow());
            } catch (InterruptedException e) {
                throw interrupted(e);
            }
        }
    }

    private Optional<String> compileFault(Child child) throws ChildLost, InterruptedException {
        return Compilation.of("final class Mine {}", child, TimeLimit.wall(limit)).errors().stream()
                .findFirst()
                .map(Diagnostic::message);
    }

    /**
     * The output of the program; less than fills a pipe, as it is read only when it has ended.
     *
     * @throws IOException when it cannot be started or does not end
     */
    private String output(String program, String option) throws IOException {
        Process process = started(program, option);
        try (var in = process.getInputStream()) {
            if (!process.waitFor(limit.toNanos(), TimeUnit.NANOSECONDS))
                throw new IOException(
                        option + " gave no answer within " + Child.seconds(limit) + " s");
            return new String(in.readNBytes(1 << 16), StandardCharsets.UTF_8).strip();
        } catch (InterruptedException e) {
            throw interrupted(e);
        } finally {
            process.destroyForcibly();
        }
    }

    private Process started(String program, String option) throws IOException {
        try {
            return launcher.start(List.of(program, option));
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
    }

    private static IllegalStateException interrupted(InterruptedException e) {
        Thread.currentThread().interrupt();
        return new IllegalStateException("interrupted while trying bubblewrap", e);
    }
}
