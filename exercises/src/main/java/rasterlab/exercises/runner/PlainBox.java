package rasterlab.exercises.runner;

import java.util.ArrayList;
import java.util.List;
import rasterlab.exercises.runner.process.ChildJars;
import rasterlab.exercises.runner.process.Programs;
import rasterlab.exercises.score.Message;

/** A process of its own and the limits that go with it, on every operating system. */
final class PlainBox implements Box {
    private final ChildJars jars;
    private final ChildJava java;
    private final Isolation isolation;

    PlainBox(ChildJars jars, ChildJava java, Message reason) {
        this.jars = jars;
        this.java = java;
        this.isolation = Isolation.processLimits(reason, java.lacking());
    }

    @Override
    public Isolation isolation() {
        return isolation;
    }

    @Override
    public boolean nested() {
        return false;
    }

    @Override
    public List<String> command(ChildKind kind, boolean warm) {
        List<String> command = new ArrayList<>(Programs.limits(false));
        command.add(java.program(kind));
        command.addAll(kind.arguments(jars.harness().toString(), jars.contract().toString(), warm));
        return command;
    }
}
