package rasterlab.tests.bench.grader;

import java.io.IOException;
import java.net.http.HttpResponse;
import java.sql.SQLException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import rasterlab.tests.bench.language.BenchWords;

/**
 * A fault that comes to a server while submissions wait and are graded: what it answers meanwhile,
 * how soon it works again, and whether each submission that it accepted has one result.
 */
final class FaultTrial {
    private static final double GOAL_RECOVERED = 10;
    private static final int WAITING = 12;
    private static final int FEW = 5;
    private static final Duration LASTS = Duration.ofSeconds(15);
    private static final Duration LASTS_QUICK = Duration.ofSeconds(5);

    /** A fault that each answer waits for lasts longer, so that there are some. */
    private static final int LEAST_ANSWERS = 2;

    private static final Duration ANSWER_LIMIT = Duration.ofSeconds(30);
    private static final long PATIENCE_NANOS = TimeUnit.MINUTES.toNanos(3);
    private static final long PAUSE_MILLIS = 20;
    private static final long PAUSE_BETWEEN_MILLIS = 250;

    private final String name;
    private final ServerFault fault;
    private final BenchServer server;
    private final BenchWords words;
    private final MeasuredLines out;
    private final String student;
    private final GraderHttp http;
    private final List<String> accepted = new ArrayList<>();
    private final List<Integer> refused = new ArrayList<>();
    private int handed;

    /**
     * @param name of the fault, in words
     * @param server that was started as the fault needs it
     */
    FaultTrial(
            String name, ServerFault fault, BenchServer server, BenchWords words, MeasuredLines out)
            throws IOException, InterruptedException {
        this.name = name;
        this.fault = fault;
        this.server = server;
        this.words = words;
        this.out = out;
        student = server.join("Student");
        http = server.http().within(ANSWER_LIMIT);
    }

    /** Runs it once and prints what it did. */
    void run(boolean quick) throws IOException, InterruptedException, SQLException, NotMeasured {
        int waiting = quick ? FEW : WAITING;
        for (int k = 0; k < waiting; k++) {
            int status = handIn().statusCode();
            if (status != GraderHttp.ACCEPTED)
                throw new IOException("before the fault a hand-in is answered with " + status);
        }
        server.graded(student, accepted.get(0));
        int left = StoredCounts.in(fault.database()).ungraded();
        fault.begin(server);
        say("grader.fault.begins", String.valueOf(left));
        boolean excused = meanwhile(quick ? LASTS_QUICK : LASTS);
        fault.end();
        int before = StoredCounts.in(fault.database()).graded();
        recover(before, excused);
        for (int number : refused) expectAccepted(submit(number));
        awaitResults();
        tellKept();
    }

    /** Hands in for a while, and returns whether each failure told when to come again. */
    private boolean meanwhile(Duration lasts) throws InterruptedException {
        var taken = new AnswerCounts(words.text("grader.silent"));
        var ready = new AnswerCounts(words.text("grader.silent"));
        long end = System.nanoTime() + lasts.toNanos();
        while (System.nanoTime() < end || taken.total() < LEAST_ANSWERS) {
            try {
                ready.add(http.ready());
            } catch (IOException unanswered) {
                ready.addSilence();
            }
            int number = handed;
            try {
                HttpResponse<String> answer = handIn();
                taken.add(answer);
                if (answer.statusCode() != GraderHttp.ACCEPTED) refused.add(number);
            } catch (IOException unanswered) {
                taken.addSilence();
                refused.add(number);
            }
            TimeUnit.MILLISECONDS.sleep(PAUSE_BETWEEN_MILLIS);
        }
        say("grader.fault.meanwhile", taken.text(), ready.text());
        boolean takenExcused = isExcused("grader.fault.unexcused", taken);
        boolean readyExcused = isExcused("grader.fault.unready", ready);
        return takenExcused && readyExcused;
    }

    private boolean isExcused(String key, AnswerCounts answers) {
        String unexcused = answers.unexcusedText();
        if (!unexcused.isEmpty()) say(key, unexcused);
        return unexcused.isEmpty();
    }

