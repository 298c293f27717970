package rasterlab.exercises.runner;

import java.io.File;
import java.util.ArrayList;
import java.util.List;
import rasterlab.exercises.child.CompileMain;
import rasterlab.exercises.child.RunMain;
import rasterlab.exercises.runner.process.ControlGroups.GroupLimits;

/** The two kinds of children and the limits their Java machines get. */
enum ChildKind {
    COMPILE(
            List.of("jdk.compiler", "jdk.zipfs", "java.se", "jdk.unsupported"),
            List.of("-Xmx256m", "-Xss4m", "-XX:TieredStopAtLevel=1", "-XX:ActiveProcessorCount=2"),
            new GroupLimits(768L << 20, 128, 2)),
    /**
     * Compiles before it goes on: what is timed does not depend on when a compiler had its turn.
     */
    RUN(
            List.of("java.base"),
            List.of(
                    "-XX:-BackgroundCompilation",
                    "-Xmx64m",
                    "-Xss512k",
                    "-XX:MaxMetaspaceSize=48m",
                    "-XX:MaxDirectMemorySize=1m",
                    "-XX:ReservedCodeCacheSize=32m",
                    "-XX:ActiveProcessorCount=2"),
            new GroupLimits(384L << 20, 128, 1));

    /** VM messages must not reach stdout: it carries the protocol. */
    private static final List<String> COMMON =
            List.of(
                    "-Xshare:auto",
                    "-XX:+UseSerialGC",
                    "-XX:+DisableAttachMechanism",
                    "-XX:-UsePerfData",
                    "-XX:+DisableExplicitGC",
                    "-XX:+ExitOnOutOfMemoryError",
                    "-XX:+DisplayVMOutputToStderr",
                    "-XX:ErrorFile=/dev/null",
                    "-Xlog:disable",
                    "-Djava.awt.headless=true");

    private final List<String> modules;
    private final List<String> limits;
    private final GroupLimits group;

    ChildKind(List<String> modules, List<String> limits, GroupLimits group) {
        this.modules = modules;
        this.limits = limits;
        this.group = group;
    }

    /** The limits of a child's processes together, above what its Java machine takes by its own. */
    GroupLimits group() {
        return group;
    }

    /**
     * The modules of Java that it needs. A compiler reads what Java 17 had by jdk.zipfs, and has
     * the modules that a source may name: a class that is not allowed is refused as such then, and
     * not as unknown.
     */
    List<String> modules() {
        return modules;
    }

    /**
     * The arguments for java.
     *
     * @param harness path of the harness jar as the child sees it
     * @param contract path of the contract jar as the child sees it
     * @param warm whether the compiler tries itself out before the source comes
     */
    List<String> arguments(String harness, String contract, boolean warm) {
        List<String> arguments = new ArrayList<>(COMMON);
        arguments.addAll(limits);
        arguments.add("-cp");
        if (this == RUN) {
            arguments.add(harness + File.pathSeparator + contract);
            arguments.add(RunMain.class.getName());
        } else {
            arguments.add(harness);
            arguments.add(CompileMain.class.getName());
            arguments.add(contract);
            if (warm) arguments.add("warm");
        }
        return arguments;
    }
}
