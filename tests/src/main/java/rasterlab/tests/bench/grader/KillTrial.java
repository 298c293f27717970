package rasterlab.tests.bench.grader;

import java.io.IOException;
import java.nio.file.Path;
import java.sql.SQLException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Collectors;
import rasterlab.tests.bench.language.BenchWords;

/**
 * A course on PostgreSQL that is handed in while servers, workers, their children and the database
 * are killed at random. Each result is compared with that of the same source before.
 */
final class KillTrial {
    private static final String DATABASE = "kills";
    private static final int SUBMISSIONS = 500;
    private static final int KILLS = 200;
    private static final int QUICK = 10;

    /** Submissions that are handed in before a result is waited for. */
    private static final int AHEAD = 12;

    /** Submissions of one student. */
    private static final int EACH = 10;

    /** Kills out of so many that are those of the database, and those of a child. */
    private static final int OUT_OF = 20;

    private static final int OF_DATABASE = 2;
    private static final int OF_CHILD = 5;

    private static final int LONGEST_PAUSE_MILLIS = 500;
    private static final long LOOK_MILLIS = 100;
    private static final long PATIENCE_NANOS = TimeUnit.MINUTES.toNanos(5);
    private static final Duration ANSWER_LIMIT = Duration.ofSeconds(30);
    private static final int MOST_DIFFERENCES = 5;

    private final int submissions;
    private final int kills;
    private final BenchWords words;
    private final MeasuredLines out;
    private final ProgressLines progress;
    private final long seed;
    private final Random random;
    private final Map<String, Integer> killed = new LinkedHashMap<>();
    private final AtomicInteger made = new AtomicInteger();

    /**
     * @param seed of what is killed when
     */
    KillTrial(boolean quick, long seed, BenchWords words, MeasuredLines out) {
        this.seed = seed;
        random = new Random(seed);
        submissions = quick ? SUBMISSIONS / QUICK : SUBMISSIONS;
        kills = quick ? KILLS / QUICK : KILLS;
        this.words = words;
        this.out = out;
        progress = new ProgressLines(out);
    }

    /**
     * Prints what came of it, or why it was not measured.
     *
     * @param home folder of the program
     */
    void run(Path home) throws IOException, InterruptedException, SQLException {
        try (var belongings = new Belongings()) {
            OwnPostgres postgres = OwnPostgres.start(belongings);
            postgres.create(DATABASE);
            BenchFolder folder = belongings.add(BenchFolder::make);
            folder.keepingLogs(
                    () ->
                            run(
                                    postgres,
                                    new ProcessHerd(
                                            home, folder, postgres.address(DATABASE), belongings)));
        } catch (NotMeasured missing) {
            String name = words.text("grader.kills");
            out.println(words.text("grader.unmeasured", name, missing.in(words)));
        }
    }

    private void run(OwnPostgres postgres, ProcessHerd herd)
            throws IOException, InterruptedException, SQLException {
        GraderHttp http = GraderHttp.of(herd.server(0)).within(ANSWER_LIMIT);
        String code = http.newCourse(herd.instructor()).path("code").asText();
        var students = new ArrayList<String>();
        for (int k = 0; k < submissions / EACH; k++) students.add(http.join(code, "Student " + k));
        List<String> sources = BenchSources.mixed();
        List<GradedOutcome> undisturbed = undisturbed(http, students.get(0), sources);
        out.println(
                words.text(
                        "grader.kills.begin",
                        String.valueOf(submissions),
                        String.valueOf(kills),
                        String.valueOf(seed),
                        String.join("; ", undisturbed.stream().map(GradedOutcome::text).toList())));
        var repeated = new AnswerCounts(words.text("grader.silent"));
        var handIns = new HandIns(herd, http, planned(students, sources), this::allowed, repeated);
        List<HandIns.HandedIn> handed = killMeanwhile(postgres, herd, handIns, undisturbed.size());
        out.println(words.text("grader.kills.made", kinds(), repeated.text()));
        tell(http.at(herd.server(0)), handed, undisturbed, postgres.jdbc(DATABASE));
    }

    /** Each student hands in each source in turn; the texts differ. */
    private List<HandIns.PlannedHandIn> planned(List<String> students, List<String> sources) {
        var planned = new ArrayList<HandIns.PlannedHandIn>();
        for (int number = 0; number < submissions; number++) {
            int kind = number % sources.size();
            String text = BenchSources.marked(sources.get(kind), number);
            String student = students.get(number % students.size());
            planned.add(new HandIns.PlannedHandIn(student, text, kind));
        }
        return planned;
    }

    private static List<GradedOutcome> undisturbed(
            GraderHttp http, String student, List<String> sources)
            throws IOException, InterruptedException {
        var outcomes = new ArrayList<GradedOutcome>();
        for (String source : sources) {
            var answer = http.submit(student, BenchSources.EXERCISE, source);
            outcomes.add(GradedOutcome.of(http.graded(student, GraderHttp.id(answer))));
        }
        return outcomes;
    }

