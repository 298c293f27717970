package rasterlab.tests.frontdoor;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import rasterlab.tests.ChildProcess;
import rasterlab.tests.Repository;

/**
 * The script {@code lab} in a folder of its own, where everything seems to be built and Java is a
 * script that only says how it is called. No source is copied and nothing is built.
 *
 * @param folder where {@code lab} lies
 */
record BuiltLab(Path folder) {
    private static final List<String> FILES = List.of("lab", "app/java-options");
    private static final List<String> STAMPS = List.of("built", "built-bench");

    /**
     * @param folder empty
     * @param java what the script for Java does with the words after {@code -XshowSettings}
     */
    static BuiltLab in(Path folder, String java) throws IOException {
        for (var file : FILES) {
            Files.createDirectories(folder.resolve(file).getParent());
            Files.copy(Repository.root().resolve(file), folder.resolve(file));
        }
        var state = Files.createDirectories(folder.resolve("target/lab"));
        for (var stamp : STAMPS) Files.createFile(state.resolve(stamp));
        program(folder.resolve("bin/javac"), "#!/bin/sh\n");
        program(
                folder.resolve("bin/java"),
                """
                #!/bin/sh
                case $1 in
                    -XshowSettings*) printf '    java.%%s = %%s\\n' specification.version 17 home '%s' ;;
                    *) %s ;;
                esac
                """
                        .formatted(folder, java));
        return new BuiltLab(folder);
    }

    private static void program(Path file, String text) throws IOException {
        Files.createDirectories(file.getParent());
        Files.writeString(file, text);
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwxr-xr-x"));
    }

    /** Runs {@code ./lab} with these words, its Java being the one that says how it is called. */
    ChildProcess call(List<String> words) {
        var command = new ArrayList<>(List.of(folder.resolve("lab").toString()));
        command.addAll(words);
        var environment = Map.of("JAVA_HOME", folder.toString());
        return ChildProcess.run(folder, environment, Duration.ofMinutes(5), command);
    }
}
