package rasterlab.tests.bench.grader;

import java.io.IOException;
import java.net.http.HttpResponse;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import java.util.function.IntSupplier;

/** Students who hand in one after the other, and again at the other server where one is dead. */
final class HandIns implements Callable<List<HandIns.HandedIn>> {
    private static final long PATIENCE_NANOS = TimeUnit.MINUTES.toNanos(3);
    private static final long PAUSE_MILLIS = 50;

    private final ProcessHerd herd;
    private final GraderHttp http;
    private final List<String> students;
    private final List<String> sources;
    private final int many;
    private final IntSupplier allowed;
    private final AnswerCounts repeated;

    /**
     * A submission that a server accepted.
     *
     * @param source the number of what was handed in
     */
    record HandedIn(String student, String id, int source) {}

    /**
     * @param http as the answers are waited for
     * @param allowed how many may have been handed in by now, out of {@code many}
     * @param repeated counts the answers after which one was repeated
     */
    HandIns(
            ProcessHerd herd,
            GraderHttp http,
            List<String> students,
            List<String> sources,
            int many,
            IntSupplier allowed,
            AnswerCounts repeated) {
        this.herd = herd;
        this.http = http;
        this.students = students;
        this.sources = sources;
        this.many = many;
        this.allowed = allowed;
        this.repeated = repeated;
    }

    @Override
    public List<HandedIn> call() throws IOException, InterruptedException {
        var all = new ArrayList<HandedIn>();
        while (all.size() < many)
            if (all.size() < allowed.getAsInt()) all.add(handIn(all.size()));
            else TimeUnit.MILLISECONDS.sleep(PAUSE_MILLIS);
        return all;
    }

    private HandedIn handIn(int number) throws IOException, InterruptedException {
        String student = students.get(number % students.size());
        int kind = number % sources.size();
        String source = BenchSources.marked(sources.get(kind), number);
        long start = System.nanoTime();
        for (int turn = number; System.nanoTime() - start < PATIENCE_NANOS; turn++) {
            String id = tryOnce(turn, student, source, "number-" + number);
            if (!id.isEmpty()) return new HandedIn(student, id, kind);
            TimeUnit.MILLISECONDS.sleep(PAUSE_MILLIS);
        }
        throw new IOException("nobody takes submission " + number + ": " + repeated.text());
    }

    /** The id of what was handed in; empty where it was not accepted. */
    private String tryOnce(int turn, String student, String source, String key)
            throws InterruptedException {
        try {
            HttpResponse<String> answer =
                    http.at(herd.server(turn)).submit(student, BenchSources.EXERCISE, source, key);
            if (answer.statusCode() == GraderHttp.ACCEPTED) return GraderHttp.id(answer);
            repeated.add(answer);
        } catch (IOException dead) {
            repeated.addSilence();
        }
        return "";
    }
}
