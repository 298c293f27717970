package rasterlab.tests.bench.grader;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.net.http.HttpResponse;
import java.nio.file.Path;
import java.sql.SQLException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.OptionalLong;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import rasterlab.tests.bench.language.BenchWords;

/**
 * Loads a grading server of its own from this process: as a class that submits, as a burst, and as
 * students whose methods never end.
 */
final class ServerBench {
    private static final int CLIENTS = 8;
    private static final int CLASS = 200;
    private static final int BURST = 2_000;
    private static final int BOMBS = 20;

    /** A first look has so many times less of everything. */
    private static final int QUICK = 10;

    private static final double GOAL_ACCEPTS = 300;
    private static final double GOAL_DRAINED = 60;
    private static final double GOAL_BURST_DRAINED = 600;
    private static final double GOAL_PAGE = 0.5;
    private static final long GOAL_MEMORY = 400;
    private static final int GOAL_LEAD = 1;
    private static final double GOAL_RECOVERED = 10;

    private static final int SOCKETS = 10_000;
    private static final long PATIENCE_NANOS = TimeUnit.MINUTES.toNanos(1);
    private static final long PAUSE_MILLIS = 50;

    private final boolean quick;
    private final BenchWords words;
    private final MeasuredLines out;
    private final String right = BenchSources.right();

    ServerBench(boolean quick, BenchWords words, MeasuredLines out) {
        this.quick = quick;
        this.words = words;
        this.out = out;
    }

    /**
     * Prints what each load did to the server.
     *
     * @param home folder of the program
     * @param loads in whose order they come
     */
    void run(Path home, Collection<GraderPart> loads)
            throws IOException, InterruptedException, SQLException {
        try (var belongings = new Belongings()) {
            BenchFolder folder = belongings.add(BenchFolder::make);
            folder.keepingLogs(
                    () -> {
                        LabCall call = LabCall.serve(home, folder.path().resolve("course"));
                        put(loads, BenchServer.start(call, folder, belongings));
                    });
        }
    }

    private void put(Collection<GraderPart> loads, BenchServer server)
            throws IOException, InterruptedException {
        List<String> students = new ArrayList<>();
        for (int k = 0; k < some(CLASS); k++) students.add(server.join("Student " + k));
        for (GraderPart load : loads) {
            put(load, server, students);
            memory(server);
        }
    }

    private void put(GraderPart load, BenchServer server, List<String> students)
            throws IOException, InterruptedException {
        switch (load) {
            case CLASS -> wave(server, students, 1, "grader.class", GOAL_DRAINED);
            case BOMBS -> bombs(server, students);
            case SOCKETS -> sockets(server);
            case BURST -> burst(server, students);
            default -> throw new IllegalArgumentException("no load: " + load);
        }
    }

    private int some(int all) {
        return quick ? all / QUICK : all;
    }

    /** The answer to one submission. */
    private record Sent(String student, HttpResponse<String> answer) {
        boolean isAccepted() {
            return answer.statusCode() == GraderHttp.ACCEPTED;
        }

        boolean isToldToWait() {
            return answer.statusCode() == 503
                    && answer.headers().firstValue("Retry-After").isPresent();
        }
    }

    private void burst(BenchServer server, List<String> students)
            throws IOException, InterruptedException {
        List<Long> pages = Collections.synchronizedList(new ArrayList<>());
        var over = new AtomicBoolean();
        ExecutorService reader = Executors.newSingleThreadExecutor();
        Future<Void> reading =
                reader.submit(
                        () -> {
                            while (!over.get())
                                for (String page : server.pages()) pages.add(server.page(page));
                            return null;
                        });
        try {
            wave(server, students, BURST / CLASS, "grader.burst", GOAL_BURST_DRAINED);
        } finally {
            over.set(true);
            reader.shutdown();
            reader.awaitTermination(1, TimeUnit.MINUTES);
        }
        got(reading);
        pages.sort(null);
        long slow = pages.get(pages.size() * 99 / 100);
        out.println(
                words.text(
                        "grader.pages",
                        seconds(slow),
                        String.valueOf(pages.size()),
                        String.valueOf(GOAL_PAGE),
                        met(slow <= GOAL_PAGE * 1e9)));
    }

    /** All submit as fast as {@value #CLIENTS} clients can, and wait for their results. */
    private void wave(BenchServer server, List<String> students, int each, String key, double goal)
            throws InterruptedException, IOException {
        List<Callable<Sent>> work = new ArrayList<>();
        for (int k = 0; k < each; k++)
            for (String student : students) {
                // sources that differ are not one that was sent twice
                String source = BenchSources.marked(right, k);
                work.add(
                        () ->
                                new Sent(
                                        student,
                                        server.submit(student, BenchSources.EXERCISE, source)));
            }
        long start = System.nanoTime();
        List<Sent> sent = all(work);
        long accepted = System.nanoTime() - start;
        List<Sent> taken = sent.stream().filter(Sent::isAccepted).toList();
        long refused = sent.stream().filter(Sent::isToldToWait).count();
        double rate = taken.size() / (accepted / 1e9);
        out.println(
                words.text(
                        "grader.accepted",
                        words.text(key),
                        String.valueOf(sent.size()),
                        String.valueOf(CLIENTS),
                        seconds(accepted),
                        String.valueOf(Math.round(rate)),
                        String.valueOf(Math.round(GOAL_ACCEPTS)),
                        met(rate >= GOAL_ACCEPTS),
                        String.valueOf(taken.size()),
                        String.valueOf(refused),
                        String.valueOf(sent.size() - taken.size() - refused)));
        List<Callable<JsonNode>> results = new ArrayList<>();
        for (Sent one : taken)
            results.add(() -> server.graded(one.student(), GraderHttp.id(one.answer())));
        List<JsonNode> told = all(results);
        long drained = System.nanoTime() - start;
        long graded =
                told.stream()
                        .filter(one -> "ok".equalsIgnoreCase(one.path("verdict").asText()))
                        .count();
        out.println(
                words.text(
                        "grader.drained",
                        words.text(key),
                        String.valueOf(graded),
                        String.valueOf(taken.size()),
                        seconds(drained),
                        String.valueOf(Math.round(goal)),
                        met(drained <= goal * 1e9 && graded == taken.size())));
        fair(key, taken, told);
    }

