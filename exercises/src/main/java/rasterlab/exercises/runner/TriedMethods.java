package rasterlab.exercises.runner;

import java.io.DataInputStream;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import rasterlab.engine.study.Verdict;
import rasterlab.exercises.breaking.BreakMain;
import rasterlab.exercises.child.Frames;
import rasterlab.exercises.judging.MethodsOnInput.MethodResult;
import rasterlab.exercises.runner.process.Child;
import rasterlab.exercises.runner.process.ChildLost;
import rasterlab.exercises.runner.process.Request;
import rasterlab.exercises.runner.process.TimeLimit;
import rasterlab.exercises.score.Message;

/**
 * Tries right and faulty methods on an input in a process that can be killed.
 *
 * @param right those that promise to be right
 * @param faulty none where the right ones do not agree
 */
record TriedMethods(List<MethodResult> right, List<MethodResult> faulty) {
    private static final int MOST_METHODS = 1000;
    private static final int MOST_SAID_BYTES = 1 << 16;

    /** The arguments for a Java machine that tries methods. */
    static List<String> command(String java) {
        return List.of(
                java,
                "-Xmx256m",
                "-Xss1m",
                "-XX:+UseSerialGC",
                "-XX:-UsePerfData",
                "-XX:+DisableAttachMechanism",
                "-XX:+ExitOnOutOfMemoryError",
                "-XX:+DisplayVMOutputToStderr",
                "-XX:ErrorFile=/dev/null",
                "-Djava.awt.headless=true",
                "-cp",
                classPath(),
                BreakMain.class.getName());
    }

    /** The class path of this process; relative parts are meant from its folder. */
    private static String classPath() {
        List<String> parts = new ArrayList<>();
        for (String part : System.getProperty("java.class.path").split(File.pathSeparator))
            if (!part.isEmpty()) parts.add(new File(part).getAbsolutePath());
        return String.join(File.pathSeparator, parts);
    }

    /**
     * Asks a child.
     *
     * @param names of faulty methods
     * @param limit for all methods on one input
     * @throws ChildLost when the methods take too long or too much memory
     */
    static TriedMethods on(
            String topic, String input, Collection<String> names, TimeLimit limit, Child child)
            throws ChildLost, InterruptedException {
        Request request =
                new Request(
                        0,
                        out -> {
                            out.writeUTF(topic);
                            Frames.write(out, input.getBytes(StandardCharsets.UTF_8));
                            out.writeInt(names.size());
                            for (String name : names) out.writeUTF(name);
                        });
        return child.ask(request, limit, (status, in) -> new TriedMethods(read(in), read(in)));
    }

    private static List<MethodResult> read(DataInputStream in) throws IOException {
        int count = in.readInt();
        if (count < 0 || count > MOST_METHODS) throw new IOException(count + " methods");
        List<MethodResult> tried = new ArrayList<>();
        for (int left = count; left > 0; left--) {
            String name = in.readUTF();
            Verdict.Kind kind = Verdict.Kind.valueOf(in.readUTF());
            byte[] said = Frames.read(in, MOST_SAID_BYTES);
            tried.add(
                    new MethodResult(
                            name,
                            kind,
                            Message.ofData(new String(said, StandardCharsets.UTF_8), "")));
        }
        return tried;
    }
}
