package rasterlab.tests.bench.grader;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;

/**
 * Servers and workers on one database, which are killed and started again. A server has another
 * address each time.
 */
final class ProcessHerd {
    private static final List<String> SERVERS = List.of("server-a", "server-b");
    private static final List<String> WORKERS = List.of("worker-a", "worker-b", "worker-c");
    static final List<String> NAMES = Stream.concat(SERVERS.stream(), WORKERS.stream()).toList();

    private final Path home;
    private final BenchFolder folder;
    private final String database;
    private final Belongings belongings;
    private final Map<String, LabProcess> running = new ConcurrentHashMap<>();
    private final Map<String, URI> addresses = new ConcurrentHashMap<>();
    private final String instructor;

    /**
     * Starts them all.
     *
     * @param home folder of the program
     * @param folder for the data of each
     * @param database the address that they are given
     */
    ProcessHerd(Path home, BenchFolder folder, String database, Belongings belongings)
            throws IOException {
        this.home = home;
        this.folder = folder;
        this.database = database;
        this.belongings = belongings;
        start(NAMES.get(0));
        // the first makes the tables, and says the token once
        instructor = running.get(NAMES.get(0)).after(BenchServer.TOKEN);
        for (String name : NAMES.subList(1, NAMES.size())) start(name);
    }

    String instructor() {
        return instructor;
    }

    static boolean isServer(String name) {
        return SERVERS.contains(name);
    }

    /** The address of one server or the other, as it was when that started last. */
    URI server(int number) {
        return addresses.get(SERVERS.get(Math.floorMod(number, SERVERS.size())));
    }

    private void start(String name) throws IOException {
        Path data = folder.path().resolve(name);
        LabCall call = isServer(name) ? LabCall.serve(home, data) : LabCall.worker(home, data);
        Path errors = folder.errors(name);
        LabCall shared = call.with("--db", database, "--name", name);
        LabProcess process = belongings.add(() -> LabProcess.start(shared, errors));
        running.put(name, process);
        if (isServer(name)) addresses.put(name, URI.create(process.after(BenchServer.LISTENING)));
        else process.after("grading as ");
    }

    /** Kills the process of that name, and returns when the next one is there. */
    void killAndStart(String name) throws IOException {
        running.get(name).kill();
        start(name);
    }

    /** Kills one of the processes in which sources run, where there is one now. */
    boolean killChild(Random random) {
        List<ProcessHandle> children =
                running.values().stream().flatMap(one -> one.children().stream()).toList();
        if (children.isEmpty()) return false;
        return children.get(random.nextInt(children.size())).destroyForcibly();
    }
}
