package rasterlab.exercises.runner;

import static rasterlab.exercises.Sources.method;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.locks.LockSupport;
import rasterlab.exercises.runner.process.Child;
import rasterlab.exercises.runner.process.Daemons;
import rasterlab.exercises.runner.process.TimeLimit;

/**
 * A judge's process whose child, in no box, is at something endless until this process is killed.
 */
final class ChildWithParent {
    private static final Duration LONG = Duration.ofMinutes(10);

    private ChildWithParent() {}

    /**
     * Prints the child's process id as soon as the child is in the endless call.
     *
     * @param args an unused file's name, by which the child tells that it is
     */
    public static void main(String[] args) throws Exception {
        Path begun = Path.of(args[0]);
        try (Unscanned unscanned = new Unscanned(JudgeSettings.Protection.PROCESS_LIMITS_ONLY);
                Child compiler = unscanned.child(ChildKind.COMPILE);
                Child child = unscanned.child(ChildKind.RUN)) {
            Daemons.named("teller").newThread(() -> tell(begun, child)).start();
            Compilation compiled = Compilation.of(endless(begun), compiler, TimeLimit.wall(LONG));
            StudentRun run = new StudentRun(child, Unscanned.CONTRACT, LONG, new Patience(() -> 0));
            run.load("Mine", compiled.classes());
            run.call(LongLine.call(), LongLine.call().caps());
        }
    }

    private static void tell(Path begun, Child child) {
        while (!Files.exists(begun)) LockSupport.parkNanos(1_000_000);
        System.out.println(child.handle().pid());
    }

    private static String endless(Path begun) {
        return method(
                "try { new java.io.File(\""
                        + begun
                        + "\").createNewFile(); } catch (java.io.IOException e) { }\n"
                        + "while (true) java.util.concurrent.locks.LockSupport.park();\n");
    }
}