    /** How many may have been handed in by now, so that something waits until the last kill. */
    private int allowed() {
        return Math.min(submissions, AHEAD + due(made.get()));
    }

    /** The submissions that come before the kill of that number. */
    private int due(int kill) {
        return (int) ((long) kill * (submissions - AHEAD) / kills);
    }

    /**
     * @param before submissions that were graded before
     */
    private List<HandIns.HandedIn> killMeanwhile(
            OwnPostgres postgres, ProcessHerd herd, HandIns handIns, int before)
            throws IOException, InterruptedException, SQLException {
        ExecutorService students = Executors.newSingleThreadExecutor();
        try {
            Future<List<HandIns.HandedIn>> handing = students.submit(handIns);
            for (int kill = 0; kill < kills; kill++) {
                awaitGraded(before + due(kill), postgres, handing);
                TimeUnit.MILLISECONDS.sleep(random.nextInt(LONGEST_PAUSE_MILLIS));
                kill(postgres, herd);
                made.incrementAndGet();
                tellProgress(StoredCounts.in(postgres.jdbc(DATABASE)).graded());
            }
            awaitGraded(before + submissions, postgres, handing);
            return got(handing);
        } finally {
            students.shutdownNow();
        }
    }

    private void kill(OwnPostgres postgres, ProcessHerd herd)
            throws IOException, InterruptedException {
        // where there is no child more is drawn, which must not change the kills that follow
        var ofKill = new Random(random.nextLong());
        int which = ofKill.nextInt(OUT_OF);
        if (which < OF_DATABASE) {
            postgres.kill();
            postgres.start();
            count("database");
        } else if (which < OF_DATABASE + OF_CHILD && herd.killChild(ofKill)) {
            count("child");
        } else {
            String name = ProcessHerd.NAMES.get(ofKill.nextInt(ProcessHerd.NAMES.size()));
            herd.killAndStart(name);
            count(ProcessHerd.isServer(name) ? "server" : "worker");
        }
    }

    private void count(String what) {
        killed.merge(what, 1, Integer::sum);
    }

    /** How many of each kind were killed. */
    private String kinds() {
        return killed.entrySet().stream()
                .map(one -> words.text("grader.kills." + one.getKey(), one.getValue().toString()))
                .collect(Collectors.joining(", "));
    }

    private void awaitGraded(
            int least, OwnPostgres postgres, Future<List<HandIns.HandedIn>> handing)
            throws IOException, InterruptedException, SQLException {
        long lastMove = System.nanoTime();
        int last = -1;
        while (true) {
            int now = StoredCounts.in(postgres.jdbc(DATABASE)).graded();
            if (now >= least) return;
            // hand-ins that failed tell why
            if (handing.isDone()) got(handing);
            if (now != last) lastMove = System.nanoTime();
            if (System.nanoTime() - lastMove > PATIENCE_NANOS)
                throw new IOException("no result for minutes; there are " + now + ", seed " + seed);
            last = now;
            tellProgress(now);
            TimeUnit.MILLISECONDS.sleep(LOOK_MILLIS);
        }
    }

    private void tellProgress(int graded) {
        progress.tell(
                words.text(
                        "grader.kills.progress",
                        String.valueOf(made),
                        String.valueOf(kills),
                        String.valueOf(graded),
                        String.valueOf(submissions)));
    }

    private static <T> T got(Future<T> one) throws InterruptedException, IOException {
        try {
            return one.get();
        } catch (ExecutionException failed) {
            throw new IOException("handing in failed", failed.getCause());
        }
    }

    private void tell(
            GraderHttp http,
            List<HandIns.HandedIn> handed,
            List<GradedOutcome> undisturbed,
            String database)
            throws IOException, InterruptedException, SQLException {
        var expected = new LinkedHashMap<String, GradedOutcome>();
        var found = new LinkedHashMap<String, GradedOutcome>();
        for (HandIns.HandedIn one : handed) {
            expected.put(one.id(), undisturbed.get(one.source()));
            found.put(one.id(), GradedOutcome.of(http.result(one.student(), one.id())));
        }
        List<String> differences = GradedOutcome.differences(expected, found);
        StoredCounts stored = StoredCounts.in(database);
        int all = submissions + undisturbed.size();
        boolean once = stored.equals(new StoredCounts(0, all, 0)) && expected.size() == submissions;
        out.println(
                words.text(
                        "grader.kills.results",
                        String.valueOf(found.size()),
                        met(once),
                        String.valueOf(submissions - differences.size()),
                        met(once && differences.isEmpty())));
        differences.stream().limit(MOST_DIFFERENCES).forEach(line -> out.println("  " + line));
        if (!once) out.println("  " + stored);
    }

    private String met(boolean is) {
        return words.text(is ? "yes" : "no");
    }
}
