package rasterlab.tests.process;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** The call of a Java program with this one's Java and classes. */
public final class JavaCommand {
    private JavaCommand() {}

    /**
     * @param options of Java's own
     */
    public static List<String> of(List<String> options, String mainClass, List<String> arguments) {
        String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
        String classPath =
                System.getProperty(
                        "surefire.test.class.path", System.getProperty("java.class.path"));
        var command = new ArrayList<>(List.of(java));
        command.addAll(options);
        command.addAll(List.of("-cp", classPath, mainClass));
        command.addAll(arguments);
        return command;
    }
}