    private void fair(String key, List<Sent> taken, List<JsonNode> told) {
        List<FairOrder.TimedResult> order = new ArrayList<>();
        for (int k = 0; k < taken.size(); k++) {
            Instant at = Instant.parse(told.get(k).path("gradedAt").asText());
            order.add(new FairOrder.TimedResult(taken.get(k).student(), at));
        }
        int lead = FairOrder.lead(order);
        out.println(
                words.text(
                        "grader.fair",
                        words.text(key),
                        String.valueOf(lead),
                        String.valueOf(GOAL_LEAD),
                        met(lead <= GOAL_LEAD)));
    }

    /** Thousands of connections from one address that say nothing, and what comes after them. */
    private void sockets(BenchServer server) throws IOException, InterruptedException {
        int wanted = some(SOCKETS);
        int opened;
        int meanwhile;
        try (var idle = IdleConnections.open(server.address(), wanted)) {
            opened = idle.count();
            meanwhile = server.statusFromAnew();
        }
        long end = System.nanoTime();
        while (server.statusFromAnew() != GraderHttp.OK && System.nanoTime() - end < PATIENCE_NANOS)
            TimeUnit.MILLISECONDS.sleep(PAUSE_MILLIS);
        long after = System.nanoTime() - end;
        out.println(
                words.text(
                        "grader.sockets",
                        String.valueOf(wanted),
                        String.valueOf(opened),
                        meanwhile == 0 ? words.text("grader.silent") : String.valueOf(meanwhile),
                        seconds(after),
                        String.valueOf(GOAL_RECOVERED),
                        met(after <= GOAL_RECOVERED * 1e9)));
    }

    /** An honest student alone, and behind students whose methods do not end or eat all memory. */
    private void bombs(BenchServer server, List<String> students)
            throws IOException, InterruptedException {
        String honest = students.get(0);
        double alone = wait(server, honest, 0);
        List<Callable<Sent>> work = new ArrayList<>();
        int many = some(BOMBS);
        for (int k = 0; k < many; k++) {
            String student = students.get(1 + k % (students.size() - 1));
            String bomb = BenchSources.BOMBS.get(k % BenchSources.BOMBS.size());
            work.add(() -> new Sent(student, server.submit(student, BenchSources.EXERCISE, bomb)));
        }
        List<Sent> sent = all(work);
        double beside = wait(server, honest, 1);
        long start = System.nanoTime();
        for (Sent one : sent)
            if (one.isAccepted()) server.graded(one.student(), GraderHttp.id(one.answer()));
        double all = beside + (System.nanoTime() - start) / 1e9;
        out.println(
                words.text(
                        "grader.bombs",
                        String.valueOf(many),
                        number(alone),
                        number(beside),
                        number(all)));
    }

    /** Seconds from submitting to the result. */
    private double wait(BenchServer server, String student, int attempt)
            throws IOException, InterruptedException {
        long start = System.nanoTime();
        var answer = server.submit(student, BenchSources.EXERCISE, right + "// honest " + attempt);
        server.graded(student, GraderHttp.id(answer));
        return (System.nanoTime() - start) / 1e9;
    }

    private void memory(BenchServer server) throws IOException {
        OptionalLong most = server.mostMemory();
        if (most.isEmpty()) return;
        long mega = most.getAsLong();
        out.println(
                words.text(
                        "grader.memory",
                        String.valueOf(mega),
                        String.valueOf(GOAL_MEMORY),
                        met(mega <= GOAL_MEMORY)));
    }

    private static <T> List<T> all(List<Callable<T>> work)
            throws InterruptedException, IOException {
        ExecutorService clients = Executors.newFixedThreadPool(CLIENTS);
        try {
            List<T> results = new ArrayList<>();
            for (Future<T> one : clients.invokeAll(work)) results.add(got(one));
            return results;
        } finally {
            clients.shutdownNow();
        }
    }

    private static <T> T got(Future<T> one) throws InterruptedException, IOException {
        try {
            return one.get();
        } catch (ExecutionException failed) {
            throw new IOException("the server did not answer", failed.getCause());
        }
    }

    private String met(boolean is) {
        return words.text(is ? "yes" : "no");
    }

    private static String seconds(long nanos) {
        return number(nanos / 1e9);
    }

    private static String number(double seconds) {
        return String.format(Locale.ROOT, "%.2f", seconds);
    }
}
