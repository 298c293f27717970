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
    private final List<PlannedHandIn> planned;
    private final IntSupplier allowed;
    private final AnswerCounts repeated;

    /**
     * Something that a student will hand in.
     *
     * @param kind the number of the source that the text means
     */
    record PlannedHandIn(String student, String text, int kind) {}

    /**
     * A submission that a server accepted.
     *
     * @param source the number of what was handed in
     */
    record HandedIn(String student, String id, int source) {}

    /**
     * @param http as the answers are waited for
     * @param planned in the order in which they come
     * @param allowed how many of these may have been handed in by now
     * @param repeated counts the answers after which one was repeated
     */
    HandIns(
            ProcessHerd herd,
            GraderHttp http,
            List<PlannedHandIn> planned,
            IntSupplier allowed,
            AnswerCounts repeated) {
        this.herd = herd;
        this.http = http;
        this.planned = List.copyOf(planned);
        this.allowed = allowed;
        this.repeated = repeated;
    }

    @Override
    public List<HandedIn> call() throws IOException, InterruptedException {
        var all = new ArrayList<HandedIn>();
        while (all.size() < planned.size())
            if (all.size() < allowed.getAsInt()) all.add(handIn(all.size()));
            else TimeUnit.MILLISECONDS.sleep(PAUSE_MILLIS);
        return all;
    }

    private HandedIn handIn(int number) throws IOException, InterruptedException {
        PlannedHandIn one = planned.get(number);
        long start = System.nanoTime();
        for (int turn = number; System.nanoTime() - start < PATIENCE_NANOS; turn++) {
            String id = tryOnce(turn, one, "number-" + number);
            if (!id.isEmpty()) return new HandedIn(one.student(), id, one.kind());
            TimeUnit.MILLISECONDS.sleep(PAUSE_MILLIS);
        }
        throw new IOException("nobody takes submission " + number + ": " + repeated.text());
    }

    /** The id of what was handed in; empty where it was not accepted. */
    private String tryOnce(int turn, PlannedHandIn one, String key) throws InterruptedException {
        try {
            HttpResponse<String> answer =
                    http.at(herd.server(turn))
                            .submit(one.student(), BenchSources.EXERCISE, one.text(), key);
            if (answer.statusCode() == GraderHttp.ACCEPTED) return GraderHttp.id(answer);
            repeated.add(answer);
        } catch (IOException dead) {
            repeated.addSilence();
        }
        return "";
    }
}
