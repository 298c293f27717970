package rasterlab.tests.bench.grader;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.UserPrincipalNotFoundException;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * A PostgreSQL server of the machine's package with nothing in it. It refuses to run as root, so it
 * runs as the package's own user then.
 */
final class OwnPostgres implements AutoCloseable {
    private static final Path VERSIONS = Path.of("/usr/lib/postgresql");
    private static final String USER = "rasterlab";
    private static final String OWNER = "postgres";
    private static final long PATIENCE_NANOS = TimeUnit.MINUTES.toNanos(1);
    private static final long PAUSE_MILLIS = 50;

    private final Path programs;
    private final Path folder;
    private final List<String> unprivileged;
    private final int port;
    private Process process;
    private boolean closed;

    private OwnPostgres(Path programs, Path folder, List<String> unprivileged) throws IOException {
        this.programs = programs;
        this.folder = folder;
        this.unprivileged = unprivileged;
        try (var free = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            port = free.getLocalPort();
        }
    }

    /**
     * Starts one.
     *
     * @param belongings which it and its folder are two of
     * @throws NotMeasured where none is installed
     */
    static OwnPostgres start(Belongings belongings)
            throws IOException, InterruptedException, NotMeasured {
        Optional<Path> programs = programs();
        if (programs.isEmpty())
            throw new NotMeasured("grader.missing.postgres", VERSIONS + "/*/bin/initdb");
        Path folder = belongings.add(BenchFolder::make).path();
        List<String> unprivileged = unprivileged(folder);
        OwnPostgres postgres =
                belongings.add(() -> new OwnPostgres(programs.get(), folder, unprivileged));
        SystemCommand.run(
                postgres.call(
                        "initdb",
                        "-D",
                        postgres.data(),
                        "-U",
                        USER,
                        "--auth=trust",
                        "-E",
                        "UTF8",
                        "--locale=C.UTF-8"));
        postgres.start();
        return postgres;
    }

    private static Optional<Path> programs() throws IOException {
        if (!Files.isDirectory(VERSIONS)) return Optional.empty();
        try (Stream<Path> versions = Files.list(VERSIONS)) {
            return versions.map(version -> version.resolve("bin"))
                    .filter(bin -> Files.isExecutable(bin.resolve("initdb")))
                    .findFirst();
        }
    }

    /** The words before a command by which it runs as somebody who may start PostgreSQL. */
    private static List<String> unprivileged(Path folder) throws IOException, NotMeasured {
        if (!System.getProperty("user.name").equals("root")) return List.of();
        try {
            var users = folder.getFileSystem().getUserPrincipalLookupService();
            Files.setOwner(folder, users.lookupPrincipalByName(OWNER));
        } catch (UserPrincipalNotFoundException unknown) {
            throw new NotMeasured("grader.missing.user", OWNER);
        }
        return List.of("setpriv", "--reuid=" + OWNER, "--regid=" + OWNER, "--clear-groups");
    }

    private List<String> call(String program, String... arguments) {
        var call = new ArrayList<>(unprivileged);
        call.add(programs.resolve(program).toString());
        call.addAll(List.of(arguments));
        return call;
    }

    private String data() {
        return folder.resolve("data").toString();
    }

    /** The address of a database as a server of ours is given it. */
    String address(String name) {
        return "postgresql://" + USER + "@127.0.0.1:" + port + "/" + name;
    }

    String jdbc(String name) {
        return "jdbc:postgresql://127.0.0.1:%d/%s?user=%s&connectTimeout=5"
                .formatted(port, name, USER);
    }

    void create(String name) throws SQLException {
        try (Connection connection = DriverManager.getConnection(jdbc(OWNER));
                Statement statement = connection.createStatement()) {
            statement.execute("CREATE DATABASE \"" + name + "\"");
        }
    }

    /** Starts it after {@link #kill}; returns when it takes connections. */
    void start() throws IOException, InterruptedException {
        long end = System.nanoTime() + PATIENCE_NANOS;
        do {
            // what a killed one left in memory keeps the next one from starting for a moment
            begin();
            TimeUnit.MILLISECONDS.sleep(PAUSE_MILLIS);
            if (isReady()) return;
        } while (System.nanoTime() < end);
        throw new IOException("PostgreSQL does not start: " + Files.readString(log()));
    }

    private synchronized void begin() throws IOException {
        if (closed) throw new IOException("PostgreSQL is not needed any more");
        if (process == null || !process.isAlive()) launch();
    }

    private void launch() throws IOException {
        var call =
                call(
                        "postgres",
                        "-D",
                        data(),
                        "-p",
                        String.valueOf(port),
                        "-k",
                        folder.toString(),
                        "-c",
                        "listen_addresses=127.0.0.1");
        process =
                new ProcessBuilder(call)
                        .redirectErrorStream(true)
                        .redirectOutput(ProcessBuilder.Redirect.appendTo(log().toFile()))
                        .start();
    }

    private Path log() {
        return folder.resolve("log");
    }

    private boolean isReady() {
        try (Connection connection = DriverManager.getConnection(jdbc(OWNER))) {
            return connection.isValid(1);
        } catch (SQLException starting) {
            return false;
        }
    }

    /** Ends it with all its processes as a power cut would. */
    synchronized void kill() {
        if (process == null) return;
        List<ProcessHandle> children = process.descendants().toList();
        process.destroyForcibly();
        children.forEach(ProcessHandle::destroyForcibly);
        process.onExit().join();
    }

    /**
     * Ends it in order. One that was killed is started once more for that: it leaves memory behind
     * which only its next start takes away.
     */
    @Override
    public synchronized void close() throws IOException {
        closed = true;
        if (process == null) return;
        if (!process.isAlive()) launch();
        long end = System.nanoTime() + PATIENCE_NANOS;
        while (!isReady() && process.isAlive() && System.nanoTime() < end) Thread.onSpinWait();
        SystemCommand.runAtEnd(
                call("pg_ctl", "-D", data(), "-m", "immediate", "-w", "stop")
                        .toArray(String[]::new));
    }
}
