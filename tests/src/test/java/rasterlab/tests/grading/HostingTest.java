package rasterlab.tests.grading;

import static java.util.stream.Collectors.joining;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.tests.ChildProcess;
import rasterlab.tests.Repository;
import rasterlab.tests.process.JavaCommand;

/**
 * Runs HOSTING.md from its first command to its last, with the server, its settings and its units
 * as they are. What only root and systemd can do is done by the scripts in {@code hosting}, and the
 * folders of the machine lie in a folder of the test's own.
 */
@Tag("slow")
@EnabledOnOs(OS.LINUX)
class HostingTest {
    private static final Path GUIDE = Repository.root().resolve("grader/HOSTING.md");
    private static final List<String> FILES =
            List.of(
                    "server.yaml",
                    "rasterlab.service",
                    "rasterlab-backup.service",
                    "rasterlab-backup.timer",
                    "Caddyfile");
    private static final List<String> STAND_INS =
            List.of("sudo", "apt-get", "adduser", "systemctl");

    /** Settings of systemd by which the kernel refuses to make a namespace, or to name its host. */
    private static final Set<String> KEEPS_BUBBLEWRAP_OUT =
            Set.of("ProtectHostname", "RestrictNamespaces", "PrivateUsers", "SystemCallFilter");

    private static final Pattern TOKEN = Pattern.compile("instructor token: (\\S+)");
    private static final Pattern COURSE = Pattern.compile("\"course\" *: *\"([^\"]+)\"");
    private static final Pattern LINK = Pattern.compile("\\]\\(([^)]+)\\)");

    @TempDir private Path machine;

    @Test
    @DisplayName("a command of HOSTING.md does not do what the text says")
    void everyCommandWorks() throws IOException {
        assumeTrue(Files.isExecutable(Path.of("/usr/bin/curl")), "there is no curl");
        String port = freePort();
        Path sources = prepare(port);
        Map<String, String> environment = new HashMap<>();
        environment.put("PATH", machine.resolve("bin") + ":" + System.getenv("PATH"));
        environment.put("MACHINE", machine.toString());
        try {
            StringBuilder said = new StringBuilder();
            for (String command : commands(here(Repository.text(GUIDE), port))) {
                var run =
                        ChildProcess.run(
                                sources,
                                environment,
                                Duration.ofMinutes(5),
                                List.of("sh", "-c", command));
                assertEquals(0, run.exit(), () -> command + "\n" + run.out() + run.err() + log());
                note(TOKEN, run.out(), "TOKEN", environment);
                note(COURSE, run.out(), "COURSE", environment);
                said.append(run.out());
            }
            assertTrue(said.toString().contains("ready\n"), said::toString);
            assertTrue(said.toString().contains("2027-03-01T20:00:00"), said::toString);
            assertTrue(
                    said.toString().contains("rasterlab_submissions{state=\"queued\"} 0.0"),
                    said::toString);
            assertTrue(backups() >= 4, backups() + " backups");
        } finally {
            ChildProcess.run(
                    sources,
                    environment,
                    Duration.ofMinutes(2),
                    List.of("sh", "-c", "systemctl stop rasterlab.service"));
        }
    }

    @Test
    @DisplayName("the service forbids what bubblewrap does, so that methods run outside of a box")
    void theServiceLetsBubblewrapWork() {
        String service = Repository.text(GUIDE.resolveSibling("hosting/rasterlab.service"));
        var forbidden =
                service.lines()
                        .filter(line -> KEEPS_BUBBLEWRAP_OUT.contains(line.split("=")[0]))
                        .toList();
        assertEquals(List.of(), forbidden);
        assertTrue(
                service.lines()
                        .filter(line -> line.startsWith("RestrictAddressFamilies="))
                        .allMatch(line -> line.contains("AF_NETLINK")),
                "it sets up the loopback of the box over netlink");
    }

    @Test
    @DisplayName("systemd takes an end that it asked for itself for a failure")
    void anEndBySignalIsNoFailure() throws Exception {
        try (var server = ServerProcess.start(machine.resolve("course"))) {
            server.process().destroy();
            int exit = server.process().waitFor();
            String service = Repository.text(GUIDE.resolveSibling("hosting/rasterlab.service"));
            assertTrue(
                    service.lines().anyMatch(("SuccessExitStatus=" + exit)::equals),
                    () -> "it ends with " + exit);
        }
    }

    @Test
    @DisplayName("HOSTING.md names a file that is not there")
    void everyLinkLeadsSomewhere() {
        var links = LINK.matcher(Repository.text(GUIDE)).results().map(one -> one.group(1));
        var missing =
                links.filter(one -> !Files.exists(GUIDE.resolveSibling(one))).collect(joining(" "));
        assertEquals("", missing);
    }

    /** The folder in which the guide's reader stands. */
    private Path prepare(String port) throws IOException {
        Path sources = Files.createDirectories(machine.resolve("sources"));
        Path hosting = Files.createDirectories(sources.resolve("grader/hosting"));
        for (String name : FILES) {
            String text = Repository.text(GUIDE.resolveSibling("hosting").resolve(name));
            if (name.equals("server.yaml")) text += "\njava-images: " + ServerProcess.IMAGES + "\n";
            Files.writeString(hosting.resolve(name), here(text, port));
        }
        Files.createDirectories(machine.resolve("etc/caddy"));
        Files.createDirectories(machine.resolve("etc/systemd/system"));
        Files.createDirectories(machine.resolve("opt"));
        Files.createDirectories(machine.resolve("var/lib/rasterlab-backups"));
        for (String name : STAND_INS) {
            try (var script = HostingTest.class.getResourceAsStream("hosting/" + name)) {
                program(machine.resolve("bin").resolve(name), new String(script.readAllBytes()));
            }
        }
        program(sources.resolve("lab"), lab());
        return sources;
    }

    /** The server of this build, called as ./lab calls it. */
    private static String lab() {
        String java =
                JavaCommand.of(ChildProcess.SHORT_LIVED, "rasterlab.grader.MainKt", List.of())
                        .stream()
                        .map(word -> "'" + word + "'")
                        .collect(joining(" "));
        return "#!/bin/sh\nshift\nexec " + java + " \"$@\"\n";
    }

    private static void program(Path file, String text) throws IOException {
        Files.createDirectories(file.getParent());
        Files.writeString(file, text);
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwxr-xr-x"));
    }

    /** The text with the folders of the machine and the server's port moved. */
    private String here(String text, String port) {
        return text.replace("8080", port)
                .replaceAll(
                        "(?<![\\w.])/(opt|etc|var/lib)/",
                        Matcher.quoteReplacement(machine.toString()) + "/$1/");
    }

    private static List<String> commands(String text) {
        return Pattern.compile("(?ms)^```sh\\n(.*?)^```")
                .matcher(text)
                .results()
                .flatMap(block -> block.group(1).lines())
                .toList();
    }

    private static void note(
            Pattern what, String said, String name, Map<String, String> environment) {
        var found = what.matcher(said);
        if (found.find() && !environment.containsKey(name)) environment.put(name, found.group(1));
    }

    private long backups() throws IOException {
        try (Stream<Path> files = Files.list(machine.resolve("var/lib/rasterlab-backups"))) {
            return files.count();
        }
    }

    private String log() {
        Path log = machine.resolve("service.log");
        return Files.exists(log) ? "\n" + Repository.text(log) : "";
    }

    private static String freePort() throws IOException {
        try (var socket = new ServerSocket(0)) {
            return String.valueOf(socket.getLocalPort());
        }
    }
}
