package rasterlab.exercises.runner;

import java.time.Duration;
import rasterlab.contract.LineRasterizer;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.child.ContractCalls;
import rasterlab.exercises.child.Wire;
import rasterlab.exercises.runner.process.Child;
import rasterlab.exercises.runner.process.ChildJars;
import rasterlab.exercises.runner.process.ChildLost;
import rasterlab.exercises.runner.process.Launcher;
import rasterlab.exercises.runner.process.Request;
import rasterlab.exercises.runner.process.TimeLimit;
import rasterlab.exercises.score.Answer;

/** Runs sources without the byte-code check, to see what the process alone holds. */
final class Unscanned implements AutoCloseable {
    private static final TopicGrading.GradedCall CALL = LongLine.call();
    static final ContractCalls CONTRACT = ContractCalls.of(LineRasterizer.class);
    private static final Duration CALL_LIMIT = Duration.ofSeconds(3);

    final ChildJars jars = ChildJars.assemble();
    private final Launcher launcher = new Launcher(jars);
    final Box box;
    private final Children children;

    Unscanned(JudgeSettings.Protection wanted) {
        JudgeSettings settings = JudgeSettings.once().withImages(StartedJudge.IMAGES);
        ChildJava java = ChildJava.found(settings, launcher, jars);
        box = BoxChoice.on(launcher, jars, java).choose(wanted);
        children = new Children(box, launcher, false);
    }

    Child child(ChildKind kind) throws ChildLost {
        return children.take(kind);
    }

    /** Loads the class "Mine" and draws one line with it. */
    Answer draw(Child runner, String source) throws ChildLost, InterruptedException {
        try (Child compiler = child(ChildKind.COMPILE)) {
            Compilation compiled =
                    Compilation.of(source, compiler, TimeLimit.wall(Duration.ofMinutes(2)));
            if (!compiled.errors().isEmpty())
                throw new AssertionError(LineRasterizer.class + " " + compiled.errors());
            StudentRun run = new StudentRun(runner, CONTRACT, CALL_LIMIT, new Patience(() -> 0));
            run.load("Mine", compiled.classes());
            return run.call(CALL, CALL.caps());
        }
    }

    /** The number of pixels that it drew within that limit. */
    int draw(String source, TimeLimit limit) throws ChildLost, InterruptedException {
        Patience patience = new Patience(() -> 0);
        try (Child compiler = child(ChildKind.COMPILE);
                Child runner = child(ChildKind.RUN)) {
            Compilation compiled =
                    Compilation.of(source, compiler, TimeLimit.wall(Duration.ofMinutes(2)));
            StudentRun run = new StudentRun(runner, CONTRACT, Duration.ofMinutes(1), patience);
            run.load("Mine", compiled.classes());
            Request request =
                    new Request(
                            Wire.CALL,
                            out -> {
                                out.writeBoolean(true);
                                out.writeInt(Wire.MOST_ITEMS);
                                out.writeInt(Wire.MOST_ANSWER_BYTES);
                                out.writeInt(0);
                                CONTRACT.all()
                                        .get(0)
                                        .writeArguments(new Object[] {0, 0, 1001, 500, null}, out);
                            });
            return runner.ask(
                    request,
                    limit,
                    (status, in) -> {
                        in.readInt();
                        return in.readInt();
                    });
        }
    }

    Answer draw(String source) throws ChildLost, InterruptedException {
        try (Child runner = child(ChildKind.RUN)) {
            return draw(runner, source);
        }
    }

    @Override
    public void close() {
        children.close();
        launcher.close();
        jars.close();
    }
}