    private HttpResponse<String> handIn() throws IOException, InterruptedException {
        HttpResponse<String> answer = submit(handed++);
        if (answer.statusCode() == GraderHttp.ACCEPTED) accepted.add(GraderHttp.id(answer));
        return answer;
    }

    /** Hands in what has that number, which a server that has it already does not take twice. */
    private HttpResponse<String> submit(int number) throws IOException, InterruptedException {
        String source = BenchSources.marked(BenchSources.right(), number);
        return http.submit(student, BenchSources.EXERCISE, source, "number-" + number);
    }

    private void expectAccepted(HttpResponse<String> answer) throws IOException {
        if (answer.statusCode() != GraderHttp.ACCEPTED)
            throw new IOException("what was refused is refused again: " + answer.body());
        accepted.add(GraderHttp.id(answer));
    }

    /**
     * @param before submissions that were graded when the fault ended
     * @param excused whether each failure meanwhile told when to come again
     */
    private void recover(int before, boolean excused) throws InterruptedException, SQLException {
        long end = System.nanoTime();
        double ready = secondsUntil(end, () -> http.ready().statusCode() == GraderHttp.OK);
        int number = handed;
        double taken =
                secondsUntil(
                        end,
                        () -> {
                            handed = number;
                            return handIn().statusCode() == GraderHttp.ACCEPTED;
                        });
        double graded =
                secondsUntil(end, () -> StoredCounts.in(fault.database()).graded() > before);
        say(
                "grader.fault.over",
                text(ready),
                text(taken),
                String.valueOf(Math.round(GOAL_RECOVERED)),
                met(excused && Math.max(ready, taken) <= GOAL_RECOVERED),
                text(graded));
    }

    /** Says whether something is so by now; an exception says no. */
    private interface Look {
        boolean isSo() throws IOException, InterruptedException, SQLException;
    }

    /** Seconds from a moment until something is so; without end where it is not for minutes. */
    private static double secondsUntil(long since, Look look) throws InterruptedException {
        while (System.nanoTime() - since < PATIENCE_NANOS) {
            if (isSo(look)) return (System.nanoTime() - since) / 1e9;
            TimeUnit.MILLISECONDS.sleep(PAUSE_MILLIS);
        }
        return Double.POSITIVE_INFINITY;
    }

    private static boolean isSo(Look look) throws InterruptedException {
        try {
            return look.isSo();
        } catch (IOException | SQLException unanswered) {
            return false;
        }
    }

    /** Returns when all have a result, or none has come for minutes. */
    private void awaitResults() throws InterruptedException, SQLException {
        var progress = new ProgressLines(out);
        int last = -1;
        long lastMove = System.nanoTime();
        while (last < accepted.size() && System.nanoTime() - lastMove < PATIENCE_NANOS) {
            int graded = StoredCounts.in(fault.database()).graded();
            if (graded != last) lastMove = System.nanoTime();
            last = graded;
            progress.tell(
                    words.text(
                            "grader.fault.progress",
                            String.valueOf(graded),
                            String.valueOf(accepted.size())));
            TimeUnit.MILLISECONDS.sleep(PAUSE_BETWEEN_MILLIS);
        }
    }

    /** Says whether each accepted submission has one result. */
    private void tellKept() throws IOException, InterruptedException, SQLException {
        int right = 0;
        for (String id : accepted)
            if (http.result(student, id).path("verdict").asText().equals("ok")) right++;
        StoredCounts stored = StoredCounts.in(fault.database());
        int all = accepted.size();
        say(
                "grader.fault.kept",
                String.valueOf(all),
                String.valueOf(stored.gradedOnce()),
                String.valueOf(stored.ungraded()),
                String.valueOf(stored.gradedMoreOften()),
                String.valueOf(right),
                met(stored.equals(new StoredCounts(0, all, 0)) && right == all));
    }

    private void say(String key, String... arguments) {
        var all = new ArrayList<Object>(List.of(name));
        all.addAll(List.of(arguments));
        out.println(words.text(key, all.toArray()));
    }

    private String met(boolean is) {
        return words.text(is ? "yes" : "no");
    }

    private static String text(double seconds) {
        return String.format(Locale.ROOT, "%.2f", seconds);
    }
}
